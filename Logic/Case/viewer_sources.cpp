#include "Case/viewer_sources.hpp"

#include "Bridge/resources.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace f2b
{
namespace
{

constexpr const char* debian_three = "/usr/share/javascript/three/three.min.js";

/// Goes before three.js, whose file does not carry its licence.
constexpr const char* licence =
    "/* three.js, copyright (c) 2010-2019 three.js authors. The MIT License.\n"
    "Permission is hereby granted, free of charge, to any person obtaining a copy of this "
    "software\n"
    "and associated documentation files (the \"Software\"), to deal in the Software without\n"
    "restriction, including without limitation the rights to use, copy, modify, merge, publish,\n"
    "distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom "
    "the\n"
    "Software is furnished to do so, subject to the following conditions: The above copyright\n"
    "notice and this permission notice shall be included in all copies or substantial portions of\n"
    "the Software. THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR\n"
    "IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A\n"
    "PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS "
    "BE\n"
    "LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR\n"
    "OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER\n"
    "DEALINGS IN THE SOFTWARE. */\n";

} // namespace

std::optional<ViewerParts> case_viewer(const PlanScene& scene, const Texts& texts)
{
  const char* named = std::getenv("FACETOBONE_THREE_JS");
  std::ifstream file(named ? named : debian_three, std::ios::binary);
  std::ostringstream library;
  library << file.rdbuf();
  if (!file || library.str().empty())
    return {};
  return report_viewer(scene, texts, licence + library.str(),
                       *carried_resource("viewer/viewer.js"));
}

} // namespace f2b
