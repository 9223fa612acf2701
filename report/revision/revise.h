#pragma once
// A document beside an earlier one: what got worse, what is asked less, what has changed.

#include "report/document/document.h"
#include "report/document/revision.h"

#include <string>

namespace report {

// baseline: the file that `before` was read from.
Revision revise(const Document& before, const Document& after, const std::string& baseline,
                const Gate& gate);

}  // namespace report
