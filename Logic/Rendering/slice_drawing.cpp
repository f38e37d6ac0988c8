#include <Rendering/subject_drawing.hpp>

#include <Rendering/bone_look.hpp>
#include <Rendering/movement_arrows.hpp>
#include <Rendering/surface_look.hpp>

#include <vtkCutter.h>
#include <vtkImageActor.h>
#include <vtkImageMapper3D.h>
#include <vtkImageProperty.h>
#include <vtkPlane.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace f2b
{

namespace
{

using Point = std::array<double, 3>;

// Bone and soft tissue both in sight.
constexpr double window_hu = 1800, level_hu = 400;

constexpr Colour outline_skin{0.98, 0.72, 0.42};
constexpr Colour outline_predicted{0.93, 0.93, 0.35};
constexpr Colour outline_bone{0.55, 0.90, 0.62};
constexpr Colour outline_rest{0.75, 0.78, 0.84};

struct Slice
{
  int axis = 0; ///< 0 R, 1 A, 2 S
  int index = 0;
  double position = 0; ///< of the voxels' centres [mm]
};

// As in Slicer: axial from below, sagittal from the patient's left, coronal from in front.
ViewAxes slice_axes(int axis)
{
  return axis == 0   ? ViewAxes{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}}
         : axis == 1 ? ViewAxes{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}
                     : ViewAxes{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
}

int fragments_at(const PlanScene& scene, int axis, double position)
{
  const auto& fragments = scene.pictures().fragments;
  return static_cast<int>(std::count_if(
      fragments.begin(), fragments.end(),
      [&](const FragmentPicture& fragment)
      {
        const double* b = (fragment.planned ? fragment.planned : fragment.rest)->GetBounds();
        return b[2 * axis] < position && position < b[2 * axis + 1];
      }));
}

// Through the middle of the fragments' planned reference points; where a fragment's own point is in
// more of them, as with a maxilla far above a chin, through that. Of the CT without fragments.
double default_position(const PlanScene& scene, int axis)
{
  const auto& fragments = scene.pictures().fragments;
  if (fragments.empty())
  {
    const double* bounds = scene.pictures().ct->GetBounds();
    return 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
  }
  std::vector<double> own;
  for (const FragmentPicture& fragment : fragments)
  {
    own.push_back(moved_reference_point(fragment)[static_cast<std::size_t>(axis)]);
  }
  double best = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(own.size());
  for (const double position : own)
  {
    if (fragments_at(scene, axis, position) > fragments_at(scene, axis, best))
    {
      best = position;
    }
  }
  return best;
}

Slice slice_of(const PlanScene& scene, Subject subject, const SubjectOptions& options)
{
  vtkImageData* ct = scene.pictures().ct;
  Slice slice;
  slice.axis = subject == Subject::CtSagittal ? 0 : subject == Subject::CtCoronal ? 1 : 2;
  const double wanted = options.slice_mm.value_or(default_position(scene, slice.axis));
  const double origin = ct->GetOrigin()[slice.axis], spacing = ct->GetSpacing()[slice.axis];
  slice.index = std::clamp(static_cast<int>(std::lround((wanted - origin) / spacing)), 0,
                           ct->GetDimensions()[slice.axis] - 1);
  slice.position = origin + slice.index * spacing;
  return slice;
}

void add_slice_image(const Panel& panel, vtkImageData* ct, const Slice& slice)
{
  vtkNew<vtkImageActor> actor;
  actor->SetInputData(ct);
  std::array<int, 6> extent{};
  ct->GetExtent(extent.data());
  extent[static_cast<std::size_t>(2 * slice.axis)] = slice.index;
  extent[static_cast<std::size_t>(2 * slice.axis + 1)] = slice.index;
  actor->SetDisplayExtent(extent.data());
  actor->GetProperty()->SetColorWindow(window_hu);
  actor->GetProperty()->SetColorLevel(level_hu);
  actor->GetProperty()->SetInterpolationTypeToLinear();
  panel.scene->AddActor(actor);
}

void add_cut_of(const Panel& panel, const Surface& surface, const Slice& slice,
                const Colour& colour, double width)
{
  vtkNew<vtkPlane> plane;
  Point origin{}, normal{};
  origin[static_cast<std::size_t>(slice.axis)] = slice.position + 1e-4; // off the grid's vertices
  normal[static_cast<std::size_t>(slice.axis)] = 1;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(surface);
  cutter->SetCutFunction(plane);
  cutter->Update();
  if (cutter->GetOutput()->GetNumberOfCells() > 0)
  {
    add_outline(panel, cutter->GetOutput(), colour, width);
  }
}

void draw_slice(const Panel& panel, const PlanScene& scene, const Slice& slice)
{
  const PlanPictures& pictures = scene.pictures();
  add_slice_image(panel, pictures.ct, slice);
  add_cut_of(panel, pictures.uncut_bone, slice, outline_bone, 1.5);
  for (std::size_t f = 0; f < pictures.fragments.size(); ++f)
  {
    add_cut_of(panel, pictures.fragments[f].rest, slice, outline_rest, 1.2);
  }
  for (std::size_t f = 0; f < pictures.fragments.size(); ++f)
  {
    add_cut_of(panel, pictures.fragments[f].planned, slice, slice_fragment_colour(f), 2.5);
  }
  add_cut_of(panel, pictures.skin, slice, outline_skin, 1.5);
  if (pictures.predicted)
  {
    add_cut_of(panel, pictures.predicted, slice, outline_predicted, 2.2);
  }
}

std::vector<LegendEntry> slice_legend(const PlanScene& scene, const Texts& texts)
{
  std::vector<LegendEntry> entries{{texts("legend.skin-before"), outline_skin}};
  if (scene.has_predicted())
  {
    entries.push_back({texts("legend.face-predicted"), outline_predicted});
  }
  entries.push_back({texts("legend.bone-that-stays"), outline_bone});
  entries.push_back({texts("legend.fragments-rest"), outline_rest});
  const auto& fragments = scene.pictures().fragments;
  for (std::size_t f = 0; f < fragments.size(); ++f)
  {
    entries.push_back({texts("legend.fragment-planned", {{"fragment", fragments[f].name}}),
                       slice_fragment_colour(f)});
  }
  return entries;
}

// The slice's rectangle, to be framed.
Surface slice_frame(vtkImageData* ct)
{
  const double* b = ct->GetBounds();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(b[0], b[2], b[4]);
  points->InsertNextPoint(b[1], b[3], b[5]);
  auto frame = Surface::New();
  frame->SetPoints(points);
  return frame;
}

std::string position_text(const Slice& slice)
{
  const std::array<char, 3> letters{'R', 'A', 'S'};
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%c %.1f mm",
                letters[static_cast<std::size_t>(slice.axis)], slice.position + 0.0);
  return text.data();
}

} // namespace

SubjectDrawing slice_drawing(Subject subject, const PlanScene& scene, const Texts& texts,
                             const SubjectOptions& options)
{
  const Slice slice = slice_of(scene, subject, options);
  SubjectDrawing drawing;
  drawing.title = texts("subject." + name_of(subject));
  drawing.framed = {slice_frame(scene.pictures().ct)};
  drawing.legend = slice_legend(scene, texts);
  drawing.fixed_view = FixedView{slice_axes(slice.axis), position_text(slice)};
  drawing.draw = [&scene, slice](const Panel& panel, const ViewAxes&, double)
  { draw_slice(panel, scene, slice); };
  return drawing;
}

} // namespace f2b
