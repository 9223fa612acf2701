#pragma once
// libgit2's objects as C++ objects: only for this folder.

#include <git2.h>

#include <memory>
#include <string>

namespace git {

template <class T, void (*Free)(T*)>
struct Freeing {
  void operator()(T* object) const { Free(object); }
};
using Repository = std::unique_ptr<git_repository, Freeing<git_repository, git_repository_free>>;
using Object = std::unique_ptr<git_object, Freeing<git_object, git_object_free>>;
using Commit = std::unique_ptr<git_commit, Freeing<git_commit, git_commit_free>>;
using Tree = std::unique_ptr<git_tree, Freeing<git_tree, git_tree_free>>;
using Blob = std::unique_ptr<git_blob, Freeing<git_blob, git_blob_free>>;
using Reference = std::unique_ptr<git_reference, Freeing<git_reference, git_reference_free>>;
using Config = std::unique_ptr<git_config, Freeing<git_config, git_config_free>>;
using ObjectStore = std::unique_ptr<git_odb, Freeing<git_odb, git_odb_free>>;
using TreeEntry = std::unique_ptr<git_tree_entry, Freeing<git_tree_entry, git_tree_entry_free>>;
using Diff = std::unique_ptr<git_diff, Freeing<git_diff, git_diff_free>>;
using Index = std::unique_ptr<git_index, Freeing<git_index, git_index_free>>;

// Initialises libgit2; must outlive all of the above.
class Library {
 public:
  Library();
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

// Returns libgit2's last message, as a clause in brackets with a blank before it; "" = none.
std::string said();

std::string hex_of(const git_oid& id);

}  // namespace git
