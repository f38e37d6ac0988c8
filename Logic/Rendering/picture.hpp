#pragma once

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <vector>

/// How do 3D panels side by side become one PNG? Offscreen, lit, smoothed, without a window.
namespace f2b
{

using Image = vtkSmartPointer<vtkImageData>; ///< 8 bit RGB or RGBA, origin bottom left

enum class Background
{
  Light,       ///< pale grey: white skin and paper stand out
  White,       ///< for print
  Dark,        ///< for slides
  Transparent, ///< an alpha channel, also in translucent surfaces; dark letters
};

struct PixelSize
{
  int width = 1200;
  int height = 1000;
};

/// One part of a picture: a 3D scene with three-point light, and what is drawn in front of it.
///
/// Annotations are placed in output pixels from the panel's bottom left corner; `scale` is the
/// number of drawn pixels per output pixel.
struct Panel
{
  vtkSmartPointer<vtkRenderer> scene;
  vtkSmartPointer<vtkRenderer> front; ///< same camera as `scene`, always in front of it
  PixelSize size;
  double scale = 1;
  double type_scale = 1;            ///< letters are larger where several panels share a width
  std::array<double, 3> paper{};    ///< the background
  std::array<double, 3> ink{};      ///< of letters on it
  std::array<double, 3> pale_ink{}; ///< of less important ones
};

class Picture
{
public:
  /// \param panels      number of panels from left to right
  /// \param size    of the whole, in output pixels
  /// \throws f2b::Error when the picture is larger than VTK can draw, or too small to be read
  Picture(int panels, PixelSize size, Background background = Background::Light);

  const Panel& panel(int index) const { return m_panels.at(static_cast<std::size_t>(index)); }

  /// \throws f2b::Error when VTK cannot draw
  Image render();

private:
  void add_panel(int index, int count, PixelSize size);
  Image grab();
  void set_background(const std::array<double, 3>& colour);

  vtkSmartPointer<vtkRenderWindow> m_window;
  std::vector<Panel> m_panels;
  PixelSize m_size;
  Background m_background;
};

/// Writes a PNG whole or not at all.
/// \param dpi  dots per inch that the file states for print; 0: none
/// \throws f2b::Error naming `path` when the folder is not writable or the disk is full
void write_png(const Image& image, const std::filesystem::path& path, int dpi = 0);

} // namespace f2b
