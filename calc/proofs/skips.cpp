#include "calc/proofs/skips.h"

#include <algorithm>
#include <array>

namespace calc {
namespace {

// In the order of the enumeration.
constexpr std::array<std::string_view, kSkips> kNames{
    "no-reflection", "behind-plane", "unlit-surfaces", "dark-pairs",
    "convex",        "hidden-nodes", "clear-distance", "decided-points"};

}  // namespace

std::string_view skip_name(Skip skip) { return kNames[static_cast<std::size_t>(skip)]; }

std::optional<Skip> find_skip(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Skip>(found - kNames.begin());
}

}  // namespace calc
