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
  f2b::Landmarks landmarks; ///< at rest; empty where the case has none
};

/// Files of the desktop's own in the case folder: the face that is being sculpted, and cuts that are
/// being worked on, beside drawn_*.mrk.json, which are what they are drawn by.
inline constexpr const char* sculptedFileName = "sculpted.vtp";
inline constexpr const char* unfinishedCutsFileName = "unfinished_cuts.json";

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
