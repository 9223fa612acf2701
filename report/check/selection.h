#pragma once
// Selects a part of a project's requirements by name, for a quick check of current work. The rest
// is neither calculated nor judged, and never counts as met.

#include "calc/base/diagnostics.h"
#include "rules/binding/judged_project.h"

#include <string>
#include <vector>

namespace check {

// Shell patterns ("office-*"). In each list one must match; an empty list selects everything.
struct Selection {
  std::vector<std::string> spaces;        // ids or names
  std::vector<std::string> planes;        // ids or names, those of planes that workplaces make too
  std::vector<std::string> requirements;  // ids, or metrics ("Uo")
  std::vector<std::string> tags = {};     // of planes, or of their spaces

  bool is_all() const {
    return spaces.empty() && planes.empty() && tags.empty() && requirements.empty();
  }
  bool operator==(const Selection&) const = default;
};

// Returns the options as on a command line, quoted for a shell: "--plane 'desk-*' --plane board";
// "" for everything.
std::string selection_words(const Selection& selection);

// Keeps only selected spaces, planes and requirements in the project; if requirements are selected
// by their own names, only planes that have one of them. A workplace's requirements have its tags
// on every plane. Buildings are removed, because their sums need more. Warns how much is not judged
// (part_selected), or that nothing is left, with the existing names (nothing_selected).
void select(const Selection& selection, rules::JudgedProject& project,
            calc::Diagnostics& diagnostics);

}  // namespace check
