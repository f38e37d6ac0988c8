#include <Rendering/subject.hpp>

#include <Core/error.hpp>

#include <algorithm>

namespace f2b
{

namespace
{

// In the order of Subject's values.
const std::vector<std::string>& names()
{
  static const std::vector<std::string> list{"face-before",      "face-target",
                                             "face-predicted",   "face-over-skull-before",
                                             "face-over-skull",  "skull-before",
                                             "skull-planned",    "fragments-before",
                                             "fragments-after",  "intervals",
                                             "distance-map",     "reachability",
                                             "regions",          "target-displacement",
                                             "boundary-parts",   "contact-surfaces",
                                             "contact-distance", "morph",
                                             "ct-axial",         "ct-coronal",
                                             "ct-sagittal"};
  return list;
}

} // namespace

std::string name_of(Subject subject)
{
  return names().at(static_cast<std::size_t>(subject));
}

const std::vector<Subject>& all_subjects()
{
  static const std::vector<Subject> subjects = []
  {
    std::vector<Subject> all;
    for (std::size_t i = 0; i < names().size(); ++i)
    {
      all.push_back(static_cast<Subject>(i));
    }
    return all;
  }();
  return subjects;
}

Subject require_subject(const std::string& name)
{
  const auto found = std::find(names().begin(), names().end(), name);
  if (found == names().end())
  {
    std::string known;
    for (const std::string& one : names())
    {
      known += (known.empty() ? "" : ", ") + one;
    }
    throw Error("show", "'" + name + "' is none", "name one of " + known);
  }
  return static_cast<Subject>(found - names().begin());
}

bool is_ct_slice(Subject subject)
{
  return subject == Subject::CtAxial || subject == Subject::CtCoronal ||
         subject == Subject::CtSagittal;
}

} // namespace f2b
