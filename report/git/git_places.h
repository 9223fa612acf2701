#pragma once

#include <string>

namespace git {

// The place of the repository, if it is not around the files: as in git's variables of these names.
// "" = not set.
struct GitPlaces {
  std::string git_dir;
  std::string work_tree;  // only with git_dir; "" = the repository's own, or the current folder
  std::string index_file = {};  // of the next commit, in hooks
};

}  // namespace git
