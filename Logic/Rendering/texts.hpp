#pragma once

#include <map>
#include <string>

/// In which words do pictures and reports speak? One table of texts, so that a translation is a file
/// (Resources/texts/en.json).
namespace f2b
{

class Texts
{
public:
  using Table = std::map<std::string, std::string>; ///< key, UTF-8 text with places such as {name}
  explicit Texts(Table table) : m_table(std::move(table)) {}

  /// \throws f2b::Error for a key that the table does not have
  const std::string& operator()(const std::string& key) const;
  /// The text with its places filled; a place without a value stays as it is.
  std::string operator()(const std::string& key, const Table& values) const;
  bool has(const std::string& key) const { return m_table.count(key) > 0; }
  const Table& table() const { return m_table; }

private:
  Table m_table;
};

} // namespace f2b
