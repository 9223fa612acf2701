#pragma once
// The projects of a run as they were in a git revision: `check --against`.

#include "calc/base/file_reader.h"
#include "calc/base/message.h"
#include "report/check/run.h"
#include "report/document/document.h"
#include "report/git/git_tree_reader.h"
#include "report/shell/options/project_options.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cli {

class OldState {
 public:
  // Returns the same projects, each from its own repository. now: reads the current files. Empty
  // after an error, which is printed.
  static std::optional<OldState> open_or_print(const ProjectOptions& input,
                                               const std::string& revision,
                                               const git::GitPlaces& places,
                                               const calc::FileReader& now);

  // Returns the part of a project. run: with the files and the rule packs of the revision.
  // shown_path: "main:designs/a.xml".
  using CheckOne = std::function<report::ProjectPart(const std::string& path, const check::Run& run,
                                                     const std::string& shown_path)>;
  // Returns the projects that existed, by their current paths; a project that could not be read or
  // judged then is included and not judged. Errors are printed for "REVISION:path". Empty if
  // something that the revision contains could not be read; that is printed. run: the current run,
  // except for files and packs; check_one is called for several projects at the same time. go_on:
  // called before each project; after false the rest is missing.
  std::optional<std::vector<report::ProjectPart>> check(const check::Run& run,
                                                        const CheckOne& check_one,
                                                        const std::function<bool()>& go_on) const;
  // Returns whether it is HEAD, with nothing staged, and has the same rule files: other files of
  // the projects may still differ.
  bool is_unchanged_head(const calc::FileReader& now) const;
  // Returns the number of calls of check_one by check().
  std::size_t project_count() const;

  // Returns full ids of the commits, one for each repository, in the order of the projects.
  std::vector<std::string> commits() const;
  // Returns notes on files that were missing, are missing now, or had another name; rule files
  // included.
  const std::vector<calc::Message>& notes() const { return notes_; }

 private:
  struct Project {
    std::string path, path_then;
    const git::GitTreeReader* files = nullptr;
    bool is_there_now = true, was_there = true;
    bool is_gone = false;  // of a folder that is asked for
    // Returns whether to check it; removed projects, too, because another project may replace it
    // now and require less.
    bool is_checked() const { return was_there && (is_there_now || is_gone); }
  };

  std::size_t failures() const;
  const git::GitTreeReader* open(const std::string& project, const git::GitPlaces& places,
                                 std::string& problem);
  // Returns "" or what is too large to be searched.
  std::string find_moved(const calc::FileReader& now);
  std::string find_gone(const std::vector<std::string>& folders);
  std::string problem_with_settings(const ConfigChoice& choice) const;
  std::string open_submodules(const std::vector<std::string>& folders);
  void find_rules(const std::vector<std::string>& paths, const git::GitPlaces& places);
  const git::GitTreeReader* repository_of(const std::string& path) const;
  std::string shown(const std::string& file, const git::GitTreeReader* files) const;
  void print_errors(const std::vector<calc::Diagnostic>& diagnostics) const;

  std::string revision_;
  std::vector<std::unique_ptr<git::GitTreeReader>> repositories_;
  std::vector<Project> projects_;
  std::vector<std::string> rule_files_;
  std::vector<calc::Message> notes_;
};

}  // namespace cli
