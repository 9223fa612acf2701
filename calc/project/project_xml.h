#pragma once
// project.xml to Project. Strict: whatever is not known is an error with line, column and a
// suggestion.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// With errors a project is good for one thing: that those who know more than this folder find
// theirs in the same run. Its planes and workplaces are all there, whatever is wrong with them.
struct ReadProject {
  Project project;
  bool is_good = false;  // no error was reported
};

// Reads the project and every file it names (photometry, meshes, point lists; only beside the
// project file or below it), but for the meaning of requirements, which rules/ knows. All problems
// are reported, not only the first. Empty after an error if the file is no project at all, or one
// that would take more memory than the budget has.
std::optional<ReadProject> read_project(const FileReader& files, const std::string& path,
                                        Diagnostics& diagnostics, const Budget& budget = {});

// The same for those who want the scene only: empty if and only if there is an error, and errors
// are in the order of lines.
std::optional<Project> load_project(const FileReader& files, const std::string& path,
                                    Diagnostics& diagnostics);

}  // namespace calc
