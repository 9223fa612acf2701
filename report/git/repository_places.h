#pragma once
// The places of a repository's files, for callers that must name them beforehand.

#include "report/git/git_places.h"

#include <string>
#include <vector>

namespace git {

// Returns the files and folders that are read from the repository in which `file` is: its own
// files, those of repositories whose objects it borrows, Git LFS, and git's settings. Its work tree
// is not among them.
std::vector<std::string> repository_places(const std::string& file, const GitPlaces& places);

}  // namespace git
