#include "Case/virtual_force_case.hpp"

#include "Bridge/markups.hpp"
#include "Core/error.hpp"

namespace f2b
{
namespace
{

using nlohmann::json;

const char* text_of(StiffnessChoice choice)
{
  switch (choice)
  {
  case StiffnessChoice::Given:
    return "given";
  case StiffnessChoice::Met:
    return "residual met";
  case StiffnessChoice::NotMet:
    return "residual not met";
  case StiffnessChoice::NoneNeeded:
    return "no force needed";
  }
  return "";
}

json registration_json(const Registration& registration)
{
  return {{"rms_mm", registration.rms_mm}, {"points", registration.points}};
}

} // namespace

VirtualForceOptions virtual_force_options(const CaseSession& session)
{
  const VirtualForceSettings& settings = session.settings.virtual_force;
  VirtualForceOptions options;
  options.stiffness_n_per_mm3 = settings.stiffness_n_per_mm3;
  options.residual_mm = settings.residual_mm;
  options.rest_length_mm = settings.rest_length_mm;
  options.load = settings.load == "dead" ? VirtualLoad::Dead : VirtualLoad::Following;
  options.equilibrium = equilibrium_options(session.settings);
  if (settings.landmarks.empty())
    return options;
  const Landmarks known = read_landmarks(session.folder.require("landmarks.mrk.json", "segment"));
  for (const std::string& name : settings.landmarks)
  {
    const auto landmark = known.find(name);
    if (landmark == known.end())
      throw Error("'/solver/virtual_force/landmarks'",
                  "there is no landmark '" + name + "' in the case",
                  "use the names in landmarks.mrk.json");
    options.landmarks.push_back({name, landmark->second});
  }
  return options;
}

json force_json(const VirtualForceOptions& options, const VirtualForceResult& dragged)
{
  json force = {{"stiffness_n_per_mm3", dragged.stiffness_n_per_mm3},
                {"stiffness_choice", text_of(dragged.choice)},
                {"rest_length_mm", options.rest_length_mm},
                {"load", options.load == VirtualLoad::Dead ? "dead" : "following"},
                {"residual_mm", dragged.residual_mm},
                {"residual_at_rest_mm", dragged.residual_at_rest_mm},
                {"solves", dragged.solves}};
  if (!options.stiffness_n_per_mm3)
    force["residual_asked_for_mm"] = options.residual_mm;
  return force;
}

json with_registrations(json fragments, const std::vector<FragmentRegistration>& registrations)
{
  for (std::size_t f = 0; f < registrations.size(); ++f)
  {
    json& registration = fragments[f]["registration"];
    registration["surface"] = registration_json(registrations[f].surface);
    if (registrations[f].landmarks)
      registration["landmarks"] = registration_json(*registrations[f].landmarks);
  }
  return fragments;
}

} // namespace f2b
