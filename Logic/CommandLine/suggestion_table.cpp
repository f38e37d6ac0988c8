#include "CommandLine/suggestion_table.hpp"

#include <iomanip>
#include <sstream>

namespace f2b
{
namespace
{

using nlohmann::json;

std::string joined(const json& cuts)
{
  std::string text;
  for (const json& cut : cuts)
    text += (text.empty() ? "" : " + ") + cut.get<std::string>();
  return text;
}

constexpr int cuts_width = 28;

void add_attainment(std::ostream& out, const json& face)
{
  out << std::setw(7) << std::setprecision(0) << 100 * face.at("reached").get<double>() << " %"
      << std::setw(8) << std::setprecision(2) << face.at("rms_left_mm").get<double>() << " mm"
      << std::setw(6) << std::setprecision(0) << 100 * face.at("under_1mm").get<double>() << " %";
}

void add_fragments(std::ostream& out, const json& fragments, const std::string& indent)
{
  bool first = true;
  for (const json& fragment : fragments)
  {
    out << (first ? "  " : "\n" + indent) << fragment.at("name").get<std::string>() << ": "
        << fragment.at("movement").get<std::string>();
    if (fragment.value("at_limit", false))
      out << " (held back by the limit)";
    first = false;
  }
  out << "\n";
}

void add_confirmation(std::ostream& out, const json& confirmed, const std::string& indent)
{
  out << std::setw(6) << "" << std::left << std::setw(cuts_width) << "  full solve:" << std::right;
  if (confirmed.contains("reason"))
  {
    out << "  none: " << confirmed.at("reason").get<std::string>() << "\n";
    return;
  }
  add_attainment(out, confirmed);
  add_fragments(out, confirmed.at("fragments"), indent);
}

} // namespace

std::string suggestion_table(const json& suggestion)
{
  std::ostringstream out;
  out << std::fixed << "What cuts reach of the target (" << std::setprecision(2)
      << suggestion.at("target_rms_mm").get<double>() << " mm RMS), to first order about rest\n"
      << "  rank" << std::left << std::setw(cuts_width) << "  cuts" << std::right << std::setw(9)
      << "reached" << std::setw(11) << "RMS left" << std::setw(8) << "<1 mm"
      << "  movement\n";
  const std::string indent(6 + cuts_width + 9 + 11 + 8 + 2, ' ');
  int rank = 0;
  for (const json& s : suggestion.at("suggestions"))
  {
    out << std::setw(6) << ++rank << std::left << std::setw(cuts_width)
        << "  " + joined(s.at("cuts")) << std::right;
    add_attainment(out, s);
    add_fragments(out, s.at("fragments"), indent);
    if (s.contains("confirmed"))
      add_confirmation(out, s.at("confirmed"), indent);
  }
  for (const json& n : suggestion.at("not_possible"))
    out << (n.at("cuts").size() > 1 ? "Cannot be combined: " : "Not possible here: ")
        << joined(n.at("cuts")) << " (" << n.at("reason").get<std::string>() << ")\n";
  const json& c = suggestion.at("criterion");
  out << std::setprecision(0) << "One more cut must reach "
      << 100 * c.at("cost_of_cut").get<double>()
      << " % more to rank higher; no fragment moves farther than "
      << c.at("largest_translation_mm").get<double>() << " mm or "
      << c.at("largest_rotation_deg").get<double>() << " degrees.\n"
      << std::setprecision(1) << suggestion.at("timing_s").at("total").get<double>()
      << " s. Research software, not a medical device.\n";
  return out.str();
}

} // namespace f2b
