#ifndef qFaceToBoneCut_h
#define qFaceToBoneCut_h

#include <Core/geometry/osteotomy_templates.hpp>

#include <nlohmann/json.hpp>

/// What is one cut of a case, as it lies now? For sources of this room only. [mm, RAS]

/// A line that is sawn along, and the points that it is held by.
struct qFaceToBoneCutCurve
{
  std::vector<f2b::Vec3> handles;
  std::vector<f2b::Vec3> line; ///< through them: on the bone, or straight from one to the next
  bool onBone = false;         ///< else free: it has no points but its handles
  bool turned = true; ///< the direction is stated; else it is across the bone, as the cut finds it
  /// How far an open line on bone is sawn straight on past its ends [mm]: the bone's border curves
  /// away, and a cut that stops at it leaves a bridge.
  double overrun = 0;
  f2b::SweptCurve saw; ///< its points follow from the rest

  bool runsOn() const { return onBone && !saw.closed; }
  /// Gives the saw its points; to be called after changes of anything else.
  void settle();
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
