#pragma once
// Reads project.xml as a Project. Strict: everything unknown is an error with line, column and a
// suggestion.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// With errors, a project serves only to find more errors in the same run, in other folders. All its
// planes and workplaces are there, even faulty ones.
struct ReadProject {
  Project project;
  bool is_good = false;  // no error was reported
};

// Reads the project and every file it names (photometry, meshes, point lists; only beside the
// project file or below it), except the meaning of requirements, which rules/ reads. Reports all
// problems, not only the first. Empty after an error if the file is not a project, or if it would
// take more memory than the budget allows.
std::optional<ReadProject> read_project(const FileReader& files, const std::string& path,
                                        Diagnostics& diagnostics, const Budget& budget = {});

// Returns only a project without errors: empty if and only if there is an error. Errors are in the
// order of lines.
std::optional<Project> load_project(const FileReader& files, const std::string& path,
                                    Diagnostics& diagnostics);

}  // namespace calc
