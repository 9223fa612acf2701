#pragma once
// Reads files as they were in a git revision, from the objects of the repository. Neither the work
// tree nor the index is touched, no program is started and nothing is fetched.

#include "calc/base/file_reader.h"
#include "report/git/git_places.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace git {

// One repository at one commit. Files have the bytes that a checkout would write, line ends
// included; files of Git LFS have their contents, if they are in the repository's LFS objects.
// Symbolic links are followed inside the repository only. Files in a submodule, files that a
// checkout would have other programs write, and files over 512 MiB are errors. Not thread-safe.
class GitTreeReader : public calc::FileReader {
 public:
  // Opens the repository in whose work tree `file` is; the file need not exist; linked work trees
  // and submodules have their own. revision: a commit as git names it: branch, tag, id, HEAD~1; or
  // "main...", the commit at which HEAD left main. Null, and `problem` says why and what is
  // allowed. In a submodule it is the commit to which the same revision of the surrounding
  // repository refers, because its own branches do not tell its earlier state; if it did not exist
  // then, the surrounding repository.
  static std::unique_ptr<GitTreeReader> open(const std::string& file, const std::string& revision,
                                             const GitPlaces& places, std::string& problem);
  // Opens the repository without the surrounding repository.
  static std::unique_ptr<GitTreeReader> open_alone(const std::string& file,
                                                   const std::string& revision,
                                                   const GitPlaces& places, std::string& problem);
  ~GitTreeReader() override;
  GitTreeReader(const GitTreeReader&) = delete;
  GitTreeReader& operator=(const GitTreeReader&) = delete;

  // Reads a file. Paths are those of the work tree, relative to the current folder or absolute. Any
  // number of threads may read at once, while no other function is called. Links never leave the
  // repository: all of it may be read, whatever the folder.
  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;
  // Returns whether there is an entry of this name, of any kind.
  bool has(const std::string& path) const;
  // Returns whether there is a file of this name that can be read.
  bool has_file(const std::string& path) const;
  // Returns the names in a folder, in order; empty if there is no such folder.
  std::vector<std::string> names_in(const std::string& folder) const;
  // Returns files of a folder and below with wanted names, as paths from `root`, in order. Folders
  // with other names are skipped. Empty: the folder has more than kMostListed files and folders,
  // which a few bytes of a repository can claim, or some are not available.
  static constexpr std::size_t kMostListed = 1'000'000;
  using Wanted = std::function<bool(const std::string& name)>;
  std::optional<std::vector<std::string>> files_in(const std::string& folder,
                                                   const Wanted& is_file_wanted,
                                                   const Wanted& is_folder_wanted) const;
  // Returns whether it is HEAD and nothing is staged for the next commit; an unreadable index
  // counts as nothing staged.
  bool is_unchanged_head() const;

  // Returns the commit of a submodule in this revision, in hexadecimal; "" if there was none at
  // that path.
  std::string submodule_commit(const std::string& path) const;
  // Returns paths of all submodules in a folder and below, from the folder `root`. Empty as for
  // files_in().
  std::optional<std::vector<std::string>> submodules_in(const std::string& folder) const;
  // Returns the same for the next commit, as it is staged.
  std::string staged_submodule_commit(const std::string& path) const;

  // Returns the path from the root of the repository; empty: outside of its work tree.
  std::optional<std::string> path_in_repository(const std::string& path) const;
  // Returns the folder of the work tree, absolute, without a '/' at its end.
  const std::string& root() const;
  // Returns its full id, in hexadecimal.
  const std::string& commit() const;

  // Returns how often an entry of the revision could not be read: it is not among the available
  // objects, or luxgate cannot follow to it.
  std::size_t failures() const;

 private:
  struct State;
  std::string former_commit(const GitTreeReader& inner) const;
  explicit GitTreeReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace git
