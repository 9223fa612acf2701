#pragma once
// Assigns the variants of a sweep to shards. The choice only affects the total time.
//
// Variants that differ only in values without effect on light (limits, maintenance factors, prices)
// need the same sampling rounds: they share a light, and all go to one shard, so that no two shards
// compute the same. Lights are cut into as many pieces as there are shards in the order of their
// variants, of equal size to within one light: neighbours have one more value in common.

#include "report/tools/check/check_options.h"
#include "report/tools/sweep/vary.h"

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace cli {

// Returns for each path whether its values change light. keys_of: the first store keys of a
// variant, which contain all that its light depends on. A few values of each path are tried, with
// the first values of all other paths.
std::vector<bool> paths_of_light(
    const std::vector<Vary>& vary,
    const std::function<std::set<std::string>(std::size_t variant)>& keys_of);

// Returns the variants, ascending. is_of_light: for each path.
std::vector<std::size_t> variants_of_shard(const std::vector<Vary>& vary,
                                           const std::vector<bool>& is_of_light,
                                           const BatchShare& share);

}  // namespace cli
