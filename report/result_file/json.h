#pragma once
// Writes the whole document as JSON, for other programs and for rendering again without
// calculation.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// Writes JSON as result.schema.json describes it. "format": "luxgate-result", "format_version": 1
// (raised when a key changes its meaning or is removed; keys may be added). Units are in the key
// names; a finding states its "unit" itself (lx or "" for ratios). Sampled values are {"value",
// "low", "high"}; a number that is not finite is null. Key order and bytes depend on the document
// only. UTF-8; broken text becomes U+FFFD.
std::unique_ptr<FormatWriter> json_writer(const DocumentFrame& frame, const SpillPlace& place);

}  // namespace report
