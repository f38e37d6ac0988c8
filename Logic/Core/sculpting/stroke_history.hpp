#pragma once

#include "Core/sculpting/sculpted_skin.hpp"

#include <string>

/// How is a stroke taken back, to the last bit?
namespace f2b
{

/// One change of the skin: vertices with their states before and after it.
struct Stroke
{
  std::string name; ///< for a menu: "Grab"
  std::vector<int> vertices;
  std::vector<SkinVertex> before, after;
};

/// Strokes that can be taken back and done again. The oldest are forgotten when all together
/// remember more than `most_states` vertex states (32 bytes each).
class StrokeHistory
{
public:
  explicit StrokeHistory(std::size_t most_states = 16'000'000) : m_most_states(most_states) {}

  /// Forgets what was undone.
  void add(Stroke stroke);
  bool can_undo() const { return m_done > 0; }
  bool can_redo() const { return m_done < m_strokes.size(); }
  /// Name of what undo or redo would change; empty if there is nothing.
  std::string undo_name() const { return can_undo() ? m_strokes[m_done - 1].name : std::string(); }
  std::string redo_name() const { return can_redo() ? m_strokes[m_done].name : std::string(); }
  bool undo(SculptedSkin& skin);
  bool redo(SculptedSkin& skin);

private:
  std::size_t m_most_states, m_states = 0;
  std::vector<Stroke> m_strokes;
  std::size_t m_done = 0; ///< of them; the others were undone
};

} // namespace f2b
