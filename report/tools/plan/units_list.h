#pragma once
// Jobs of a batch as a table and as a file: `luxgate plan --units`, `luxgate check --units`.

#include "calc/base/file_reader.h"
#include "report/check/units.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// Returns a table. units: in the order of their projects.
std::string render_units_text(const std::vector<check::Unit>& units);
std::string render_units_json(const std::vector<check::Unit>& units);

// Returns the units written by render_units_json(), to the bit. Empty: `problem` says what is wrong
// with the file.
std::optional<std::vector<check::Unit>> read_units(const std::string& file,
                                                   const calc::FileReader& files,
                                                   std::string& problem);

}  // namespace cli
