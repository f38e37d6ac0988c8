#include "toy_plan.hpp"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <functional>

namespace
{

using f2b::Surface;
using Point = std::array<double, 3>;

Surface make_sphere(double radius, double end_phi = 180)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(72);
  sphere->SetPhiResolution(72);
  sphere->SetEndPhi(end_phi);
  sphere->Update();
  return sphere->GetOutput();
}

Surface moved(const Surface& surface, const std::function<Point(const Point&)>& movement)
{
  auto result = Surface::New();
  result->DeepCopy(surface);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    Point x{};
    result->GetPoint(i, x.data());
    result->GetPoints()->SetPoint(i, movement(x).data());
  }
  return result;
}

// 1 in the middle of the face, falling off towards the ears.
double face_weight(const Point& x, double radius)
{
  const double side = x[0] / (0.5 * radius), up = x[2] / (0.5 * radius);
  return x[1] > 0 ? std::exp(-side * side - up * up) : 0;
}

Surface make_skin(double radius)
{
  return moved(make_sphere(radius),
               [radius](const Point& x)
               {
                 const double side = x[0] / (0.12 * radius), up = x[2] / (0.2 * radius);
                 const double nose = x[1] > 0 ? std::exp(-side * side - up * up) : 0;
                 return Point{0.8 * x[0], x[1] + 0.18 * radius * nose, 1.1 * x[2]};
               });
}

Surface pushed(const Surface& skin, double radius, double distance)
{
  return moved(skin,
               [=](const Point& x) {
                 return Point{x[0], x[1] + distance * face_weight(x, radius), x[2]};
               });
}

void add_distance(const Surface& predicted, double radius, double miss)
{
  vtkNew<vtkDoubleArray> distance;
  distance->SetName(f2b::signed_distance_array);
  for (vtkIdType i = 0; i < predicted->GetNumberOfPoints(); ++i)
  {
    Point x{};
    predicted->GetPoint(i, x.data());
    distance->InsertNextValue(-miss * std::tanh(5 * x[0] / radius) * (x[1] > 0 ? 1 : 0));
  }
  predicted->GetPointData()->AddArray(distance);
}

f2b::FragmentPicture make_fragment(double radius)
{
  f2b::FragmentPicture fragment;
  fragment.name = "Mid-face";
  const Surface cap = make_sphere(0.3 * radius);
  fragment.rest = moved(cap,
                        [radius](const Point& x) {
                          return Point{x[0], x[1] + 0.6 * radius, x[2]};
                        });
  const double step = 0.1 * radius;
  fragment.planned = moved(fragment.rest,
                           [step](const Point& x) {
                             return Point{x[0], x[1] + step, x[2] - step};
                           });
  fragment.reference_point_ras = {0, 0.6 * radius, 0};
  fragment.matrix_ras = {1, 0, 0, 0, 0, 1, 0, step, 0, 0, 1, -step, 0, 0, 0, 1};
  fragment.movement = "forward and down";
  return fragment;
}

} // namespace

f2b::PlanPictures toy_plan(double radius_mm)
{
  f2b::PlanPictures plan;
  plan.skin = make_skin(radius_mm);
  plan.target = pushed(plan.skin, radius_mm, 0.10 * radius_mm);
  plan.predicted = pushed(plan.skin, radius_mm, 0.08 * radius_mm);
  add_distance(plan.predicted, radius_mm, 0.02 * radius_mm);
  plan.uncut_bone = make_sphere(0.7 * radius_mm);
  plan.fragments = {make_fragment(radius_mm)};
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.5 * radius_mm, 0.3 * radius_mm, 0);
  plane->SetPoint1(0.5 * radius_mm, 0.3 * radius_mm, 0);
  plane->SetPoint2(-0.5 * radius_mm, radius_mm, 0);
  plane->Update();
  plan.cut_planes = plane->GetOutput();
  return plan;
}
