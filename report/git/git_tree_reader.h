#pragma once
// Files as they were in a git revision, from the objects of the repository. Neither the work tree
// nor the index is touched, no program is started and nothing is fetched.

#include "calc/base/file_reader.h"
#include "report/git/git_places.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace git {

// One repository at one commit. What is read are the bytes that a checkout would write, line ends
// included; of Git LFS the contents, if they are in the repository's LFS objects. Symbolic links
// are followed inside the repository only. What lies in a submodule is an error, as is what a
// checkout would have other programs write, and a file over 512 MiB. Not thread-safe.
class GitTreeReader : public calc::FileReader {
 public:
  // Of the repository in whose work tree `file` lies, which need not exist; of linked work trees
  // and submodules their own. revision: as git names a commit: branch, tag, id, HEAD~1; or
  // "main...", the commit at which HEAD has left main. Null, and `problem` says why in words that
  // tell what is allowed. In a submodule it is the commit that the revision of the repository
  // around it names, for its own branches do not tell what it was then; where it was not there yet,
  // the repository around it.
  static std::unique_ptr<GitTreeReader> open(const std::string& file, const std::string& revision,
                                             const GitPlaces& places, std::string& problem);
  // The same without a look at the repository around it.
  static std::unique_ptr<GitTreeReader> open_alone(const std::string& file,
                                                   const std::string& revision,
                                                   const GitPlaces& places, std::string& problem);
  ~GitTreeReader() override;
  GitTreeReader(const GitTreeReader&) = delete;
  GitTreeReader& operator=(const GitTreeReader&) = delete;

  // Paths are those of the work tree, relative to the current folder or absolute. Any number of
  // threads may read at once, while nothing else is asked. Links never leave the repository: all of
  // it may be read, whatever the folder.
  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;
  // Whether there is something of this name, of any kind.
  bool has(const std::string& path) const;
  // Whether there is a file of this name that can be had.
  bool has_file(const std::string& path) const;
  // What a folder holds, names alone, in order; empty where there is no such folder.
  std::vector<std::string> names_in(const std::string& folder) const;
  // Files of a folder and below whose names are wanted, as paths from `root`, in order. Folders
  // whose names are not wanted are not looked into. Empty: the folder has more than kMostListed
  // files and folders, which a few bytes of a repository can say, or some that are not at hand.
  static constexpr std::size_t kMostListed = 1'000'000;
  using Wanted = std::function<bool(const std::string& name)>;
  std::optional<std::vector<std::string>> files_in(const std::string& folder,
                                                   const Wanted& is_file_wanted,
                                                   const Wanted& is_folder_wanted) const;
  // It is what HEAD names, and nothing is staged for the next commit, as far as that can be told:
  // of an index that cannot be read nothing is.
  bool is_unchanged_head() const;

  // Of submodules: the commit of theirs that this revision names, in hexadecimal; "" where there
  // was none at that path.
  std::string submodule_commit(const std::string& path) const;
  // Paths of all submodules in a folder and below, from the folder `root`.
  // Empty as of files_in().
  std::optional<std::vector<std::string>> submodules_in(const std::string& folder) const;
  // The same of the next commit, as it is staged.
  std::string staged_submodule_commit(const std::string& path) const;

  // From the root of the repository; empty: outside of its work tree.
  std::optional<std::string> path_in_repository(const std::string& path) const;
  // The folder of the work tree, absolute, without a '/' at its end.
  const std::string& root() const;
  // Its full id, in hexadecimal.
  const std::string& commit() const;

  // How often something could not be read that the revision has: it is not among the objects at
  // hand, or luxgate cannot follow to where it is.
  std::size_t failures() const;

 private:
  struct State;
  std::string former_commit(const GitTreeReader& inner) const;
  explicit GitTreeReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace git
