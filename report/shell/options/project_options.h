#pragma once
// The projects of a command, and the packs that judge them.

#include "report/shell/command/command.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// The projects, --files-from, --rules, --allow, --config and --verbose.
struct ProjectOptions {
  std::vector<std::string> projects;
  std::string list_file;  // of more projects, "-" = standard input; "" = none
  std::vector<std::string> rule_files;
  std::vector<std::string> allowed;       // folders that links in those of projects may lead into
  std::vector<std::string> folders = {};  // among the projects, before these took their place
  ConfigChoice config = {};
  bool is_verbose = false;  // says which files are read
  bool takes_standard_input = false;
  std::optional<std::string> standard_input = {};  // its bytes, if a project is "-"
  std::string standard_input_file = {};            // that it was sent from, if it is one; else ""
};
Place projects_place(ProjectOptions& options);
// Returns --files-from, --rules, --allow, --config, --no-config and --verbose.
std::vector<Option> project_options(ProjectOptions& options);

// Reads standard input, if it is named. Adds the projects of the list behind the others, and
// replaces folders by their projects. Returns "", or what is wrong: a read error, no project, a
// project given twice, or an id that was meant for --strict.
std::string complete_projects(ProjectOptions& options);

// Returns the files and folders from which they are read: the folder of each project with all below
// it, rule files, folders of --allow.
std::vector<std::string> places_of(const ProjectOptions& options);

// Returns a list for --files-from: a path a line. If a path contains a line break, a byte 0 follows
// each path instead.
std::string render_project_list(const std::vector<std::string>& projects);
// Returns the paths of such a list without empty lines and the endings of lines and files that
// Windows adds. Empty: `problem` says what is wrong.
std::vector<std::string> parse_project_list(const std::string& bytes, std::string& problem);

}  // namespace cli
