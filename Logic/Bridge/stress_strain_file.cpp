#include "Bridge/stress_strain_file.hpp"

#include "Bridge/key_hint.hpp"
#include "Bridge/stress_units.hpp"
#include "Core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

namespace f2b
{
namespace
{

/// How the two columns of a file become deformation and nominal stress.
struct Columns
{
  double scale = 1, offset = 0; ///< deformation = offset + scale * value
  bool true_stress = false;
  double mpa = 1; ///< per unit of the stress column
};

/// Reads the file line by line; its errors name the line.
class Reader
{
public:
  explicit Reader(const std::filesystem::path& path) : m_path(path.string()), m_file(path)
  {
    if (!m_file || std::filesystem::is_directory(path))
      throw Error(m_path, "it cannot be read", "check the path and its permissions");
  }

  bool next_line(std::string& line)
  {
    if (!std::getline(m_file, line))
      return false;
    ++m_line;
    if (m_line == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
      line.erase(0, 3);
    while (!line.empty() && static_cast<unsigned char>(line.back()) <= ' ')
      line.pop_back();
    return true;
  }

  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const
  {
    throw Error(m_path + ":" + std::to_string(m_line), problem, remedy);
  }

private:
  std::string m_path;
  std::ifstream m_file;
  int m_line = 0;
};

std::string trimmed(std::string text)
{
  const auto blank = [](unsigned char c) { return c <= ' '; };
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
  text.erase(std::find_if_not(text.rbegin(), text.rend(), blank).base(), text.end());
  return text;
}

std::vector<std::string> fields(const std::string& line)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true)
  {
    const std::size_t end = line.find_first_of(",;\t", begin);
    parts.push_back(trimmed(line.substr(begin, end - begin)));
    if (end == std::string::npos)
      return parts;
    begin = end + 1;
  }
}

/// `# test: uniaxial`; nothing for any other comment.
std::optional<Loading> stated_test(const std::string& line, const Reader& reader)
{
  const std::string comment = trimmed(line.substr(1));
  if (comment.compare(0, 5, "test:") != 0)
    return std::nullopt;
  const std::string test = trimmed(comment.substr(5));
  if (test == "uniaxial")
    return Loading::Uniaxial;
  if (test == "equibiaxial")
    return Loading::Equibiaxial;
  if (test == "simple-shear")
    return Loading::SimpleShear;
  reader.refuse("the test '" + test + "' is not known",
                hint_for(test, {"uniaxial", "equibiaxial", "simple-shear"}, "tests"));
}

void read_deformation_column(const std::string& name, Loading loading, const Reader& reader,
                             Columns& columns)
{
  const bool shear = loading == Loading::SimpleShear;
  const std::vector<std::string> known =
      shear ? std::vector<std::string>{"shear"}
            : std::vector<std::string>{"stretch", "strain", "strain_percent"};
  if (std::find(known.begin(), known.end(), name) == known.end())
    reader.refuse("the first column is '" + name + "'",
                  hint_for(name, known, shear ? "columns of a simple-shear test" : "columns"));
  if (name == "strain" || name == "strain_percent")
    columns.offset = 1;
  if (name == "strain_percent")
    columns.scale = 0.01;
}

void read_stress_column(const std::string& name, const Reader& reader, Columns& columns)
{
  for (const auto& [kind, is_true] :
       {std::pair{std::string("nominal_stress_"), false}, {std::string("true_stress_"), true}})
    if (name.compare(0, kind.size(), kind) == 0)
    {
      const auto mpa = mpa_per(name.substr(kind.size()));
      if (!mpa)
        reader.refuse("the unit '" + name.substr(kind.size()) + "' is not known",
                      hint_for(name.substr(kind.size()), known_stress_units, "units of stress"));
      columns.true_stress = is_true;
      columns.mpa = *mpa;
      return;
    }
  reader.refuse("the second column is '" + name + "'",
                "name quantity and unit, such as nominal_stress_kPa or true_stress_MPa");
}

Columns read_header(const std::string& line, Loading loading, const Reader& reader)
{
  const auto names = fields(line);
  if (names.size() != 2)
    reader.refuse("the header names " + std::to_string(names.size()) + " columns",
                  "give two, such as stretch,nominal_stress_kPa");
  Columns columns;
  read_deformation_column(names[0], loading, reader, columns);
  read_stress_column(names[1], reader, columns);
  return columns;
}

double number(const std::string& text, const Reader& reader)
{
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    reader.refuse("'" + text + "' is not a number", "write numbers as 1.05, with a decimal point");
  return value;
}

void add_point(const std::string& line, const Columns& columns, const Reader& reader,
               StressCurve& curve)
{
  const auto values = fields(line);
  if (values.size() != 2)
    reader.refuse("it has " + std::to_string(values.size()) + " values instead of two",
                  "give one deformation and one stress a line, with decimal points");
  const double deformation = columns.offset + columns.scale * number(values[0], reader);
  if (curve.loading != Loading::SimpleShear && !(deformation > 0))
    reader.refuse("the stretch is " + std::to_string(deformation),
                  "a stretch is current by rest length, above 0; a strain is above -1");
  double stress = columns.mpa * number(values[1], reader);
  if (columns.true_stress && curve.loading != Loading::SimpleShear)
    stress /= deformation;
  curve.deformation.push_back(deformation);
  curve.stress.push_back(stress);
}

} // namespace

StressCurve read_stress_curve(const std::filesystem::path& path)
{
  Reader reader(path);
  std::optional<Loading> loading;
  std::optional<Columns> columns;
  StressCurve curve;
  curve.source = path.string();
  for (std::string line; reader.next_line(line);)
  {
    if (line.empty())
      continue;
    if (line[0] == '#')
    {
      const auto stated = stated_test(line, reader);
      if (stated && columns)
        reader.refuse("the test is stated after the header", "state it before the header line");
      loading = stated ? stated : loading;
    }
    else if (columns)
      add_point(line, *columns, reader, curve);
    else if (!loading)
      reader.refuse("no line above it states the test",
                    "begin the file with '# test: uniaxial', 'equibiaxial' or 'simple-shear'");
    else
    {
      curve.loading = *loading;
      columns = read_header(line, *loading, reader);
    }
  }
  if (curve.deformation.empty())
    reader.refuse("it holds no points", "give a header line and points under it");
  return curve;
}

} // namespace f2b
