#pragma once
// What result files look like, for validators.

#include <string_view>

namespace report {

// JSON Schema (draft 7) of render_json(): result.schema.json, embedded when the build is
// configured.
std::string_view result_schema();

}  // namespace report
