#pragma once

#include <Rendering/annotation.hpp>
#include <Rendering/framing.hpp>
#include <Rendering/plan_scene.hpp>
#include <Rendering/subject.hpp>
#include <Rendering/texts.hpp>

#include <functional>
#include <optional>

/// How is a subject drawn into a panel, whatever the view?
namespace f2b
{

struct ValueBar
{
  vtkSmartPointer<vtkLookupTable> map;
  std::string title;
};

/// A view that the subject itself fixes: a slice is seen from one side only.
struct FixedView
{
  ViewAxes axes{};
  std::string title;
};

struct SubjectDrawing
{
  std::string title;
  std::vector<Surface> framed; ///< what must fit; the same for all states of a thing
  std::vector<LegendEntry> legend;
  std::size_t legend_rows = 0; ///< room to leave, so that all states are framed alike
  std::optional<ValueBar> bar;
  std::optional<FixedView> fixed_view;
  /// Draws the surfaces, and annotations that hang on them; the panel is aimed.
  std::function<void(const Panel&, const ViewAxes&, double mm_per_pixel)> draw;
};

struct SubjectOptions
{
  double fraction = 0.5;          ///< of the way from before to predicted, for Morph
  std::optional<double> slice_mm; ///< R, A or S of a CT slice; else through the fragments' middle
};

/// What a scene lacks for a subject; empty if it can be drawn.
std::string missing_for(Subject subject, const PlanScene& scene);

/// \throws f2b::Error naming what the scene lacks
void require_shown(Subject subject, const PlanScene& scene);
SubjectDrawing subject_drawing(Subject subject, const PlanScene& scene, const Texts& texts,
                               const SubjectOptions& options);

// The kinds of subjects, one source file each.
SubjectDrawing face_drawing(Subject subject, const PlanScene& scene, const Texts& texts,
                            const SubjectOptions& options);
SubjectDrawing bone_drawing(Subject subject, const PlanScene& scene, const Texts& texts);
SubjectDrawing map_drawing(Subject subject, const PlanScene& scene, const Texts& texts);
SubjectDrawing mesh_drawing(Subject subject, const PlanScene& scene, const Texts& texts);
SubjectDrawing slice_drawing(Subject subject, const PlanScene& scene, const Texts& texts,
                             const SubjectOptions& options);

} // namespace f2b
