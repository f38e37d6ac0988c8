#pragma once

#include "Core/sculpting/brush_area.hpp"
#include "Core/sculpting/stroke_history.hpp"

/// How does the surgeon shape the target face, stroke by stroke?
namespace f2b
{

/// Sculpts the displacement of one reference skin. Frame RAS, mm.
///
/// A stroke is begun, moved any number of times and ended; what it changed is undone as one. Skin
/// with a mask m moves by 1 - m of what a brush does; at m = 1 exactly not at all.
class SculptingSession
{
public:
  /// \param displacement  to go on from, one per vertex; empty: the patient's own face
  /// Throws Error as SculptedSkin does.
  explicit SculptingSession(TriangleMesh reference, std::vector<Vec3> displacement = {});

  const SculptedSkin& skin() const { return m_skin; }
  /// Counts changes of displacement or mask; the same number is the same face.
  long revision() const { return m_revision; }

  /// \param view  unit, from the viewer into the picture; zero: seen from everywhere
  /// Ends a stroke that is going on. Brushes that do not drag make their first dab.
  void begin_stroke(const Brush& brush, const SurfacePlace& place, const Vec3& view);
  /// Grabs: moves the skin that the stroke began on to `drag` from where it began [mm].
  void drag(const Vec3& drag);
  /// Other brushes: acts once more, at another place.
  void dab(const SurfacePlace& place);

  /// A stroke that moves points of the present skin by a smooth warp (LandmarkWarp).
  /// \param radius_mm  no effect farther than this from all points
  void begin_warp(std::vector<Vec3> from, double radius_mm, const std::string& name);
  /// Throws Error as LandmarkWarp does; the skin is then as before.
  void drag_warp(const std::vector<Vec3>& to);

  void end_stroke();
  /// Takes back what the stroke that is going on has done.
  void cancel_stroke();
  bool in_stroke() const { return m_stroking; }

  /// Another face on the same vertices, as one stroke. Throws Error on an unfit displacement.
  void replace(const std::vector<Vec3>& displacement, const std::string& name);
  /// Sets every vertex's mask, as one stroke.
  void fill_mask(double value);
  void invert_mask();

  const StrokeHistory& history() const { return m_history; }
  /// \return false if there is nothing to undo, or a stroke is going on
  bool undo();
  bool redo();

private:
  void open(const std::string& name);
  void remember(int vertex);
  void change(int vertex, const SkinVertex& state);
  void move_to(const BrushedVertex& brushed, const Vec3& displacement);
  void settle();
  void draw(const BrushArea& area);
  void smooth(const BrushArea& area);
  void flatten(const BrushArea& area);
  void blend(const BrushArea& area);

  SculptedSkin m_skin;
  GeodesicDistance m_distances;
  StrokeHistory m_history;
  long m_revision = 0;

  // the stroke that is going on
  bool m_stroking = false;
  std::string m_name;
  Brush m_brush;
  Vec3 m_view = Vec3::Zero();
  BrushArea m_area; ///< of a grab
  std::vector<Vec3> m_warp_from;
  double m_warp_radius_mm = 0;
  std::vector<int> m_touched;       ///< vertices that the stroke may have changed
  std::vector<SkinVertex> m_before; ///< their states before it
  std::vector<int> m_slot;          ///< per vertex: where in m_touched, or -1
  std::vector<int> m_moved;         ///< since the last settling
};

/// A name for menus: "Grab", "Draw".
std::string name_of(BrushKind kind);

} // namespace f2b
