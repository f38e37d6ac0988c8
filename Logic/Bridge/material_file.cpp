#include "Bridge/material_file.hpp"

#include "Bridge/json_file.hpp"
#include "Bridge/key_hint.hpp"
#include "Bridge/resources.hpp"
#include "Bridge/stress_units.hpp"
#include "Core/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

namespace f2b
{
namespace
{

using nlohmann::json;
using Words = std::vector<std::string>;

/// An object of a material file, and how to name it in an error.
struct Entry
{
  const json& object;
  const std::string& source; ///< the file, as the user knows it
  std::string where;         ///< such as "tissues/skin"

  std::string path_of(const std::string& key) const
  {
    return where.empty() ? key : where + "/" + key;
  }
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const
  {
    throw Error(source, problem, remedy);
  }
};

void refuse_unknown_keys(const Entry& entry, const Words& known)
{
  for (const auto& [key, value] : entry.object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      entry.refuse(entry.path_of(key) + " is not a known key", hint_for(key, known));
}

double number(const Entry& entry, const std::string& key)
{
  const auto found = entry.object.find(key);
  if (found == entry.object.end())
    entry.refuse(entry.path_of(key) + " is missing", "give it as a number");
  if (!found->is_number())
    entry.refuse(entry.path_of(key) + " is " + found->dump(), "give it as a number");
  return found->get<double>();
}

/// The value of a key that holds one of the known words.
std::string word(const Entry& entry, const std::string& key, const Words& known)
{
  const auto found = entry.object.find(key);
  std::string all;
  for (const std::string& one : known)
    all += (all.empty() ? "" : ", ") + one;
  if (found == entry.object.end())
    entry.refuse(entry.path_of(key) + " is missing", "give it as one of " + all);
  if (!found->is_string() || std::find(known.begin(), known.end(), *found) == known.end())
    entry.refuse(entry.path_of(key) + " is " + found->dump(), "give it as one of " + all);
  return found->get<std::string>();
}

const std::pair<const char*, VolumetricLaw::Kind> volumetric_laws[] = {
    {"quadratic", VolumetricLaw::Kind::Quadratic},
    {"log", VolumetricLaw::Kind::Logarithmic},
    {"barrier", VolumetricLaw::Kind::Barrier}};

VolumetricLaw::Kind volumetric_law(const Entry& document)
{
  const std::string name = word(document, "volumetric_law", {"quadratic", "log", "barrier"});
  for (const auto& [known, kind] : volumetric_laws)
    if (name == known)
      return kind;
  return VolumetricLaw::Kind::Barrier;
}

using Coefficients = std::array<double, 3>; ///< in the order of the law's keys [MPa]

/// How a law is written in a file.
struct LawForm
{
  const char* name;
  Words keys;
  const char* stiffness; ///< what must be positive
  Law (*make)(const Coefficients& c, double poisson_ratio, VolumetricLaw::Kind kind);
};

template <class Isochoric>
Law with_volume(const Isochoric& law, double poisson_ratio, VolumetricLaw::Kind kind)
{
  return Hyperelastic<Isochoric>{law, {kind, bulk_from(law.shear_modulus(), poisson_ratio)}};
}

Law make_linear(const Coefficients& c, double nu, VolumetricLaw::Kind)
{
  const double mu = c[0] / (2 * (1 + nu));
  return LinearElastic{mu, bulk_from(mu, nu)};
}
Law make_neo_hookean(const Coefficients& c, double nu, VolumetricLaw::Kind kind)
{
  return with_volume(IsochoricNeoHookean{c[0]}, nu, kind);
}
Law make_mooney_rivlin(const Coefficients& c, double nu, VolumetricLaw::Kind kind)
{
  return with_volume(IsochoricMooneyRivlin{c[0], c[1]}, nu, kind);
}
Law make_yeoh(const Coefficients& c, double nu, VolumetricLaw::Kind kind)
{
  return with_volume(IsochoricYeoh{c[0], c[1], c[2]}, nu, kind);
}

const LawForm law_forms[] = {{"linear", {"youngs_modulus"}, "youngs_modulus", make_linear},
                             {"neo-hookean", {"c10"}, "c10", make_neo_hookean},
                             {"mooney-rivlin", {"c10", "c01"}, "c10 + c01", make_mooney_rivlin},
                             {"yeoh", {"c1", "c2", "c3"}, "c1", make_yeoh}};

const LawForm& law_form(const Entry& tissue)
{
  const std::string name = word(tissue, "law", {"linear", "neo-hookean", "mooney-rivlin", "yeoh"});
  return *std::find_if(std::begin(law_forms), std::end(law_forms),
                       [&](const LawForm& form) { return form.name == name; });
}

double poisson_ratio_of(const Entry& tissue)
{
  const double nu = number(tissue, "poisson_ratio");
  if (!(nu > -1) || !(nu <= 0.4999))
    tissue.refuse(tissue.path_of("poisson_ratio") + " is " + tissue.object["poisson_ratio"].dump(),
                  "give a value above -1 and up to 0.4999");
  return nu;
}

Law law_from(const Entry& tissue, const std::string& units, VolumetricLaw::Kind kind)
{
  if (!tissue.object.is_object())
    tissue.refuse(tissue.where + " is missing", "give skin, fat and muscle a law each");
  const LawForm& form = law_form(tissue);
  Words known = {"law", "poisson_ratio", "units", "description", "reference", "fit"};
  known.insert(known.end(), form.keys.begin(), form.keys.end());
  refuse_unknown_keys(tissue, known);
  const std::string own_units =
      tissue.object.contains("units") ? word(tissue, "units", known_stress_units) : units;
  Coefficients c{};
  for (std::size_t i = 0; i < form.keys.size(); ++i)
    c[i] = number(tissue, form.keys[i]) * mpa_per(own_units).value();
  const Law law = form.make(c, poisson_ratio_of(tissue), kind);
  if (!(shear_modulus(law) > 0))
  {
    std::string values;
    for (const std::string& key : form.keys)
      values += (values.empty() ? "" : ", ") + key + " = " + tissue.object[key].dump();
    tissue.refuse(tissue.where + " has " + values,
                  std::string("tissue needs stiffness at rest: ") + form.stiffness + " > 0");
  }
  return law;
}

json document_of(const std::string& path)
{
  if (!std::filesystem::is_regular_file(path))
  {
    std::string names;
    for (const std::string& name : carried_resources("materials/"))
      names += (names.empty() ? "" : ", ") + std::filesystem::path(name).stem().string();
    throw Error(path, "there is no such material file", "give a file, or one of " + names);
  }
  return read_json(path);
}

/// The number with ten digits: what a fit can tell, and short enough to read.
double rounded(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return std::stod(text);
}

void add_coefficients(const LinearElastic& law, nlohmann::ordered_json& entry)
{
  entry["law"] = "linear";
  entry["youngs_modulus"] = rounded(2 * law.shear_modulus * (1 + poisson_ratio(law)));
}
void add_coefficients(const NeoHookean& law, nlohmann::ordered_json& entry)
{
  entry["law"] = "neo-hookean";
  entry["c10"] = rounded(law.isochoric.c10);
}
void add_coefficients(const MooneyRivlin& law, nlohmann::ordered_json& entry)
{
  entry["law"] = "mooney-rivlin";
  entry["c10"] = rounded(law.isochoric.c10);
  entry["c01"] = rounded(law.isochoric.c01);
}
void add_coefficients(const Yeoh& law, nlohmann::ordered_json& entry)
{
  entry["law"] = "yeoh";
  entry["c1"] = rounded(law.isochoric.c1);
  entry["c2"] = rounded(law.isochoric.c2);
  entry["c3"] = rounded(law.isochoric.c3);
}

} // namespace

nlohmann::ordered_json tissue_entry(const Law& law)
{
  nlohmann::ordered_json entry;
  std::visit([&](const auto& one) { add_coefficients(one, entry); }, law);
  entry["poisson_ratio"] = rounded(poisson_ratio(law));
  return entry;
}

MaterialSet read_materials(const std::string& name_or_path)
{
  const std::string* carried = carried_resource("materials/" + name_or_path + ".json");
  const json document = carried ? json::parse(*carried) : document_of(name_or_path);
  const std::string source = carried ? "materials '" + name_or_path + "'" : name_or_path;
  const Entry top{document, source, ""};
  if (!document.is_object())
    top.refuse("it is not a JSON object", "give units, volumetric_law and tissues");
  refuse_unknown_keys(top, {"name", "description", "reference", "units", "volumetric_law",
                            "tissues", "stable_range", "fit"});
  const std::string units = word(top, "units", known_stress_units);
  const VolumetricLaw::Kind kind = volumetric_law(top);
  const json tissues = document.value("tissues", json());
  if (tissues.is_object())
    refuse_unknown_keys({tissues, source, "tissues"}, {"skin", "fat", "muscle"});
  MaterialSet set;
  set.name = document.contains("name") && document["name"].is_string()
                 ? document["name"].get<std::string>()
                 : name_or_path;
  for (const Tissue tissue : {Tissue::Skin, Tissue::Fat, Tissue::Muscle})
  {
    const std::string name = name_of(tissue);
    const json entry = tissues.is_object() ? tissues.value(name, json()) : json();
    set.laws[static_cast<std::size_t>(tissue)] =
        law_from({entry, source, "tissues/" + name}, units, kind);
  }
  return set;
}

} // namespace f2b
