#include <Rendering/subject_drawing.hpp>

#include <Rendering/bone_look.hpp>
#include <Rendering/map_arrays.hpp>
#include <Rendering/surface_look.hpp>

#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>

#include <cmath>

namespace f2b
{

namespace
{

constexpr double veil = 0.32; ///< opacity of a face over bones

// Skin beyond the mesh stays where it was; a prediction says so.
bool partly_predicted(const PlanScene& scene)
{
  return scene.has_distance() &&
         has_unknown_values(scene.pictures().predicted, signed_distance_array);
}

Surface between(const Surface& from, const Surface& to, double fraction)
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(from->GetNumberOfPoints());
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> a{}, b{};
    from->GetPoint(i, a.data());
    to->GetPoint(i, b.data());
    points->SetPoint(i, a[0] + fraction * (b[0] - a[0]), a[1] + fraction * (b[1] - a[1]),
                     a[2] + fraction * (b[2] - a[2]));
  }
  vtkNew<vtkPolyData> moved;
  moved->SetPoints(points);
  moved->SetPolys(from->GetPolys());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(moved);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

SubjectDrawing over_skull(Subject subject, const PlanScene& scene, const Texts& texts)
{
  const bool is_planned = subject == Subject::FaceOverSkull;
  const bool is_predicted = is_planned && scene.has_predicted();
  SubjectDrawing drawing;
  drawing.framed = scene.faces();
  const std::vector<Surface> bones = scene.bones();
  drawing.framed.insert(drawing.framed.end(), bones.begin(), bones.end());
  drawing.legend = fragment_legend(scene, texts, false);
  drawing.legend.push_back(
      {texts(is_predicted ? "legend.face-predicted" : "legend.face-before"), skin_colour, veil});
  const Surface face = is_predicted ? scene.pictures().predicted : scene.pictures().skin;
  drawing.draw = [&scene, face, is_planned](const Panel& panel, const ViewAxes&, double)
  {
    add_bones(panel, scene, is_planned, true);
    add_skin(panel, face, veil);
  };
  return drawing;
}

} // namespace

SubjectDrawing face_drawing(Subject subject, const PlanScene& scene, const Texts& texts,
                            const SubjectOptions& options)
{
  SubjectDrawing drawing;
  const PlanPictures& pictures = scene.pictures();
  const std::string key = "subject." + name_of(subject);
  if (subject == Subject::FaceOverSkull || subject == Subject::FaceOverSkullBefore)
  {
    drawing = over_skull(subject, scene, texts);
    drawing.title = texts(key);
    return drawing;
  }
  drawing.framed = scene.faces();
  const bool partly = partly_predicted(scene);
  drawing.legend_rows = partly ? 1 : 0;
  drawing.title = texts(key);
  if (subject == Subject::Morph)
  {
    const std::string percent = std::to_string(std::lround(100 * options.fraction));
    drawing.title = texts(key, {{"percent", percent}});
    const Surface face = between(pictures.skin, pictures.predicted, options.fraction);
    drawing.draw = [face](const Panel& panel, const ViewAxes&, double) { add_skin(panel, face); };
    return drawing;
  }
  if (subject == Subject::FacePredicted && partly)
  {
    drawing.legend = {{texts("legend.not-computed"), no_value_colour}};
    drawing.draw = [&pictures](const Panel& panel, const ViewAxes&, double)
    { add_skin_known_by(panel, pictures.predicted, signed_distance_array); };
    return drawing;
  }
  const Surface face = subject == Subject::FaceBefore   ? pictures.skin
                       : subject == Subject::FaceTarget ? pictures.target
                                                        : pictures.predicted;
  drawing.draw = [face](const Panel& panel, const ViewAxes&, double) { add_skin(panel, face); };
  return drawing;
}

} // namespace f2b
