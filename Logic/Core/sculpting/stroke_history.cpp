#include "Core/sculpting/stroke_history.hpp"

namespace f2b
{
namespace
{

void restore(SculptedSkin& skin, const std::vector<int>& vertices,
             const std::vector<SkinVertex>& states)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
    skin.set(vertices[i], states[i]);
  skin.settle(vertices);
}

} // namespace

void StrokeHistory::add(Stroke stroke)
{
  while (m_strokes.size() > m_done)
  {
    m_states -= 2 * m_strokes.back().vertices.size();
    m_strokes.pop_back();
  }
  m_states += 2 * stroke.vertices.size();
  m_strokes.push_back(std::move(stroke));
  std::size_t forgotten = 0;
  while (m_states > m_most_states && forgotten + 1 < m_strokes.size())
    m_states -= 2 * m_strokes[forgotten++].vertices.size();
  m_strokes.erase(m_strokes.begin(), m_strokes.begin() + static_cast<std::ptrdiff_t>(forgotten));
  m_done = m_strokes.size();
}

bool StrokeHistory::undo(SculptedSkin& skin)
{
  if (!can_undo())
    return false;
  const Stroke& stroke = m_strokes[--m_done];
  restore(skin, stroke.vertices, stroke.before);
  return true;
}

bool StrokeHistory::redo(SculptedSkin& skin)
{
  if (!can_redo())
    return false;
  const Stroke& stroke = m_strokes[m_done++];
  restore(skin, stroke.vertices, stroke.after);
  return true;
}

} // namespace f2b
