#pragma once
// What the calculation may leave out, each only when a predicate proves that nothing changes.
// [METHOD, 8.3]

#include "calc/base/names.h"

#include <bitset>
#include <cstddef>
#include <iterator>

namespace calc {

enum class Skip : std::size_t {
  no_reflection,   // every reflectance is 0: no indirect light at all
  behind_plane,    // every reflecting surface lies behind a plane: no indirect light there
  unlit_surfaces,  // a luminaire's beam cannot reach a reflecting surface: no light paths from it
  dark_pairs,      // a luminaire's beam cannot reach a plane, or comes from behind: no direct term
  convex,          // nothing can stand between two points of a convex space: no shadow rays
  hidden_nodes,    // groups of light vertices behind a point or facing away are not weighed
  clear_distance,  // no surface near enough for the near-field part: no short rays
  decided_points,  // points that no open verdict needs take no further samples
};

// As --no-skip and the plan name them.
template <>
struct EnumNames<Skip> {
  static constexpr EnumName<Skip> list[] = {{Skip::no_reflection, "no-reflection"},
                                            {Skip::behind_plane, "behind-plane"},
                                            {Skip::unlit_surfaces, "unlit-surfaces"},
                                            {Skip::dark_pairs, "dark-pairs"},
                                            {Skip::convex, "convex"},
                                            {Skip::hidden_nodes, "hidden-nodes"},
                                            {Skip::clear_distance, "clear-distance"},
                                            {Skip::decided_points, "decided-points"}};
};
inline constexpr std::size_t kSkips = std::size(EnumNames<Skip>::list);
static_assert(static_cast<std::size_t>(EnumNames<Skip>::list[kSkips - 1].value) == kSkips - 1,
              "every skip has a name: SkipSet counts on it");

// The skips that are allowed.
class SkipSet {
 public:
  SkipSet() { allowed_.set(); }
  bool allows(Skip skip) const { return allowed_[static_cast<std::size_t>(skip)]; }
  void forbid(Skip skip) { allowed_.reset(static_cast<std::size_t>(skip)); }
  void forbid_all() { allowed_.reset(); }
  friend bool operator==(const SkipSet&, const SkipSet&) = default;

 private:
  std::bitset<kSkips> allowed_;
};

}  // namespace calc
