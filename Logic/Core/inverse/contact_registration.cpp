#include "Core/inverse/contact_registration.hpp"

#include "Core/error.hpp"
#include "Core/mesh/boundary_facets.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace f2b
{
namespace
{

std::string in_mm(double length)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.1f mm", length);
  return text;
}

/// The fragment whose contact node this is, or -1.
int fragment_of(const MixedMesh& mesh, int node)
{
  const auto n = static_cast<std::size_t>(node);
  return mesh.node_boundary[n] == Boundary::Fragment ? mesh.node_fragment[n] : -1;
}

/// Facets all three nodes of which are contact nodes of one fragment.
std::vector<Triangle> contact_facets(const MixedMesh& mesh)
{
  std::vector<Triangle> facets;
  for (const Triangle& t : boundary_facets(mesh).inner)
    if (const int f = fragment_of(mesh, t[0]);
        f >= 0 && f == fragment_of(mesh, t[1]) && f == fragment_of(mesh, t[2]))
      facets.push_back(t);
  return facets;
}

/// Area coordinates of the point of the segment from corner i to corner j nearest to p.
Vec3 nearest_on_edge(const std::array<Vec3, 3>& corners, int i, int j, const Vec3& p)
{
  const Vec3 &a = corners[static_cast<std::size_t>(i)], &b = corners[static_cast<std::size_t>(j)];
  const double length2 = (b - a).squaredNorm();
  const double s = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0;
  return (1 - s) * Vec3::Unit(i) + s * Vec3::Unit(j);
}

/// Area coordinates of the point of a triangle nearest to p.
Vec3 nearest_on_triangle(const std::array<Vec3, 3>& corners, const Vec3& p)
{
  const auto& [a, b, c] = corners;
  const Vec3 normal = (b - a).cross(c - a);
  if (normal.squaredNorm() > 0)
  {
    const Vec3 areas((b - p).cross(c - p).dot(normal), (c - p).cross(a - p).dot(normal),
                     (a - p).cross(b - p).dot(normal));
    if ((areas.array() >= 0).all())
      return areas / areas.sum();
  }
  Vec3 best = Vec3::Unit(0);
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 0}})
  {
    const Vec3 weight = nearest_on_edge(corners, i, j, p);
    const double d = (weight[0] * a + weight[1] * b + weight[2] * c - p).norm();
    if (d < distance)
    {
      distance = d;
      best = weight;
    }
  }
  return best;
}

/// Root mean square distance of points from the line that fits them best.
double spread_across_line(const std::vector<Vec3>& points)
{
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points)
    mean += p / static_cast<double>(points.size());
  Mat3 moments = Mat3::Zero();
  for (const Vec3& p : points)
    moments += (p - mean) * (p - mean).transpose() / static_cast<double>(points.size());
  const Vec3 squares = Eigen::SelfAdjointEigenSolver<Mat3>(moments).eigenvalues();
  return std::sqrt(std::max(0.0, squares[0] + squares[1]));
}

} // namespace

Vec3 ContactSurfaces::Place::in(const std::vector<Vec3>& x) const
{
  Vec3 p = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    p += weight[static_cast<Eigen::Index>(i)] * x[static_cast<std::size_t>(node[i])];
  return p;
}

ContactSurfaces::ContactSurfaces(const MixedMesh& mesh, std::vector<Vec3> reference_points,
                                 const std::vector<ContactLandmark>& landmarks)
    : m_mesh(mesh), m_reference_points(std::move(reference_points)),
      m_nodes(m_reference_points.size()), m_landmarks(m_reference_points.size())
{
  for (int n = 0; n < mesh.node_count(); ++n)
    if (const int f = fragment_of(mesh, n); f >= 0)
      m_nodes[static_cast<std::size_t>(f)].push_back({{n, n, n}});
  if (!landmarks.empty())
    place_landmarks(landmarks);
  require_determined();
}

/// A contact node without a facet is a place of its own.
ContactSurfaces::Foot ContactSurfaces::nearest(const Vec3& point,
                                               const std::vector<Triangle>& facets) const
{
  Foot foot;
  foot.distance = std::numeric_limits<double>::infinity();
  auto offer = [&](const Place& place, int fragment)
  {
    const double distance = (place.in(m_mesh.X) - point).norm();
    if (distance < foot.distance)
      foot = {place, fragment, distance};
  };
  for (std::size_t f = 0; f < m_nodes.size(); ++f)
    for (const Place& node : m_nodes[f])
      offer(node, static_cast<int>(f));
  for (const Triangle& t : facets)
  {
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = m_mesh.X[static_cast<std::size_t>(t[i])];
    offer({t, nearest_on_triangle(corners, point)}, fragment_of(m_mesh, t[0]));
  }
  return foot;
}

void ContactSurfaces::place_landmarks(const std::vector<ContactLandmark>& landmarks)
{
  const std::vector<Triangle> facets = contact_facets(m_mesh);
  for (const ContactLandmark& landmark : landmarks)
  {
    const Foot foot = nearest(landmark.position, facets);
    if (!(foot.distance <= farthest_landmark_mm))
      throw Error("landmark '" + landmark.name + "'",
                  foot.fragment < 0
                      ? "no fragment has soft-tissue contact that it could lie on"
                      : "it is " + in_mm(foot.distance) + " away from the tissue on fragment '" +
                            m_mesh.fragments[static_cast<std::size_t>(foot.fragment)] +
                            "', the nearest",
                  "place it within " + in_mm(farthest_landmark_mm) +
                      " of tissue that hangs on a fragment, or register without it");
    m_landmarks[static_cast<std::size_t>(foot.fragment)].push_back(foot.place);
  }
}

void ContactSurfaces::require_determined() const
{
  auto require = [&](const std::vector<Place>& places, std::size_t f, const std::string& what,
                     const std::string& remedy)
  {
    std::vector<Vec3> points;
    for (const Place& place : places)
      points.push_back(place.in(m_mesh.X));
    const std::string subject = "fragment '" + m_mesh.fragments[f] + "'";
    if (places.size() < 3)
      throw Error(subject,
                  "its movement needs three " + what + ", and it has " +
                      std::to_string(places.size()),
                  remedy);
    if (const double spread = spread_across_line(points); spread < least_spread_mm)
      throw Error(subject,
                  "its " + std::to_string(places.size()) + " " + what +
                      " lie on one line, so that its rotation cannot be told",
                  remedy);
  };
  for (std::size_t f = 0; f < m_nodes.size(); ++f)
  {
    require(m_nodes[f], f, "soft-tissue contact nodes",
            "use a smaller release margin, a denser mesh or another cut");
    if (!m_landmarks[f].empty())
      require(m_landmarks[f], f, "registration landmarks",
              "give it three landmarks that are well apart, or none");
  }
}

Registration ContactSurfaces::registration(const std::vector<Place>& places, std::size_t fragment,
                                           const std::vector<Vec3>& x) const
{
  std::vector<Vec3> from, to;
  for (const Place& place : places)
  {
    from.push_back(place.in(m_mesh.X));
    to.push_back(place.in(x));
  }
  Registration result;
  result.points = static_cast<int>(places.size());
  result.motion = register_rigidly(from, to, m_reference_points[fragment]);
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    sum += (result.motion.apply(from[i]) - to[i]).squaredNorm();
  result.rms_mm = std::sqrt(sum / static_cast<double>(from.size()));
  return result;
}

std::vector<FragmentRegistration> ContactSurfaces::register_to(const std::vector<Vec3>& x) const
{
  std::vector<FragmentRegistration> result(m_nodes.size());
  for (std::size_t f = 0; f < m_nodes.size(); ++f)
  {
    result[f].surface = registration(m_nodes[f], f, x);
    if (!m_landmarks[f].empty())
      result[f].landmarks = registration(m_landmarks[f], f, x);
  }
  return result;
}

std::vector<Vec3> registration_misfit(const MixedMesh& mesh,
                                      const std::vector<RigidMotion>& motions,
                                      const std::vector<Vec3>& x)
{
  std::vector<Vec3> misfit(mesh.X.size(), Vec3::Zero());
  for (int i = 0; i < mesh.node_count(); ++i)
    if (const int f = fragment_of(mesh, i); f >= 0)
    {
      const auto n = static_cast<std::size_t>(i);
      misfit[n] = x[n] - motions[static_cast<std::size_t>(f)].apply(mesh.X[n]);
    }
  return misfit;
}

} // namespace f2b
