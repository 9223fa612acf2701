#pragma once
// Compares a document with an earlier one: worse results, weaker requirements, changed inputs.

#include "report/document/document.h"
#include "report/document/revision.h"

#include <string>

namespace report {

// Returns the revision. baseline: the file that `before` was read from.
Revision revise(const Document& before, const Document& after, const std::string& baseline,
                const Gate& gate);

}  // namespace report
