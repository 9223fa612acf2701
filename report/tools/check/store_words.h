#pragma once
// What a run has to say of its store, to standard error alone: nothing of a store is in a result,
// nor does --strict count it.

#include "calc/store/entry_folder.h"

#include <string>

namespace cli {

void print_troubles(const std::string& folder, const calc::StoreTroubles& troubles);

}  // namespace cli
