#pragma once
// Merges a project that was imported, changed by hand, and is imported again: three texts become
// one.

#include "calc/base/diagnostics.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct MergedProject {
  std::string xml;
  std::vector<std::string> changes;    // what the drawing has otherwise now, in words
  std::vector<std::string> conflicts;  // what was changed by hand, too: it is as it was
};
struct ProjectSource {
  std::string xml, name;  // name: for messages
};

// Returns the merged project. base: as the last import wrote it; mine: the current text; next: as
// this import would write it. Elements with the same id are the same (the root: always), and are
// compared attribute by attribute. Changes only in `next` are made in `mine`, whose other bytes
// stay: order, comments, blanks. Empty after an error: a text that is not well-formed.
std::optional<MergedProject> merge_projects(const ProjectSource& base, const ProjectSource& mine,
                                            const std::string& next,
                                            calc::Diagnostics& diagnostics);

}  // namespace cli
