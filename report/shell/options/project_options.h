#pragma once
// The projects that a command is about, and the packs that they are judged by.

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
// --files-from, --rules, --allow, --config, --no-config and --verbose
std::vector<Option> project_options(ProjectOptions& options);

// Reads standard input, if that is meant. Adds the projects of the list behind the others, and puts
// those of folders in their place. "", or why not, or what is wrong with all: none is given, one is
// given twice, or is an id that was meant for --strict.
std::string complete_projects(ProjectOptions& options);

// Files and folders from which they are read: the folder of each project with all below it, rule
// files, folders of --allow.
std::vector<std::string> places_of(const ProjectOptions& options);

// A list that --files-from reads: a path a line. Where a path has a line break in it, each path has
// a byte 0 behind it instead.
std::string render_project_list(const std::vector<std::string>& projects);
// The paths of such a list; empty lines are left out, and so is what Windows puts at the ends of
// lines and files. Empty: `problem` says what is wrong.
std::vector<std::string> parse_project_list(const std::string& bytes, std::string& problem);

}  // namespace cli
