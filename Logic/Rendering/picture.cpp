#include <Rendering/picture.hpp>

#include <Core/error.hpp>
#include <Rendering/atomic_file.hpp>
#include <Rendering/quiet_messages.hpp>

#include <vtkCamera.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <zlib.h>

namespace f2b
{

namespace
{

// Drawn twice as large and averaged: edges, lines and translucent layers are all smooth, which
// multisampling does not give together with depth peeling.
constexpr int supersampling = 2;

// What software OpenGL can draw in one piece.
constexpr int largest_drawn = 16384;

// Letters are unreadable below this.
constexpr int smallest_panel = 100;

using Rgb = std::array<double, 3>;

Rgb colour_of(Background background)
{
  return background == Background::Dark    ? Rgb{0.09, 0.10, 0.12}
         : background == Background::Light ? Rgb{0.955, 0.962, 0.970}
                                           : Rgb{1, 1, 1};
}

void add_light(vtkRenderer* renderer, double x, double y, double z, double intensity)
{
  vtkNew<vtkLight> light;
  // Camera lights live in the camera's frame: the viewer is at (0, 0, 1) and looks at the origin.
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

void add_three_point_light(vtkRenderer* renderer)
{
  renderer->AutomaticLightCreationOff();
  add_light(renderer, -0.55, 0.70, 1.0, 0.85);  // key: above, from the left
  add_light(renderer, 0.90, 0.05, 0.8, 0.38);   // fill: from the right
  add_light(renderer, 0.25, 1.00, -0.55, 0.30); // rim: from behind and above
}

vtkSmartPointer<vtkRenderer> make_scene_renderer()
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetLayer(0);
  add_three_point_light(renderer);
  renderer->SetUseDepthPeeling(1);
  renderer->SetMaximumNumberOfPeels(2);
  renderer->SetOcclusionRatio(0.001);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  return renderer;
}

vtkSmartPointer<vtkRenderer> make_front_renderer(vtkRenderer* scene)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetLayer(1);
  renderer->SetActiveCamera(scene->GetActiveCamera());
  add_three_point_light(renderer);
  return renderer;
}

// Colour and opacity from the same picture on white and on black: right for translucent surfaces and
// smoothed edges alike, whatever the driver keeps in its alpha buffer.
Image with_alpha(const Image& on_white, const Image& on_black)
{
  auto image = Image::New();
  image->SetDimensions(on_white->GetDimensions());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto* white = static_cast<const unsigned char*>(on_white->GetScalarPointer());
  const auto* black = static_cast<const unsigned char*>(on_black->GetScalarPointer());
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    int passed = 0; // of the background's light
    for (int c = 0; c < 3; ++c)
    {
      passed = std::max(passed, white[3 * i + c] - black[3 * i + c]);
    }
    const int alpha = std::clamp(255 - passed, 0, 255);
    for (int c = 0; c < 3; ++c)
    {
      out[4 * i + c] = static_cast<unsigned char>(
          alpha == 0 ? 0 : std::min(255, (black[3 * i + c] * 255 + alpha / 2) / alpha));
    }
    out[4 * i + 3] = static_cast<unsigned char>(alpha);
  }
  return image;
}

std::string big_endian(unsigned long value)
{
  std::string bytes;
  for (const int shift : {24, 16, 8, 0})
  {
    bytes += static_cast<char>(value >> shift & 0xFFU);
  }
  return bytes;
}

// The PNG chunk pHYs, which VTK does not write. It follows the header: signature and IHDR.
constexpr std::size_t end_of_header = 8 + 25;

std::string density_chunk(int dpi)
{
  const auto per_metre = static_cast<unsigned long>(std::lround(dpi / 0.0254));
  const std::string body = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  const auto* data = reinterpret_cast<const unsigned char*>(body.data());
  const unsigned long check = crc32(0, data, static_cast<unsigned>(body.size()));
  return big_endian(body.size() - 4) + body + big_endian(check);
}

} // namespace

Picture::Picture(int panels, PixelSize size, Background background)
    : m_window(vtkSmartPointer<vtkRenderWindow>::New()), m_size(size), m_background(background)
{
  const std::string asked = std::to_string(size.width) + " x " + std::to_string(size.height);
  if (std::max(size.width, size.height) * supersampling > largest_drawn)
  {
    throw Error("size", asked + " pixels are too many",
                "ask for at most " + std::to_string(largest_drawn / supersampling) +
                    " in each direction");
  }
  if (size.width < smallest_panel * panels || size.height < smallest_panel)
  {
    throw Error("size", asked + " pixels are too few for " + std::to_string(panels) + " panel(s)",
                "give each at least " + std::to_string(smallest_panel) + " in each direction");
  }
  m_window->SetOffScreenRendering(1);
  m_window->SetShowWindow(false);
  m_window->SetMultiSamples(0);
  m_window->SetAlphaBitPlanes(1);
  m_window->SetNumberOfLayers(2);
  m_window->SetSize(m_size.width * supersampling, m_size.height * supersampling);
  for (int i = 0; i < panels; ++i)
  {
    add_panel(i, panels, {size.width / panels, size.height});
  }
  set_background(colour_of(background));
}

void Picture::set_background(const Rgb& colour)
{
  for (const Panel& panel : m_panels)
  {
    panel.scene->SetBackground(colour[0], colour[1], colour[2]);
  }
}

void Picture::add_panel(int index, int count, PixelSize size)
{
  const bool is_dark = m_background == Background::Dark;
  Panel panel{make_scene_renderer(),
              nullptr,
              size,
              supersampling,
              1 + 0.18 * (count - 1),
              colour_of(m_background),
              is_dark ? Rgb{0.93, 0.94, 0.96} : Rgb{0.13, 0.15, 0.18},
              is_dark ? Rgb{0.70, 0.73, 0.77} : Rgb{0.36, 0.39, 0.43}};
  panel.front = make_front_renderer(panel.scene);
  const double left = static_cast<double>(index) / count;
  const double right = static_cast<double>(index + 1) / count;
  for (vtkRenderer* renderer : {panel.scene.Get(), panel.front.Get()})
  {
    renderer->SetViewport(left, 0, right, 1);
    m_window->AddRenderer(renderer);
  }
  m_panels.push_back(panel);
}

Image Picture::grab()
{
  const QuietMessages messages;
  m_window->Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(m_window);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(filter->GetOutputPort());
  shrink->SetShrinkFactors(supersampling, supersampling, 1);
  shrink->AveragingOn();
  shrink->Update();
  Image image = shrink->GetOutput();
  const int* dimensions = image->GetDimensions();
  if (dimensions[0] != m_size.width || dimensions[1] != m_size.height)
  {
    throw Error("picture", "VTK could not draw it. " + messages.first_error(),
                "check the OpenGL driver, or unset DISPLAY to draw in software");
  }
  return image;
}

Image Picture::render()
{
  if (m_background != Background::Transparent)
  {
    return grab();
  }
  set_background({1, 1, 1});
  const Image on_white = grab();
  set_background({0, 0, 0});
  return with_alpha(on_white, grab());
}

void write_png(const Image& image, const std::filesystem::path& path, int dpi)
{
  const QuietMessages messages;
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* result = writer->GetResult();
  std::string bytes(reinterpret_cast<const char*>(result->GetPointer(0)),
                    static_cast<std::size_t>(result->GetNumberOfValues()));
  if (dpi > 0)
  {
    bytes.insert(end_of_header, density_chunk(dpi));
  }
  write_file_atomically(path, bytes);
}

} // namespace f2b
