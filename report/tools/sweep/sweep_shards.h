#pragma once
// Which variants of a sweep a shard does. Nothing but the time that all shards take hangs on it.
//
// Variants that differ only in what changes no light (limits, maintenance factors, prices) need the
// same looks: they are of one light, and all go to one shard, so that no two shards compute the
// same. Lights are cut into as many pieces as there are shards in the order of their variants,
// alike to within one light: neighbours have one more value in common.

#include "report/tools/check/check_options.h"
#include "report/tools/sweep/vary.h"

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace cli {

// For each path, whether its values change light. keys_of: what a variant asks a store for at
// first, which says all that its light depends on. A few values of each path are asked for, with
// the first ones of all others.
std::vector<bool> paths_of_light(
    const std::vector<Vary>& vary,
    const std::function<std::set<std::string>(std::size_t variant)>& keys_of);

// Ascending. is_of_light: for each path.
std::vector<std::size_t> variants_of_shard(const std::vector<Vary>& vary,
                                           const std::vector<bool>& is_of_light,
                                           const BatchShare& share);

}  // namespace cli
