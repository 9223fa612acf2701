#pragma once
// Where a repository's files lie, for who must name them beforehand.

#include "report/git/git_places.h"

#include <string>
#include <vector>

namespace git {

// Files and folders that are read of the repository in which `file` lies: its own ones, those of
// repositories that lend it objects, Git LFS, and git's settings. Its work tree is not among them.
std::vector<std::string> repository_places(const std::string& file, const GitPlaces& places);

}  // namespace git
