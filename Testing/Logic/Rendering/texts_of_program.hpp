#pragma once

#include <Rendering/texts.hpp>

#include <nlohmann/json.hpp>

#include <fstream>

namespace f2b::test
{

/// The English texts, read as the program carries them.
inline const Texts& texts_of_program()
{
  static const Texts texts = []
  {
    std::ifstream file(FACETOBONE_TEXTS);
    return Texts(nlohmann::json::parse(file).get<Texts::Table>());
  }();
  return texts;
}

} // namespace f2b::test
