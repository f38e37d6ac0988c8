#include "Core/mesh/smooth_skin.hpp"

#include "Core/error.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace f2b
{
namespace
{

std::size_t at(int index)
{
  return static_cast<std::size_t>(index);
}

using Edge = std::pair<int, int>;

Edge edge_opposite(const std::array<int, 6>& prism, int k)
{
  return std::minmax({prism[at((k + 1) % 3)], prism[at((k + 2) % 3)]});
}

Mat3 top_corners(const MixedMesh& mesh, int prism)
{
  Mat3 X;
  for (int i = 0; i < 3; ++i)
    X.col(i) = mesh.X[at(mesh.prisms[at(prism)][at(i)])];
  return X;
}

/// Two vectors of a length that are perpendicular to a unit normal and to each other.
std::array<Vec3, 2> tangents_of(const Vec3& normal, double length)
{
  int flattest = 0;
  normal.cwiseAbs().minCoeff(&flattest);
  const Vec3 first = normal.cross(Vec3::Unit(flattest)).normalized();
  return {length * first, length * normal.cross(first)};
}

} // namespace

std::vector<SkinTangents> skin_tangents(const MixedMesh& mesh)
{
  std::vector<Vec3> normal(mesh.X.size(), Vec3::Zero());
  std::vector<double> length(mesh.X.size(), 0);
  std::vector<int> edges(mesh.X.size(), 0);
  for (int p = 0; p < static_cast<int>(mesh.prisms.size()); ++p)
  {
    const Mat3 X = top_corners(mesh, p);
    for (int i = 0; i < 3; ++i)
    {
      const std::size_t node = at(mesh.prisms[at(p)][at(i)]);
      const Vec3 next = X.col((i + 1) % 3) - X.col(i), last = X.col((i + 2) % 3) - X.col(i);
      normal[node] += next.cross(last) / (next.squaredNorm() * last.squaredNorm());
      length[node] += next.norm() + last.norm();
      edges[node] += 2;
    }
  }
  std::vector<SkinTangents> result;
  for (std::size_t node = 0; node < mesh.X.size(); ++node)
    if (edges[node])
    {
      const Vec3 unit = normal[node].stableNormalized();
      result.push_back(
          {static_cast<int>(node), unit, tangents_of(unit, length[node] / edges[node])});
    }
  return result;
}

/// Finds the slopes: makes edges straight until no prism folds.
class SmoothSkin::Builder
{
public:
  explicit Builder(SmoothSkin& skin);
  void run();

private:
  void list_edges();
  FaceSlopes slopes(int prism) const;
  bool folds(int prism) const;
  bool make_straight(int edge);
  bool straighten_folded();
  bool straighten_spanless();
  void keep_result();

  SmoothSkin& m_skin;
  const MixedMesh& m_mesh;
  std::vector<SkinTangents> m_tangents; ///< of all nodes of the face
  std::vector<int> m_entry;             ///< per node, into m_tangents
  std::vector<Edge> m_edges;            ///< ascending
  std::vector<std::array<int, 3>> m_edge_of_prism;
  std::vector<char> m_straight; ///< per edge
  std::vector<char> m_folded;
  std::vector<int> m_checked; ///< per prism: its straight edges when it was last seen, or -1
};

SmoothSkin::Builder::Builder(SmoothSkin& skin)
    : m_skin(skin), m_mesh(skin.m_mesh), m_tangents(skin_tangents(m_mesh)),
      m_entry(m_mesh.X.size(), -1), m_folded(m_mesh.prisms.size(), 0),
      m_checked(m_mesh.prisms.size(), -1)
{
  for (std::size_t i = 0; i < m_tangents.size(); ++i)
    m_entry[at(m_tangents[i].node)] = static_cast<int>(i);
  list_edges();
}

void SmoothSkin::Builder::list_edges()
{
  for (const auto& prism : m_mesh.prisms)
    for (int k = 0; k < 3; ++k)
      m_edges.push_back(edge_opposite(prism, k));
  std::sort(m_edges.begin(), m_edges.end());
  m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  m_straight.assign(m_edges.size(), 0);
  for (const auto& prism : m_mesh.prisms)
  {
    std::array<int, 3> of_prism;
    for (int k = 0; k < 3; ++k)
      of_prism[at(k)] = static_cast<int>(
          std::lower_bound(m_edges.begin(), m_edges.end(), edge_opposite(prism, k)) -
          m_edges.begin());
    m_edge_of_prism.push_back(of_prism);
  }
}

FaceSlopes SmoothSkin::Builder::slopes(int prism) const
{
  FaceSlopes slopes;
  const auto& corners = m_mesh.prisms[at(prism)];
  for (int i = 0; i < 3; ++i)
    for (int step = 1; step < 3; ++step)
    {
      // the edge to corner i + 1 is opposite corner i + 2, and the other way round
      const int j = (i + step) % 3, opposite = (i + 3 - step) % 3;
      EdgeSlope& slope = slopes[at(2 * i + step - 1)];
      slope.straight = m_straight[at(m_edge_of_prism[at(prism)][at(opposite)])];
      if (slope.straight)
        continue;
      const auto& tangent = m_tangents[at(m_entry[at(corners[at(i)])])].tangent;
      const Vec3 edge = m_mesh.X[at(corners[at(j)])] - m_mesh.X[at(corners[at(i)])];
      slope.a = edge.dot(tangent[0]) / tangent[0].squaredNorm();
      slope.b = edge.dot(tangent[1]) / tangent[1].squaredNorm();
    }
  return slopes;
}

bool SmoothSkin::Builder::folds(int prism) const
{
  SmoothPrism::Positions Q;
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t top = at(m_mesh.prisms[at(prism)][at(i)]);
    const auto& tangent = m_tangents[at(m_entry[top])].tangent;
    Q.col(i) = m_mesh.X[top];
    Q.col(3 + 2 * i) = tangent[0];
    Q.col(4 + 2 * i) = tangent[1];
    Q.col(9 + i) = m_mesh.X[at(m_mesh.prisms[at(prism)][at(i + 3)])];
  }
  const FaceMap map = f2b::face_map(Q.leftCols<3>(), slopes(prism));
  const double least = least_relative_jacobian(Q, map);
  if (!m_folded[at(prism)])
    return !(least > least_jacobian);
  if (!(least > 0))
    throw Error("mesh", "prism " + std::to_string(prism) + " of the skin is inside out",
                "mesh the case again");
  return false;
}

bool SmoothSkin::Builder::make_straight(int edge)
{
  if (m_straight[at(edge)])
    return false;
  m_straight[at(edge)] = 1;
  return true;
}

bool SmoothSkin::Builder::straighten_folded()
{
  bool changed = false;
  for (int p = 0; p < static_cast<int>(m_mesh.prisms.size()); ++p)
  {
    const auto& edges = m_edge_of_prism[at(p)];
    const auto straight = std::count_if(edges.begin(), edges.end(),
                                        [&](int edge) { return m_straight[at(edge)] != 0; });
    if (m_checked[at(p)] == straight)
      continue;
    m_checked[at(p)] = static_cast<int>(straight);
    if (!folds(p))
      continue;
    m_folded[at(p)] = 1;
    m_checked[at(p)] = -1; // once more, as a straight prism
    for (const int edge : edges)
      make_straight(edge);
    changed = true;
  }
  return changed;
}

/// A node whose curved edges do not span its tangent plane would have a slope without stiffness.
bool SmoothSkin::Builder::straighten_spanless()
{
  std::vector<Eigen::Matrix2d> span(m_tangents.size(), Eigen::Matrix2d::Zero());
  for (int p = 0; p < static_cast<int>(m_mesh.prisms.size()); ++p)
  {
    const FaceSlopes of_prism = slopes(p);
    for (std::size_t s = 0; s < of_prism.size(); ++s)
    {
      const Eigen::Vector2d ab(of_prism[s].a, of_prism[s].b); // zero for a straight edge
      span[at(m_entry[at(m_mesh.prisms[at(p)][s / 2])])] += ab * ab.transpose();
    }
  }
  bool changed = false;
  for (std::size_t edge = 0; edge < m_edges.size(); ++edge)
    for (const int node : {m_edges[edge].first, m_edges[edge].second})
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spectrum(span[at(m_entry[at(node)])],
                                                                    Eigen::EigenvaluesOnly);
      if (!(spectrum.eigenvalues()[0] > 0.02))
        changed |= make_straight(static_cast<int>(edge));
    }
  return changed;
}

void SmoothSkin::Builder::run()
{
  do
    while (straighten_folded())
      continue;
  while (straighten_spanless());
  keep_result();
}

void SmoothSkin::Builder::keep_result()
{
  std::vector<char> smooth(m_mesh.X.size(), 0);
  for (std::size_t edge = 0; edge < m_edges.size(); ++edge)
    if (m_straight[edge])
      m_skin.m_straight.push_back(m_edges[edge]);
    else
      smooth[at(m_edges[edge].first)] = smooth[at(m_edges[edge].second)] = 1;
  m_skin.m_slope_control.assign(m_mesh.X.size(), -1);
  for (const SkinTangents& tangents : m_tangents)
    if (smooth[at(tangents.node)])
    {
      m_skin.m_slope_control[at(tangents.node)] = m_skin.control_count();
      m_skin.m_tangents.push_back(tangents);
    }
  for (int p = 0; p < static_cast<int>(m_mesh.prisms.size()); ++p)
  {
    m_skin.m_slopes.push_back(slopes(p));
    if (m_folded[at(p)])
      m_skin.m_folded.push_back(p);
  }
}

SmoothSkin::SmoothSkin(const MixedMesh& mesh) : m_mesh(mesh)
{
  Builder(*this).run();
}

std::vector<Vec3> SmoothSkin::rest() const
{
  std::vector<Vec3> rest = m_mesh.X;
  for (const SkinTangents& tangents : m_tangents)
    rest.insert(rest.end(), tangents.tangent.begin(), tangents.tangent.end());
  return rest;
}

std::array<int, 12> SmoothSkin::controls(int prism) const
{
  const auto& corners = m_mesh.prisms[at(prism)];
  std::array<int, 12> controls;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const int slope = m_slope_control[at(corners[i])];
    controls[i] = corners[i];
    controls[3 + 2 * i] = slope < 0 ? corners[i] : slope;
    controls[4 + 2 * i] = slope < 0 ? corners[i] : slope + 1;
    controls[9 + i] = corners[i + 3];
  }
  return controls;
}

FaceMap SmoothSkin::face_map(int prism) const
{
  return f2b::face_map(top_corners(m_mesh, prism), m_slopes[at(prism)]);
}

Vec3 SmoothSkin::rest_of(int control) const
{
  const int slope = control - m_mesh.node_count();
  return slope < 0 ? m_mesh.X[at(control)] : m_tangents[at(slope / 2)].tangent[at(slope % 2)];
}

SmoothPrism SmoothSkin::element(int prism) const
{
  const std::array<int, 12> all = controls(prism);
  SmoothPrism::Positions Q;
  for (int i = 0; i < 12; ++i)
    Q.col(i) = rest_of(all[at(i)]);
  return make_smooth_prism<6>(Q, face_map(prism));
}

bool SmoothSkin::is_straight(int prism, int edge_opposite) const
{
  const int corner = (edge_opposite + 1) % 3; // its next corner is the edge's other end
  return m_slopes[at(prism)][at(2 * corner)].straight;
}

SurfaceWeights SmoothSkin::surface_weights(int prism, const Vec3& L) const
{
  const std::array<int, 12> all = controls(prism);
  SurfaceWeights weights;
  std::copy_n(all.begin(), 9, weights.control.begin());
  weights.weight = face_map(prism) * face_functions(L).value;
  return weights;
}

SurfacePoint SmoothSkin::surface_point(int prism, const Vec3& L, const std::vector<Vec3>& x) const
{
  const std::array<int, 12> all = controls(prism);
  Eigen::Matrix<double, 3, 9> top;
  for (int i = 0; i < 9; ++i)
    top.col(i) = x[at(all[at(i)])];
  const Eigen::Matrix<double, 3, FaceFunctions::count> points = top * face_map(prism);
  const FaceFunctions f = face_functions(L);
  const Mat3 slope = points * f.slope;
  const Vec3 along = slope.col(1) - slope.col(0), across = slope.col(2) - slope.col(0);
  return {points * f.value, along.cross(across).stableNormalized()};
}

} // namespace f2b
