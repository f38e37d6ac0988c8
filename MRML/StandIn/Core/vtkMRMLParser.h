#pragma once

#include "vtkMRML.h"

#include <vtkSmartPointer.h>
#include <vtkXMLParser.h>

#include <string>

class vtkCollection;
class vtkMRMLNode;
class vtkMRMLScene;

/// Which nodes does a scene file hold? One for each element right below the root, <MRML>; an element
/// of no registered class becomes a vtkMRMLUnknownNode, and what lies deeper stays text of its node.
class VTK_MRML_EXPORT vtkMRMLParser : public vtkXMLParser
{
public:
  static vtkMRMLParser* New();
  vtkTypeMacro(vtkMRMLParser, vtkXMLParser);
  vtkMRMLScene* GetMRMLScene() { return this->MRMLScene; }
  void SetMRMLScene(vtkMRMLScene* scene) { this->MRMLScene = scene; }
  vtkCollection* GetNodeCollection() { return this->NodeCollection; }
  void SetNodeCollection(vtkCollection* collection) { this->NodeCollection = collection; }
  /// What was wrong; empty where nothing was.
  const std::string& GetFault() const { return this->Fault; }

protected:
  vtkMRMLParser() = default;
  ~vtkMRMLParser() override = default;
  vtkMRMLParser(const vtkMRMLParser&) = delete;
  void operator=(const vtkMRMLParser&) = delete;

  void StartElement(const char* name, const char** atts) override;
  void EndElement(const char* name) override;
  void CharacterDataHandler(const char* data, int length) override;
  void ReportXmlParseError() override;

private:
  void StartRoot(const std::string& name, const char** atts);
  void StartNode(const std::string& name, const char** atts);

  vtkMRMLScene* MRMLScene = nullptr;
  vtkCollection* NodeCollection = nullptr;
  vtkSmartPointer<vtkMRMLNode> Node; ///< whose element is open
  int Depth = 0;
  std::string Body;
  bool BodyMeans = false; ///< it is more than white space
  std::string Fault;
};
