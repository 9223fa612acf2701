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
  // Of the same projects, each in the repository in which it lies. now: reads the files of today.
  // Empty after an error, which has been printed.
  static std::optional<OldState> open_or_print(const ProjectOptions& input,
                                               const std::string& revision,
                                               const git::GitPlaces& places,
                                               const calc::FileReader& now);

  // Its part. run: with the files and the rule packs of the revision. shown_path:
  // "main:designs/a.xml".
  using CheckOne = std::function<report::ProjectPart(const std::string& path, const check::Run& run,
                                                     const std::string& shown_path)>;
  // Projects that were there, by their paths of today; one that could not be read or judged then is
  // there and not judged. Errors are printed as of "REVISION:path". Empty where something could not
  // be had that the revision holds; it has been printed. run: the one of today but for these;
  // check_one is called for several at the same time. go_on: asked before each project; once it is
  // false the rest is missing.
  std::optional<std::vector<report::ProjectPart>> check(const check::Run& run,
                                                        const CheckOne& check_one,
                                                        const std::function<bool()>& go_on) const;
  // Whether it is HEAD, with nothing staged, and has the same rule files: what was read for the
  // projects may still differ.
  bool is_unchanged_head(const calc::FileReader& now) const;
  // That check() will call check_one for.
  std::size_t project_count() const;

  // Full ids of the commits, one for each repository, in the order of the projects.
  std::vector<std::string> commits() const;
  // What was not there, is not there now, or had another name; about rule files, too.
  const std::vector<calc::Message>& notes() const { return notes_; }

 private:
  struct Project {
    std::string path, path_then;
    const git::GitTreeReader* files = nullptr;
    bool is_there_now = true, was_there = true;
    bool is_gone = false;  // of a folder that is asked for
    // What is gone, too: another project may stand for it now, and ask for less.
    bool is_checked() const { return was_there && (is_there_now || is_gone); }
  };

  std::size_t failures() const;
  const git::GitTreeReader* open(const std::string& project, const git::GitPlaces& places,
                                 std::string& problem);
  // "" or what is too much to be looked through.
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
