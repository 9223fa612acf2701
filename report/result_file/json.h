#pragma once
// The whole document as JSON, for other programs and for rendering again without calculation.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// As result.schema.json says. "format": "luxgate-result", "format_version": 1 (raised when a key
// changes its meaning or goes away; keys may be added). Units are in the key names; a finding
// states its "unit" itself (lx or
// "" for ratios). Values that were sampled are {"value", "low", "high"}; what is not a finite
// number is null. Key order and bytes depend on the document only. UTF-8; broken text becomes
// U+FFFD.
std::unique_ptr<FormatWriter> json_writer(const DocumentFrame& frame, const SpillPlace& place);

}  // namespace report
