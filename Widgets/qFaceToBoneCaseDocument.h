#ifndef qFaceToBoneCaseDocument_h
#define qFaceToBoneCaseDocument_h

#include "qFaceToBoneCase.h"

#include <Core/geometry/osteotomy_templates.hpp>
#include <Core/geometry/scalar_grid.hpp>
#include <Core/sculpting/brush.hpp>

#include <nlohmann/json.hpp>

#include <optional>

/// The settings of a case and the file that they were read from. For the case's own sources only.
struct qFaceToBoneCase::Document
{
  nlohmann::json json;
  std::string source;
  f2b::Landmarks landmarks;                  ///< at rest; empty where the case has none
  std::optional<f2b::SymmetryPlane> guessed; ///< of the skin that is loaded, once it was asked for
};

struct qFaceToBoneCase::Drag
{
  std::vector<f2b::Vec3> from; ///< the point, and its partner on the other side
  std::optional<f2b::SymmetryPlane> mirror;
};

/// Files of the desktop's own in the case folder: the face that is being sculpted, landmarks
/// and rulers placed by hand, and cuts that are being worked on, beside drawn_*.mrk.json, which are what they are drawn by.
inline constexpr const char* sculptedFileName = "sculpted.vtp";
inline constexpr const char* unfinishedCutsFileName = "unfinished_cuts.json";
inline constexpr const char* placedLandmarksFileName = "placed_landmarks.mrk.json";
inline constexpr const char* rulersFileName = "rulers.mrk.json";

/// Objects that show a CT in which nothing has been found yet.
inline constexpr const char* rawSkinKey = "raw/skin";
inline constexpr const char* rawBoneKey = "raw/bone";

vtkSmartPointer<vtkImageData> qFaceToBoneImageOf(const f2b::ScalarGrid& grid);

template <class Action>
bool qFaceToBoneCase::attempt(Action action)
{
  try
  {
    action();
    m_error.clear();
    return true;
  }
  catch (const std::exception& error)
  {
    return fail(QString::fromUtf8(error.what()));
  }
}

#endif
