#pragma once
// Opens the repository of a file and finds a commit, or says why it cannot: only for this folder.

#include "report/git/git_handles.h"
#include "report/git/git_places.h"

#include <optional>
#include <string>

namespace git {

struct OpenedRepository {
  Repository repository;
  std::string root;  // the folder of the work tree, canonical, without a '/' at its end
};

// Opens the repository in whose work tree `file` is; the file need not exist. Empty: `problem` says
// why.
std::optional<OpenedRepository> open_repository(const std::string& file, const GitPlaces& places,
                                                std::string& problem);

// Opens the same repository without its work tree and index, because libgit2 would take current
// attributes from there before those of a commit. Null: said() tells why.
Repository open_without_work_tree(git_repository* repository);

// Returns the commit. revision: as git names a commit, or "main...", the commit at which HEAD left
// main. Empty: `problem` says why.
std::optional<git_oid> find_commit(git_repository* repository, const std::string& revision,
                                   const std::string& root, std::string& problem);

// Returns "; this is a shallow clone ...", "" for other repositories.
std::string shallow_advice(git_repository* repository);

// Returns an absolute path without "." and "..", and without a '/' at its end.
std::string absolute_path(const std::string& path);
// Returns the absolute path with links followed as far as it exists.
std::string canonical_folder(const std::string& path);

}  // namespace git
