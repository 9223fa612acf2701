#pragma once
// The repository of a file and the commit that is meant, or why there is none: for this folder
// only.

#include "report/git/git_handles.h"
#include "report/git/git_places.h"

#include <optional>
#include <string>

namespace git {

struct OpenedRepository {
  Repository repository;
  std::string root;  // the folder of the work tree, canonical, without a '/' at its end
};

// Of the work tree in which `file` lies, which need not exist. Empty: `problem` says why.
std::optional<OpenedRepository> open_repository(const std::string& file, const GitPlaces& places,
                                                std::string& problem);

// The same repository, seen without its work tree and index: libgit2 would take attributes of
// today from there before those of a commit. Null: said() tells why.
Repository open_without_work_tree(git_repository* repository);

// revision: as git names a commit, or "main...", the commit at which HEAD has left main. Empty:
// `problem` says why.
std::optional<git_oid> find_commit(git_repository* repository, const std::string& revision,
                                   const std::string& root, std::string& problem);

// "; this is a shallow clone ...", "" of others.
std::string shallow_advice(git_repository* repository);

// An absolute path without "." and "..", and without a '/' at its end.
std::string absolute_path(const std::string& path);
// The same, links followed as far as there is something.
std::string canonical_folder(const std::string& path);

}  // namespace git
