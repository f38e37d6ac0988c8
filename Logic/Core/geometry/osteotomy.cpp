#include "Core/geometry/osteotomy.hpp"

#include "Core/geometry/lattice_cuts.hpp"
#include "Core/geometry/saw_blade.hpp"

#include "Core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace f2b
{

bool BoundedPlane::faces(const Vec3& p, double margin_mm) const
{
  const Vec3 d = p - center;
  return std::abs(d.dot(u)) <= half_u + margin_mm && std::abs(d.dot(v)) <= half_v + margin_mm;
}

bool BoundedPlane::separates(const Vec3& p, const Vec3& q, Vec3& at) const
{
  const double a = signed_distance(p), b = signed_distance(q);
  if ((a >= 0) == (b >= 0))
    return false;
  at = p + (q - p) * (a / (a - b));
  return faces(at, 0);
}

namespace
{

using Label = unsigned char;
constexpr Label undecided = 255;
/// Connected bone smaller than this is an island: noise, or thin walls that the threshold broke.
constexpr double island_mm3 = 1500;

/// Floods the bone voxel by voxel, stopped by the cuts.
class Flood
{
public:
  Flood(const ScalarGrid& bone, const ScalarGrid& closed_bone, const std::vector<Osteotomy>& cuts)
      : m_bone(bone), m_closed(closed_bone), m_osteotomies(cuts), m_cuts(bone, cuts)
  {
  }

  BonePartition run();

private:
  Vec3 position(std::size_t voxel) const
  {
    const auto x = static_cast<std::size_t>(m_bone.size.x()),
               y = static_cast<std::size_t>(m_bone.size.y());
    return m_bone.position(static_cast<int>(voxel % x), static_cast<int>(voxel / x % y),
                           static_cast<int>(voxel / (x * y)));
  }
  bool is_bone(std::size_t voxel) const { return m_bone.values[voxel] < 0; }
  bool is_closed_bone(std::size_t voxel) const
  {
    return m_closed.values[voxel] < 0 || is_bone(voxel);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t voxel, Visit visit) const;
  void find_components();
  int component_at(const Osteotomy& osteotomy) const;
  void name_components();
  void spread();
  void collect_cuts();
  void require_freed() const;
  std::ptrdiff_t core_near(const Vec3& place, int component) const;
  std::string way_round(std::size_t cut) const;

  const ScalarGrid& m_bone;
  const ScalarGrid& m_closed;
  const std::vector<Osteotomy>& m_osteotomies;
  LatticeCuts m_cuts;
  std::vector<int> m_component;     ///< per voxel: connected actual bone, or -1
  std::vector<std::size_t> m_sizes; ///< voxels per component
  std::vector<Label> m_label;       ///< per voxel
  BonePartition m_result;
};

template <class Visit>
void Flood::for_each_neighbor(std::size_t voxel, Visit visit) const
{
  const auto nx = static_cast<std::size_t>(m_bone.size.x()),
             ny = static_cast<std::size_t>(m_bone.size.y()),
             nz = static_cast<std::size_t>(m_bone.size.z());
  const std::size_t i = voxel % nx, j = voxel / nx % ny, k = voxel / (nx * ny);
  // visit(neighbour, does a cut pass between them)
  if (i > 0)
    visit(voxel - 1, m_cuts.between(voxel - 1, 0));
  if (i + 1 < nx)
    visit(voxel + 1, m_cuts.between(voxel, 0));
  if (j > 0)
    visit(voxel - nx, m_cuts.between(voxel - nx, 1));
  if (j + 1 < ny)
    visit(voxel + nx, m_cuts.between(voxel, 1));
  if (k > 0)
    visit(voxel - nx * ny, m_cuts.between(voxel - nx * ny, 2));
  if (k + 1 < nz)
    visit(voxel + nx * ny, m_cuts.between(voxel, 2));
}

void Flood::find_components()
{
  m_component.assign(m_bone.values.size(), -1);
  std::vector<std::size_t> front;
  for (std::size_t start = 0; start < m_component.size(); ++start)
  {
    if (!is_bone(start) || m_component[start] >= 0)
      continue;
    const int id = static_cast<int>(m_sizes.size());
    m_sizes.push_back(0);
    m_component[start] = id;
    front.assign(1, start);
    while (!front.empty())
    {
      const std::size_t voxel = front.back();
      front.pop_back();
      ++m_sizes.back();
      for_each_neighbor(voxel,
                        [&](std::size_t next, bool cut)
                        {
                          if (cut || !is_bone(next) || m_component[next] >= 0)
                            return;
                          m_component[next] = id;
                          front.push_back(next);
                        });
    }
  }
}

/// The connected bone, not an island, that lies nearest to the fragment's point.
int Flood::component_at(const Osteotomy& osteotomy) const
{
  constexpr double reach_mm = 10;
  double nearest = reach_mm;
  int found = -1;
  const double voxel_mm3 = std::pow(m_bone.spacing, 3);
  for (std::size_t voxel = 0; voxel < m_component.size(); ++voxel)
  {
    const int id = m_component[voxel];
    if (id < 0 ||
        static_cast<double>(m_sizes[static_cast<std::size_t>(id)]) * voxel_mm3 < island_mm3)
      continue;
    const double distance = (position(voxel) - osteotomy.fragment_point).norm();
    if (distance < nearest)
    {
      nearest = distance;
      found = id;
    }
  }
  if (found < 0)
    throw Error(
        "osteotomy '" + osteotomy.fragment + "'",
        "no connected bone of at least 1.5 cm3 lies within 10 mm of its fragment point",
        "move the fragment point (or the landmark that it comes from) onto the bone that is "
        "to be free, or check the planes");
  return found;
}

void Flood::name_components()
{
  const double voxel_mm3 = std::pow(m_bone.spacing, 3);
  std::vector<Label> name(m_sizes.size(), BonePartition::uncut);
  for (std::size_t id = 0; id < m_sizes.size(); ++id)
    if (static_cast<double>(m_sizes[id]) * voxel_mm3 < island_mm3)
      name[id] = undecided;
  for (std::size_t k = 0; k < m_osteotomies.size(); ++k)
  {
    const auto id = static_cast<std::size_t>(component_at(m_osteotomies[k]));
    if (name[id] != BonePartition::uncut)
      throw Error("osteotomies '" +
                      m_osteotomies[name[id] - BonePartition::first_fragment].fragment + "' and '" +
                      m_osteotomies[k].fragment + "'",
                  "free the same piece of bone", "add a plane between them, or remove one of them");
    name[id] = static_cast<Label>(BonePartition::first_fragment + k);
  }
  m_label.assign(m_component.size(), BonePartition::no_bone);
  for (std::size_t voxel = 0; voxel < m_label.size(); ++voxel)
    if (m_component[voxel] >= 0)
      m_label[voxel] = name[static_cast<std::size_t>(m_component[voxel])];
    else if (is_closed_bone(voxel))
      m_label[voxel] = undecided;
}

/// Gives cavities and islands the label of the nearest named bone, not through a cut where another
/// way exists.
void Flood::spread()
{
  for (const bool through_cuts : {false, true})
  {
    std::vector<std::size_t> front;
    for (std::size_t voxel = 0; voxel < m_label.size(); ++voxel)
      if (m_label[voxel] != BonePartition::no_bone && m_label[voxel] != undecided)
        front.push_back(voxel);
    while (!front.empty())
    {
      std::vector<std::size_t> next_front;
      for (const std::size_t voxel : front)
        for_each_neighbor(voxel,
                          [&](std::size_t next, bool cut)
                          {
                            if (m_label[next] != undecided || (cut && !through_cuts))
                              return;
                            m_label[next] = m_label[voxel];
                            next_front.push_back(next);
                          });
      front = std::move(next_front);
    }
  }
  for (Label& label : m_label)
    if (label == undecided)
      label = BonePartition::uncut;
}

/// Keeps the points of the cut faces.
void Flood::collect_cuts()
{
  m_result.cut_points.resize(m_osteotomies.size());
  const std::size_t step[3] = {1, static_cast<std::size_t>(m_bone.size.x()),
                               static_cast<std::size_t>(m_bone.size.x()) *
                                   static_cast<std::size_t>(m_bone.size.y())};
  for (std::size_t voxel = 0; voxel < m_label.size(); ++voxel)
  {
    if (m_label[voxel] == BonePartition::no_bone)
      continue;
    for_each_neighbor(
        voxel,
        [&](std::size_t next, bool cut)
        {
          if (next < voxel || m_label[next] == BonePartition::no_bone ||
              m_label[next] == m_label[voxel])
            return;
          const int axis = next - voxel == step[0] ? 0 : next - voxel == step[1] ? 1 : 2;
          const Vec3 at =
              cut ? m_cuts.passage(voxel, axis).at : Vec3(0.5 * (position(voxel) + position(next)));
          for (const Label label : {m_label[voxel], m_label[next]})
            if (label >= BonePartition::first_fragment)
              m_result.cut_points[label - BonePartition::first_fragment].push_back(at);
        });
  }
}

/// A voxel of a connected bone that lies deep in it, near a place; -1 where there is none.
std::ptrdiff_t Flood::core_near(const Vec3& place, int component) const
{
  constexpr double near_mm = 12;
  std::ptrdiff_t deepest = -1;
  for (std::size_t voxel = 0; voxel < m_component.size(); ++voxel)
    if (m_component[voxel] == component && (position(voxel) - place).norm() < near_mm &&
        (deepest < 0 || m_bone.values[voxel] < m_bone.values[static_cast<std::size_t>(deepest)]))
      deepest = static_cast<std::ptrdiff_t>(voxel);
  return deepest;
}

/// In words: where a cut is missing or too small. On the way through bone from the fragment to both
/// sides of a cut that is widest where it is narrowest, the narrowest place; of several the one that is
/// next to the fragment. Empty where no way leads there.
std::string Flood::way_round(std::size_t cut) const
{
  const std::size_t nx = static_cast<std::size_t>(m_bone.size.x()),
                    step[3] = {1, nx, nx * static_cast<std::size_t>(m_bone.size.y())};
  const auto depth = [this](std::size_t voxel) { return -m_bone.values[voxel]; };
  // where the cut goes through the thickest bone that is the fragment's on both sides
  std::size_t sides[2] = {0, 0};
  float thickest = 0;
  for (const LatticeCuts::Passage& p : m_cuts.passages())
  {
    const std::size_t next = p.sample + step[p.axis];
    if (p.cut == cut && std::min(depth(p.sample), depth(next)) > thickest &&
        m_component[p.sample] == m_component[next] &&
        m_label[p.sample] >= BonePartition::first_fragment)
    {
      thickest = std::min(depth(p.sample), depth(next));
      sides[0] = p.sample;
      sides[1] = next;
    }
  }
  if (thickest == 0)
    return "";
  const Osteotomy& osteotomy = m_osteotomies[m_label[sides[0]] - BonePartition::first_fragment];
  const std::ptrdiff_t start = core_near(osteotomy.fragment_point, m_component[sides[0]]);
  if (start < 0)
    return "";
  struct Way
  {
    float width; ///< at its narrowest
    std::size_t voxel, narrowest;
    bool operator<(const Way& other) const
    {
      return width != other.width ? width < other.width : voxel > other.voxel;
    }
  };
  constexpr float as_wide = 0.97F; // what is no narrower than this share is told of once
  std::vector<char> reached(m_component.size(), 0);
  std::priority_queue<Way> open;
  open.push({depth(static_cast<std::size_t>(start)), static_cast<std::size_t>(start),
             static_cast<std::size_t>(start)});
  while (!open.empty())
  {
    const Way way = open.top();
    open.pop();
    if (std::exchange(reached[way.voxel], 1))
      continue;
    if (reached[sides[0]] && reached[sides[1]])
    {
      const Vec3 at = position(way.narrowest);
      char place[96];
      std::snprintf(place, sizeof place,
                    ": bone leads round it, narrowest near R %.0f, A %.0f, S %.0f", at.x(), at.y(),
                    at.z());
      return place;
    }
    for_each_neighbor(
        way.voxel,
        [&](std::size_t next, bool through_cut)
        {
          if (through_cut || !is_bone(next) || reached[next])
            return;
          const bool narrower = depth(next) < as_wide * depth(way.narrowest);
          open.push({std::min(depth(next), way.width), next, narrower ? next : way.narrowest});
        });
  }
  return "";
}

/// Every cut passes through bone, and has the same fragment on both sides hardly anywhere.
void Flood::require_freed() const
{
  struct Sides
  {
    std::size_t hits = 0, through_fragment = 0;
  };
  std::vector<Sides> sides(m_cuts.cuts().size());
  const std::size_t nx = static_cast<std::size_t>(m_bone.size.x()),
                    step[3] = {1, nx, nx * static_cast<std::size_t>(m_bone.size.y())};
  // cuts of two osteotomies may lie in one another, as between the jaws: each counts
  for (const LatticeCuts::Passage& p : m_cuts.passages())
  {
    const std::size_t next = p.sample + step[p.axis];
    if (!is_bone(p.sample) || !is_bone(next))
      continue;
    ++sides[p.cut].hits;
    sides[p.cut].through_fragment +=
        m_label[p.sample] == m_label[next] && m_label[p.sample] >= BonePartition::first_fragment;
  }
  for (std::size_t c = 0; c < sides.size(); ++c)
  {
    const Sides& s = sides[c];
    const std::string& who = m_cuts.cuts()[c].who;
    if (s.hits == 0 && m_cuts.cuts()[c].may_miss)
      continue;
    if (s.hits == 0)
      throw Error(who, "it misses the bone", "move or enlarge it until it crosses the bone");
    char share[32];
    std::snprintf(share, sizeof share, "%.0f",
                  100.0 * static_cast<double>(s.through_fragment) / static_cast<double>(s.hits));
    if (static_cast<double>(s.through_fragment) > 0.3 * static_cast<double>(s.hits))
      throw Error(who,
                  "the cuts do not free the fragment: " + std::string(share) +
                      " % of this one has the same fragment on both sides" + way_round(c),
                  "enlarge the cuts or add one until they part the fragment from the skull");
  }
}

BonePartition Flood::run()
{
  m_result.osteotomies = m_osteotomies;
  find_components();
  name_components();
  spread();
  require_freed();
  collect_cuts();
  m_result.labels = {m_bone.origin, m_bone.spacing, m_bone.size, std::move(m_label)};
  m_result.fragment_volume_mm3.assign(m_osteotomies.size(), 0);
  for (std::size_t voxel = 0; voxel < m_bone.values.size(); ++voxel)
    if (is_bone(voxel) && m_result.labels.values[voxel] >= BonePartition::first_fragment)
      m_result.fragment_volume_mm3[m_result.labels.values[voxel] - BonePartition::first_fragment] +=
          std::pow(m_bone.spacing, 3);
  return std::move(m_result);
}

} // namespace

BonePartition cut_bone(const ScalarGrid& bone, const ScalarGrid& closed_bone,
                       const std::vector<Osteotomy>& osteotomies)
{
  return Flood(bone, closed_bone, osteotomies).run();
}

namespace
{

/// Voxels that the saw may touch: those near the cut faces. A plane drawn wider than its fragment
/// does not harm the bone beyond.
std::vector<char> near_cut_faces(const ScalarGrid& bone, const BonePartition& partition)
{
  std::vector<char> near(bone.values.size(), 0);
  for (std::size_t f = 0; f < partition.cut_points.size(); ++f)
  {
    const int reach = 2 + static_cast<int>(partition.osteotomies[f].kerf_mm / bone.spacing);
    for (const Vec3& point : partition.cut_points[f])
    {
      const Vec3 at = (point - bone.origin) / bone.spacing;
      for (int k = -reach; k <= reach; ++k)
        for (int j = -reach; j <= reach; ++j)
          for (int i = -reach; i <= reach; ++i)
          {
            const Eigen::Vector3i v(static_cast<int>(std::lround(at.x())) + i,
                                    static_cast<int>(std::lround(at.y())) + j,
                                    static_cast<int>(std::lround(at.z())) + k);
            if ((v.array() >= 0).all() && (v.array() < bone.size.array()).all())
              near[bone.index(v.x(), v.y(), v.z())] = 1;
          }
    }
  }
  return near;
}

/// The nearest saw that faces a point.
struct NearestSaw
{
  double distance = std::numeric_limits<double>::infinity(); ///< to its plane [mm]
  double half_kerf = 0;
};

NearestSaw nearest_saw(const Vec3& p, double margin_mm, const std::vector<SawFacet>& facets)
{
  NearestSaw saw;
  for (const SawFacet& facet : facets)
  {
    const double distance = std::abs(facet.plane.signed_distance(p));
    if (distance < saw.distance && facet.plane.faces(p, margin_mm))
      saw = {distance, 0.5 * facet.kerf_mm};
  }
  return saw;
}

} // namespace

ScalarGrid part_field(const ScalarGrid& bone, const BonePartition& partition, unsigned char label)
{
  ScalarGrid field = bone;
  const std::vector<char> near = near_cut_faces(bone, partition);
  const std::vector<SawFacet> facets = saw_facets(partition.osteotomies);
  std::size_t voxel = 0;
  for (int k = 0; k < bone.size.z(); ++k)
    for (int j = 0; j < bone.size.y(); ++j)
      for (int i = 0; i < bone.size.x(); ++i, ++voxel)
      {
        const unsigned char here = partition.labels.values[voxel];
        const bool other = here != label && here != BonePartition::no_bone;
        if (!near[voxel])
        {
          if (other)
            field.values[voxel] = std::max(bone.values[voxel], static_cast<float>(bone.spacing));
          continue;
        }
        const NearestSaw saw = nearest_saw(bone.position(i, j, k), 0.5 * bone.spacing, facets);
        const double beyond =
            saw.distance < 2 * bone.spacing ? saw.half_kerf + saw.distance : 0.5 * bone.spacing;
        const double cut = other ? beyond : saw.half_kerf - saw.distance;
        field.values[voxel] = std::max(bone.values[voxel], static_cast<float>(cut));
      }
  return field;
}

} // namespace f2b
