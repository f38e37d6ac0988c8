#pragma once

#include <Rendering/picture.hpp>
#include <Rendering/subject_drawing.hpp>

/// How do subjects and views become one picture?
///
/// A picture has one panel for every subject in every view, from left to right, all at one scale; a
/// CT slice has its own view. Every state of the face, and every one of the bones, is framed alike:
/// what differs between two of them has really moved. The same scene and definition give the same
/// pixels.
namespace f2b
{

struct PictureDefinition
{
  std::string name; ///< file name without ".png", such as "distance_map"
  std::vector<Subject> show;
  std::vector<View> views;
  PixelSize size{1200, 1000}; ///< of the whole picture
  Background background = Background::Light;
  int dpi = 0; ///< stated in the file; 0: none
  SubjectOptions options;
};

/// Panels of a definition.
int panel_count(const PictureDefinition& definition);

/// Needs a living OffscreenDisplay.
/// \throws f2b::Error naming what the scene lacks
Image draw_picture(const PlanScene& scene, const PictureDefinition& definition, const Texts& texts);

} // namespace f2b
