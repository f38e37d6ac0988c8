#ifndef qFaceToBoneCut_h
#define qFaceToBoneCut_h

#include <Core/geometry/osteotomy_templates.hpp>

#include <nlohmann/json.hpp>

/// What is one cut of a case, as it lies now? For sources of this room only. [mm, RAS]

/// A line that is sawn along, and the points that it is held by.
struct qFaceToBoneCutCurve
{
  f2b::SweptCurve saw;            ///< its points run along the whole line
  std::vector<f2b::Vec3> handles; ///< of a free line, all of the saw's points
  bool onBone = false;            ///< else free: straight from handle to handle
  bool turned = true; ///< the direction is stated; else it is across the bone, as the cut finds it
};

/// One osteotomy.
struct qFaceToBoneCut
{
  std::string fragment, templateName;
  double kerf = 1;
  std::vector<f2b::BoundedPlane> planes;
  std::vector<qFaceToBoneCutCurve> curves;
  f2b::Vec3 point = f2b::Vec3::Zero(); ///< on the piece that is to be free
  bool pointPlaced = false;            ///< by hand or by the file, not by the template
  bool drawn = false;      ///< planes and curves are drawn, not where the template puts them
  nlohmann::json movement; ///< rules, as in the case file; null: free
  std::string problem;     ///< why it cannot be placed; empty: it is

  f2b::Osteotomy osteotomy() const;
  /// Moved or drawn by hand from now on.
  void setDrawn();
};

/// A structure that the saw should spare.
struct qFaceToBoneSpared
{
  std::string name, file;
  bool isCurve = false; ///< a markup, else a surface
  double margin = 2;
};

/// Reads one of a case's osteotomies; where that fails, the cut tells its problem.
qFaceToBoneCut qFaceToBoneReadCut(const nlohmann::json& settings, const f2b::Landmarks& landmarks);
/// The settings of a cut. What is drawn is written to files in a folder, whose names tell contents
/// apart, so that no file that a case rests on is ever changed.
nlohmann::json qFaceToBoneWriteCut(const qFaceToBoneCut& cut, const std::string& folder);
/// Equal for cuts that saw alike.
nlohmann::json qFaceToBoneKeyOf(const qFaceToBoneCut& cut);

std::vector<qFaceToBoneSpared> qFaceToBoneReadSpared(const nlohmann::json& document);
nlohmann::json qFaceToBoneWriteSpared(const std::vector<qFaceToBoneSpared>& spared);

#endif
