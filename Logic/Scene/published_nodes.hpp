#pragma once

#include "Case/case_folder.hpp"

#include <string>

class vtkMRMLDisplayNode;
class vtkMRMLModelNode;
class vtkMRMLNode;
class vtkMRMLScene;
class vtkMRMLStorableNode;

/// How is one file of a case shown by one node?
namespace f2b
{

/// How a model looks when it is first shown.
struct ModelLook
{
  double red = 0.9, green = 0.9, blue = 0.9;
  double opacity = 1;
  bool visible = true;
};

/// Adds, updates and removes nodes that other nodes name by a role.
class PublishedNodes
{
public:
  PublishedNodes(const CaseOutlook& files, vtkMRMLScene* scene, bool read_data)
      : m_files(files), m_scene(scene), m_read_data(read_data)
  {
  }

  /// The node of a file, made where there is none yet, or the one that the user chose instead; null
  /// where the case has no such file: a node of an earlier one is then removed.
  /// \param owner, role  who names it
  vtkMRMLStorableNode* show(vtkMRMLNode* owner, const std::string& role, const std::string& file,
                            const char* class_name, const std::string& name, int index = 0);
  vtkMRMLModelNode* show_model(vtkMRMLNode* owner, const std::string& role, const std::string& file,
                               const std::string& name, const ModelLook& look);
  /// Removes what this published under a role, with its display and storage; from the index on.
  void hide(vtkMRMLNode* owner, const std::string& role, int first = 0);
  /// The same for each role that begins so and does not end in one of the names.
  void hide_others(vtkMRMLNode* owner, const std::string& beginning,
                   const std::vector<std::string>& names);
  /// Whether the last node shown was made by that call.
  bool made_new() const { return m_made_new; }

private:
  vtkMRMLStorableNode* make(const char* class_name, const std::string& name);
  void point_to_file(vtkMRMLStorableNode* node, const std::string& file);

  const CaseOutlook& m_files;
  vtkMRMLScene* m_scene;
  bool m_read_data, m_made_new = false;
};

/// Colours a model's point array from blue over white to red, the same number of mm either way.
void show_signed_distances(vtkMRMLModelNode* model, const char* array, double range_mm);

} // namespace f2b
