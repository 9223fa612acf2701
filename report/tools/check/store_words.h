#pragma once
// What a run has to say of its store, to standard error alone: nothing of a store is in a result,
// nor does --strict count it.

#include "calc/store/entry_folder.h"
#include "report/document/document.h"

#include <cstddef>
#include <string>

namespace cli {

// Names of what lacks light in an error.
inline constexpr std::size_t kMostLackingNamed = 100;

// Whether it is not judged since its light is not in a store that is all there is.
bool lacks_light(const report::PlanePart& plane);

void print_troubles(const std::string& folder, const calc::StoreTroubles& troubles);
// Of a shard, whose light is lost unless the store has it: then an error. Whether all is kept.
bool is_light_kept_or_print(const std::string& folder, const calc::StoreTroubles& troubles);

}  // namespace cli
