#pragma once
// A project that was imported, changed by hand, and is imported again: three texts become one.

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

// base: as the last import wrote it; mine: as it is now; next: as this import would write it.
// Elements are the same that have the same id (of the root: always), attribute by attribute. What
// only `next` changed is changed in `mine`, whose other bytes stay: order, comments, blanks. Empty
// after an error: a text that is not well-formed.
std::optional<MergedProject> merge_projects(const ProjectSource& base, const ProjectSource& mine,
                                            const std::string& next,
                                            calc::Diagnostics& diagnostics);

}  // namespace cli
