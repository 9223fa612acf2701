#pragma once
// Steps that the calculation may leave out, each only when a predicate proves that nothing changes.
// [METHOD, 8.3]
// solve_plan.cpp decides and explains each of them.

#include "calc/base/names.h"

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

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

// Names for --no-skip and the plan.
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

// applies: proved, at least for a part; while_calculating: the proof is tried point by point during
// the calculation; not_needed: another skip leaves nothing to skip; forbidden: by the settings.
enum class SkipState { applies, not_proved, while_calculating, not_needed, forbidden };

template <>
struct EnumNames<SkipState> {
  static constexpr EnumName<SkipState> list[] = {
      {SkipState::applies, "applies"},
      {SkipState::not_proved, "not proved"},
      {SkipState::while_calculating, "while calculating"},
      {SkipState::not_needed, "not needed"},
      {SkipState::forbidden, "forbidden"}};
};

// The decision about a skip in a space.
struct SkipDecision {
  Skip skip;
  SkipState state = SkipState::not_proved;
  std::string why;                    // one sentence, no full stop
  std::vector<std::string> planes;    // ids of the planes it is complete for; empty: not by plane
  std::size_t luminaires = 0;         // unlit_surfaces: how many; dark_pairs: pairs
  std::optional<std::uint32_t> body;  // convex: index into Space::bodies of what stands inside
};

}  // namespace calc
