#ifndef qFaceToBoneCaseDocument_h
#define qFaceToBoneCaseDocument_h

#include "qFaceToBoneCase.h"

#include <Core/geometry/osteotomy_templates.hpp>

#include <nlohmann/json.hpp>

/// The settings of a case and the file that they were read from. For the case's own sources only.
struct qFaceToBoneCase::Document
{
  nlohmann::json json;
  std::string source;
  f2b::Landmarks landmarks;              ///< at rest; empty where the case has none
  std::vector<f2b::BoundedPlane> planes; ///< of the cut as they lie now
  f2b::Vec3 fragmentPoint = f2b::Vec3::Zero();
  bool planesEdited = false; ///< moved by hand since the template placed them

  nlohmann::json& osteotomy() { return json.at("osteotomies").at(0); }
};

/// Files of the desktop's own in the case folder: the face that is being sculpted, planes moved by
/// hand.
inline constexpr const char* sculptedFileName = "sculpted.vtp";
inline constexpr const char* drawnPlanesFileName = "drawn_planes.mrk.json";

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
