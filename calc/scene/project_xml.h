#pragma once
// project.xml to Project. Strict: whatever is not known is an error with line, column and a
// suggestion.

#include "calc/diagnostics.h"
#include "calc/file_reader.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Reads the project and every file it names (photometry, meshes, point lists; only beside the
// project file or below it). All problems are reported, not only the first; empty if and only if at
// least one of them is an error.
std::optional<Project> load_project(const FileReader& files, const std::string& path,
                                    Diagnostics& diagnostics);

// The published XML schema (XSD 1.0) of the project file.
std::string_view project_schema();

}  // namespace calc
