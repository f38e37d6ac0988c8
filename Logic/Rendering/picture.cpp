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

namespace f2b
{

namespace
{

// Drawn twice as large and averaged: edges, lines and translucent layers are all smooth, which
// multisampling does not give together with depth peeling.
constexpr int supersampling = 2;

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
  renderer->SetBackground(0.955, 0.962, 0.970);
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

} // namespace

Picture::Picture(int panels, PixelSize panel_size)
    : m_window(vtkSmartPointer<vtkRenderWindow>::New()), m_size{panels * panel_size.width,
                                                                panel_size.height}
{
  m_window->SetOffScreenRendering(1);
  m_window->SetShowWindow(false);
  m_window->SetMultiSamples(0);
  m_window->SetAlphaBitPlanes(1);
  m_window->SetNumberOfLayers(2);
  m_window->SetSize(m_size.width * supersampling, m_size.height * supersampling);
  for (int i = 0; i < panels; ++i)
  {
    add_panel(i, panels, panel_size);
  }
}

void Picture::add_panel(int index, int count, PixelSize size)
{
  Panel panel{make_scene_renderer(), nullptr, size, supersampling, 1 + 0.18 * (count - 1)};
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

Image Picture::render()
{
  const QuietMessages messages;
  m_window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(m_window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(grab->GetOutputPort());
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

void write_png(const Image& image, const std::filesystem::path& path)
{
  const QuietMessages messages;
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  write_file_atomically(path, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                               static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

} // namespace f2b
