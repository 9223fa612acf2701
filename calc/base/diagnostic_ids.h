#pragma once
// The ids of all messages about input. They are apart from diagnostics.h so that a new id
// recompiles only the files that report something.

#include "calc/base/diagnostics.h"

#include <cstdint>

namespace calc {

enum class DiagnosticId : std::uint16_t {
#define LUXGATE_DIAGNOSTIC(id, severity, text) id,
#include "calc/base/diagnostics.def"
#undef LUXGATE_DIAGNOSTIC
};

}  // namespace calc
