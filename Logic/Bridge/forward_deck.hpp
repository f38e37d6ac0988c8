#pragma once

#include "Core/models/forward_problem.hpp"

#include <string>
#include <vector>

/// What does another engine need to know of a forward problem, whatever its file's form?
namespace f2b
{

struct DeckOptions
{
  std::string title;   ///< one line: what it is
  int increments = 10; ///< equal shares of the movement
};

/// Elements of one shape and tissue. Wedges: 0-2 below, 3-5 on the face, so that the triangle 0-2
/// has its normal towards 3-5, as Abaqus, CalculiX and FEBio number them.
struct ElementBlock
{
  Tissue tissue = Tissue::Skin;
  int corners = 4; ///< 4 or 6
  int first = 1;   ///< number of its first element; they count on from there
  std::vector<std::array<int, 6>> elements;
};
std::vector<ElementBlock> element_blocks(const MixedMesh& mesh);

/// A part of the boundary with a name that every engine can read.
struct NodeSet
{
  std::string name; ///< upper case, digits and underscores
  bool held = false;
  int fragment = -1; ///< whose nodes they are
  std::vector<int> nodes;
};
/// FIXED_BONE, CROP, SKIN, FREE, and FRAGMENT_1_NAME, ...; those that hold no node are left out.
std::vector<NodeSet> boundary_sets(const MixedMesh& mesh);

const char* tissue_name(Tissue tissue);

/// What the deck says of itself, a line each: title, units, element kinds, movements.
std::vector<std::string> deck_remarks(const ForwardProblem& problem, const std::string& title);

/// The text of a number, with so many digits after the point (%.Ne).
std::string scientific(double value, int digits);

} // namespace f2b
