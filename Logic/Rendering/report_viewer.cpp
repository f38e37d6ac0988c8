#include <Rendering/report_viewer.hpp>

#include <Rendering/colour_maps.hpp>
#include <Rendering/framing.hpp>
#include <Rendering/html_text.hpp>
#include <Rendering/map_arrays.hpp>
#include <Rendering/surface_look.hpp>

#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace f2b
{

namespace
{

constexpr const char* origin_array = "origin";

template <class Value>
std::string packed(const std::vector<Value>& values)
{
  std::string bytes(values.size() * sizeof(Value), '\0');
  if (!values.empty())
  {
    std::memcpy(bytes.data(), values.data(), bytes.size()); // little-endian, as browsers read it
  }
  return "\"" + base64(bytes) + "\"";
}

std::string quoted(const std::string& text)
{
  std::string json = "\"";
  for (const char c : text)
  {
    std::array<char, 8> code{};
    if (static_cast<unsigned char>(c) < 0x20 || c == '<') // no markup, whatever it says
    {
      std::snprintf(code.data(), code.size(), "\\u%04x", c);
      json += code.data();
    }
    else
    {
      json += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
  }
  return json + "\"";
}

std::string number(double value)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

template <class Numbers>
std::string list(const Numbers& numbers)
{
  std::string json;
  for (const double value : numbers)
  {
    json += (json.empty() ? "[" : ",") + number(value);
  }
  return json + "]";
}

/// One box for all surfaces, so that one unit of 16 bits is as long everywhere.
struct Quantiser
{
  std::array<double, 3> centre{};
  double unit_mm = 1;

  explicit Quantiser(const std::vector<Surface>& surfaces)
  {
    std::array<double, 6> all{1e30, -1e30, 1e30, -1e30, 1e30, -1e30};
    for (const Surface& surface : surfaces)
    {
      const double* b = surface->GetBounds();
      for (std::size_t i = 0; i < 3; ++i)
      {
        all[2 * i] = std::min(all[2 * i], b[2 * i]);
        all[2 * i + 1] = std::max(all[2 * i + 1], b[2 * i + 1]);
      }
    }
    double half = 1;
    for (std::size_t i = 0; i < 3; ++i)
    {
      centre[i] = 0.5 * (all[2 * i] + all[2 * i + 1]);
      half = std::max(half, 0.5 * (all[2 * i + 1] - all[2 * i]));
    }
    unit_mm = half / 32767;
  }

  std::string positions(const Surface& surface, const std::vector<vtkIdType>& points) const
  {
    std::vector<std::int16_t> values;
    for (const vtkIdType point : points)
    {
      const double* x = surface->GetPoint(point);
      for (std::size_t i = 0; i < 3; ++i)
      {
        values.push_back(static_cast<std::int16_t>(std::lround((x[i] - centre[i]) / unit_mm)));
      }
    }
    return packed(values);
  }
};

std::string triangles(const Surface& surface)
{
  std::vector<std::uint32_t> corners;
  vtkNew<vtkIdList> cell;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    surface->GetCellPoints(c, cell);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      corners.push_back(static_cast<std::uint32_t>(cell->GetId(k)));
    }
  }
  return packed(corners);
}

// 0 where there is no value, else 1 to 255 over the map's range.
std::string map_values(const Surface& surface, const std::vector<vtkIdType>& points, double range)
{
  const std::vector<double> all = point_values(surface, signed_distance_array);
  std::vector<std::uint8_t> values;
  for (const vtkIdType point : points)
  {
    const double value = all[static_cast<std::size_t>(point)];
    const double share = std::clamp(0.5 + 0.5 * value / range, 0.0, 1.0);
    values.push_back(std::isfinite(value) ? static_cast<std::uint8_t>(1 + std::lround(254 * share))
                                          : std::uint8_t{0});
  }
  return packed(values);
}

std::string map_colours(vtkLookupTable* map)
{
  std::vector<std::uint8_t> colours;
  for (vtkIdType i = 0; i < map->GetNumberOfTableValues(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      colours.push_back(static_cast<std::uint8_t>(std::lround(255 * map->GetTableValue(i)[c])));
    }
  }
  return packed(colours);
}

std::string skin_json(const PlanScene& scene, const Quantiser& quantiser, int limit)
{
  const PlanPictures& p = scene.pictures();
  std::vector<vtkIdType> points;
  const Surface shown = decimated(p.skin, limit, points);
  std::string json =
      "{\"index\":" + triangles(shown) + ",\"before\":" + quantiser.positions(p.skin, points);
  if (p.target)
  {
    json += ",\"target\":" + quantiser.positions(p.target, points);
  }
  if (p.predicted)
  {
    json += ",\"predicted\":" + quantiser.positions(p.predicted, points);
  }
  if (scene.has_distance())
  {
    const double range = nice_range(point_values(p.predicted, signed_distance_array), 0.99, 0.5);
    json += ",\"distance\":" + map_values(p.predicted, points, range) +
            ",\"range\":" + number(range) + ",\"map\":" + map_colours(diverging_map(range)) +
            ",\"unknown\":" + list(no_value_colour);
  }
  return json + ",\"colour\":" + list(skin_colour) + "}";
}

std::string bone_json(const Surface& surface, const Quantiser& quantiser, int limit,
                      const Colour& colour)
{
  std::vector<vtkIdType> points;
  const Surface shown = decimated(surface, limit, points);
  return "\"index\":" + triangles(shown) + ",\"position\":" + quantiser.positions(surface, points) +
         ",\"colour\":" + list(colour);
}

std::string bones_json(const PlanScene& scene, const Quantiser& quantiser, int limit)
{
  const PlanPictures& p = scene.pictures();
  std::string json = "[{" + bone_json(p.uncut_bone, quantiser, limit, bone_colour) + "}";
  // the page stays as small with many fragments
  const int fragment_limit = limit / std::max(2, static_cast<int>(p.fragments.size()));
  for (std::size_t f = 0; f < p.fragments.size(); ++f)
  {
    const FragmentPicture& fragment = p.fragments[f];
    json += ",{" + bone_json(fragment.rest, quantiser, fragment_limit, fragment_colour(f)) +
            ",\"name\":" + quoted(fragment.name) + ",\"matrix\":" + list(fragment.matrix_ras) +
            ",\"centre\":" + list(fragment.reference_point_ras) + "}";
  }
  return json + "]";
}

std::string views_json(const Texts& texts)
{
  std::string json;
  for (const View& view : named_views())
  {
    json += (json.empty() ? "[" : ",") + std::string("{\"title\":") +
            quoted(texts("view." + view.name)) + ",\"azimuth\":" + number(view.azimuth_deg) +
            ",\"elevation\":" + number(view.elevation_deg) + "}";
  }
  return json + "]";
}

std::string texts_json(const Texts& texts)
{
  std::string json;
  for (const char* key : {"before", "target", "predicted", "between"})
  {
    json += (json.empty() ? "{" : ",") + quoted(key) + ":" +
            quoted(texts(std::string("viewer.state.") + key));
  }
  return json + "}";
}

std::string option(const std::string& value, const std::string& text)
{
  return "<option value=\"" + value + "\">" + html_escaped(text) + "</option>";
}

std::string controls(const PlanScene& scene, const Texts& texts)
{
  const auto text = [&](const char* key)
  { return html_escaped(texts(std::string("viewer.") + key)); };
  std::string html =
      "<div class=\"controls\">\n<label class=\"slide\">" + text("state") +
      " <input type=\"range\" id=\"viewer-state\" min=\"0\" max=\"2\" "
      "step=\"0.02\" value=\"2\"> <output id=\"viewer-state-text\"></output>"
      "</label>\n<label>" +
      text("view") + " <select id=\"viewer-view\"></select></label>\n<label>" + text("face") +
      " <select id=\"viewer-face\">" + option("solid", texts("viewer.solid")) +
      option("veil", texts("viewer.translucent")) + option("none", texts("viewer.hidden")) +
      "</select></label>\n<label><input type=\"checkbox\" id=\"viewer-bones\" "
      "checked> " +
      text("bones") + "</label>\n";
  if (scene.has_distance())
  {
    html += "<label><input type=\"checkbox\" id=\"viewer-map\"> " + text("map") + "</label>\n";
  }
  return html + "<button type=\"button\" id=\"viewer-play\">" + text("play") +
         "</button>\n</div>\n";
}

std::string viewer_html(const PlanScene& scene, const Texts& texts)
{
  return "<p class=\"note screen\" id=\"viewer-none\">" + html_escaped(texts("viewer.none")) +
         "</p>\n<div class=\"viewer\" id=\"viewer\" hidden>\n<canvas id=\"viewer-canvas\" "
         "tabindex=\"0\" role=\"application\" aria-label=\"" +
         html_escaped(texts("viewer.canvas")) + "\"></canvas>\n" + controls(scene, texts) +
         "<div class=\"scale\" id=\"viewer-scale\" hidden><span id=\"viewer-low\"></span>"
         "<i></i><span id=\"viewer-high\"></span><span>" +
         html_escaped(texts("bar.distance-map")) + "</span></div>\n<p class=\"note keys\">" +
         html_escaped(texts("viewer.keys")) + "</p>\n</div>\n";
}

} // namespace

Surface decimated(const Surface& surface, int triangles, std::vector<vtkIdType>& origins)
{
  auto marked = Surface::New();
  marked->SetPoints(surface->GetPoints());
  marked->SetPolys(surface->GetPolys());
  vtkNew<vtkIdTypeArray> origin;
  origin->SetName(origin_array);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    origin->InsertNextValue(i);
  }
  marked->GetPointData()->AddArray(origin);
  Surface result = marked;
  const auto cells = static_cast<double>(surface->GetNumberOfCells());
  if (cells > triangles)
  {
    vtkNew<vtkDecimatePro> decimate;
    decimate->SetInputData(marked);
    decimate->SetTargetReduction(1 - triangles / cells);
    decimate->PreserveTopologyOn();
    decimate->SplittingOff();
    decimate->BoundaryVertexDeletionOn();
    decimate->Update();
    result = decimate->GetOutput();
  }
  vtkDataArray* kept = result->GetPointData()->GetArray(origin_array);
  origins.clear();
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    origins.push_back(static_cast<vtkIdType>(kept->GetTuple1(i)));
  }
  return result;
}

ViewerParts report_viewer(const PlanScene& scene, const Texts& texts, const std::string& library,
                          const std::string& script, const ViewerLimits& limits)
{
  std::vector<Surface> all = scene.faces();
  const std::vector<Surface> bones = scene.bones();
  all.insert(all.end(), bones.begin(), bones.end());
  const Quantiser quantiser(all);
  ViewerParts parts;
  parts.html = viewer_html(scene, texts);
  parts.library = library;
  parts.script = script;
  parts.data = "{\"centre\":" + list(quantiser.centre) + ",\"unit\":" + number(quantiser.unit_mm) +
               ",\"skin\":" + skin_json(scene, quantiser, limits.skin_triangles) +
               ",\"bones\":" + bones_json(scene, quantiser, limits.bone_triangles) +
               ",\"views\":" + views_json(texts) + ",\"texts\":" + texts_json(texts) + "}";
  return parts;
}

} // namespace f2b
