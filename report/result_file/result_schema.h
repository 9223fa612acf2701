#pragma once
// What result files look like, for validators.

#include <string>

namespace report {

// JSON Schema (draft 7) of json_writer(), made of result_fields.h. result.schema.json is what it
// was when that file was written last; a test compares them.
std::string result_schema();

}  // namespace report
