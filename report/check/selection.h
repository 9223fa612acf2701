#pragma once
// A part of what a project requires, chosen by name: for a quick look at what one works on. What is
// not chosen is neither calculated nor judged, and never counts as met.

#include "calc/base/diagnostics.h"
#include "rules/binding/judged_project.h"

#include <string>
#include <vector>

namespace check {

// Patterns of a shell ("office-*"). Of each list one must fit; an empty list takes all.
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

// As on a command line, quoted for a shell: "--plane 'desk-*' --plane board"; "" of all.
std::string selection_words(const Selection& selection);

// Leaves in the project what is chosen: spaces, planes and requirements; if requirements are chosen
// by their own names, only planes that have one of them. What a workplace asks has its tags, on
// whatever plane it stands. Buildings go, since their sums are about more. Warns of how much is not
// judged (part_selected), or that nothing is left, with the names that there are
// (nothing_selected).
void select(const Selection& selection, rules::JudgedProject& project,
            calc::Diagnostics& diagnostics);

}  // namespace check
