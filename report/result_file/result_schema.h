#pragma once
// The schema of result files, for validators.

#include <string>

namespace report {

// Returns the JSON Schema (draft 7) of json_writer(), made of result_fields.h. result.schema.json
// is its last written version; a test compares them.
std::string result_schema();

}  // namespace report
