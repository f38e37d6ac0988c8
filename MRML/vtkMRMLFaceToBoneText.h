#ifndef __vtkMRMLFaceToBoneText_h
#define __vtkMRMLFaceToBoneText_h

#include <locale>
#include <sstream>
#include <string>
#include <vector>

/// How do exact numbers and lists look in the XML attributes of our nodes?
///
/// MRML writes numbers with six digits; a plan has to come back as it was, so ours have 17. Lists
/// are joined by ';', with '%' and ';' of their members encoded as MRML encodes them.
namespace vtkMRMLFaceToBoneText
{

inline std::string FromNumbers(const double* values, std::size_t count)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  for (std::size_t i = 0; i < count; ++i)
    text << (i > 0 ? " " : "") << values[i];
  return text.str();
}

inline std::string FromNumber(double value)
{
  return FromNumbers(&value, 1);
}

/// Whether the text holds at least so many numbers; else `values` keeps what it was.
inline bool ToNumbers(const std::string& text, double* values, std::size_t count)
{
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::vector<double> read(count);
  for (double& value : read)
    if (!(words >> value))
      return false;
  for (std::size_t i = 0; i < count; ++i)
    values[i] = read[i];
  return true;
}

inline std::string FromList(const std::vector<std::string>& members)
{
  std::string text;
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    if (i > 0)
      text += ';';
    for (const char c : members[i])
      text += c == '%' ? "%25" : c == ';' ? "%3B" : std::string(1, c);
  }
  return text;
}

/// An empty text is an empty list.
inline std::vector<std::string> ToList(const std::string& text)
{
  std::vector<std::string> members;
  if (text.empty())
    return members;
  members.emplace_back();
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] == ';')
      members.emplace_back();
    else if (text.compare(i, 3, "%3B") == 0 || text.compare(i, 3, "%25") == 0)
    {
      members.back() += text[i + 1] == '3' ? ';' : '%';
      i += 2;
    }
    else
      members.back() += text[i];
  }
  return members;
}

} // namespace vtkMRMLFaceToBoneText

/// Like vtkMRMLWriteXMLFloatMacro, without losing digits.
#define vtkMRMLFaceToBoneWriteXMLExactMacro(xmlAttributeName, propertyName)                        \
  xmlWriteOutputStream << " " #xmlAttributeName "=\""                                              \
                       << vtkMRMLFaceToBoneText::FromNumber(this->Get##propertyName()) << "\"";

#endif
