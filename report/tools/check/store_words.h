#pragma once
// Messages of a run about its store, only to standard error: results do not mention a store, and
// --strict does not count it.

#include "calc/store/entry_folder.h"
#include "report/document/document.h"

#include <cstddef>
#include <string>

namespace cli {

// Most names of planes without light in an error.
inline constexpr std::size_t kMostLackingNamed = 100;

// Returns whether it is not judged because a store without further calculation lacks its light.
bool lacks_light(const report::PlanePart& plane);

void print_troubles(const std::string& folder, const calc::StoreTroubles& troubles);
// Returns whether all light is stored. For a shard missing light is an error, because its light is
// then lost.
bool is_light_kept_or_print(const std::string& folder, const calc::StoreTroubles& troubles);

}  // namespace cli
