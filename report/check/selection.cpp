#include "report/check/selection.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "report/text/shell_words.h"

#include <fmt/format.h>

#include <fnmatch.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace check {
namespace {

constexpr std::size_t kMostChoicesNamed = 12;  // of what could have been chosen

bool fits(const std::vector<std::string>& patterns, const std::vector<std::string>& names) {
  if (patterns.empty()) return true;
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    });
  });
}

bool fits(const Selection& selection, const calc::Space& space) {
  return fits(selection.spaces, {space.id, space.name});
}

bool fits(const Selection& selection, const calc::CalcPlane& plane) {
  return fits(selection.planes, {plane.id, plane.name});
}

bool has_tag(const Selection& selection, const calc::Space& space,
             const std::vector<std::string>& own) {
  return fits(selection.tags, own) || fits(selection.tags, space.tags);
}

bool fits(const Selection& selection, const rules::Requirement& requirement) {
  return fits(selection.requirements,
              {requirement.id, std::string(calc::name_of(requirement.metric))});
}

// What is chosen of a project, by ids.
class Chosen {
 public:
  Chosen(const Selection& selection, const rules::JudgedProject& project) : selection_(selection) {
    for (const calc::Space& space : project.project.spaces) {
      if (fits(selection, space)) add(space);
    }
    for (const rules::Requirement& requirement : project.requirements) {
      if (has(requirement)) asked_.insert(requirement.plane_id);
    }
  }

  // A surface of a room, and what is asked of the room, stand on a plane of the first workplace
  // that asks: what counts is who asks.
  bool has(const rules::Requirement& requirement) const {
    if (!named_.contains(requirement.plane_id) || !fits(selection_, requirement)) return false;
    const std::vector<std::string>& workplaces = requirement.origin.workplaces;
    if (workplaces.empty()) return tagged_.contains(requirement.plane_id);
    return std::any_of(workplaces.begin(), workplaces.end(),
                       [&](const std::string& id) { return tagged_workplaces_.contains(id); });
  }
  // Without a requirement, too, if requirements are not chosen by their own names.
  bool has(const calc::CalcPlane& plane) const {
    const bool is_own = named_.contains(plane.id) && tagged_.contains(plane.id);
    return asked_.contains(plane.id) || (is_own && selection_.requirements.empty());
  }
  // What is asked of it is not known here. Once its last day is over it counts as not judged, which
  // no name of a requirement hides, as long as that fits something.
  bool has(const calc::LeftOutPlane& left_out) const {
    const std::string& id = left_out.plane.id;
    const bool is_something = selection_.requirements.empty() || !asked_.empty();
    return is_something && named_.contains(id) && tagged_.contains(id);
  }

 private:
  void add(const calc::Space& space) {
    for (const calc::CalcPlane& plane : space.planes) add(space, plane);
    for (const calc::LeftOutPlane& left_out : space.left_out) add(space, left_out.plane);
    for (const calc::Workplace& workplace : space.workplaces) {
      if (has_tag(selection_, space, workplace.tags)) tagged_workplaces_.insert(workplace.id);
    }
  }
  void add(const calc::Space& space, const calc::CalcPlane& plane) {
    if (fits(selection_, plane)) named_.insert(plane.id);
    if (has_tag(selection_, space, plane.tags)) tagged_.insert(plane.id);
  }

  const Selection& selection_;
  // Planes that fit by name, by tag, and those of which a requirement is chosen.
  std::set<std::string> named_, tagged_, asked_;
  std::set<std::string> tagged_workplaces_;
};

// What the first list that fits nothing could have had: "the planes desk, board", "no planes".
class Choices {
 public:
  explicit Choices(const char* what) : what_(what) {}
  void add(const std::string& id) {
    if (known_.insert(id).second) ids_.push_back(id);
  }
  std::string words() const {
    if (ids_.empty()) return fmt::format("no {}", what_);
    return fmt::format("the {} {}", what_, calc::list_names(ids_, kMostChoicesNamed));
  }

 private:
  std::string what_;
  std::set<std::string> known_;
  std::vector<std::string> ids_;
};

// Of a project that nothing is chosen of: at which of the lists it ended.
std::string what_there_is(const Selection& selection, const rules::JudgedProject& project) {
  Choices spaces("spaces"), planes("planes"), tags("tags"), requirements("requirements");
  bool has_space = false, has_plane = false, is_tagged = false;
  for (const calc::Space& space : project.project.spaces) {
    spaces.add(space.id);
    if (!fits(selection, space)) continue;
    has_space = true;
    for (const calc::LeftOutPlane& left_out : space.left_out) planes.add(left_out.plane.id);
    for (const calc::CalcPlane& plane : space.planes) {
      planes.add(plane.id);
      for (const auto* list : {&space.tags, &plane.tags}) {
        for (const std::string& tag : *list) tags.add(tag);
      }
      if (!fits(selection, plane)) continue;
      has_plane = true;
      if (!has_tag(selection, space, plane.tags)) continue;
      is_tagged = true;
      for (const rules::Requirement& requirement : project.requirements) {
        if (requirement.plane_id == plane.id) requirements.add(requirement.id);
      }
    }
  }
  if (!has_space) return spaces.words();
  if (!has_plane) return planes.words();
  return is_tagged ? requirements.words() : tags.words();
}

}  // namespace

std::string selection_words(const Selection& selection) {
  std::string words;
  const auto add = [&](const char* option, const std::vector<std::string>& patterns) {
    for (const std::string& pattern : patterns) {
      words +=
          fmt::format("{}{} {}", words.empty() ? "" : " ", option, report::shell_quoted(pattern));
    }
  };
  add("--space", selection.spaces);
  add("--plane", selection.planes);
  add("--require", selection.requirements);
  add("--tag", selection.tags);
  return words;
}

void select(const Selection& selection, rules::JudgedProject& project,
            calc::Diagnostics& diagnostics) {
  if (selection.is_all()) return;
  std::vector<calc::Space>& spaces = project.project.spaces;
  const auto questions = [&] {
    std::size_t count = project.requirements.size();
    for (const calc::Space& space : spaces) count += space.left_out.size();
    return count;
  };
  const std::size_t all = questions() + project.buildings.size();
  const std::string what_was_there = what_there_is(selection, project);
  const Chosen chosen(selection, project);
  std::erase_if(project.requirements,
                [&](const rules::Requirement& requirement) { return !chosen.has(requirement); });
  for (calc::Space& space : spaces) {
    std::erase_if(space.left_out, [&](const auto& left_out) { return !chosen.has(left_out); });
    std::erase_if(space.planes, [&](const auto& plane) { return !chosen.has(plane); });
  }
  std::erase_if(spaces, [](const calc::Space& space) {
    return space.planes.empty() && space.left_out.empty();
  });
  project.project.buildings.clear();
  project.buildings.clear();
  const std::string words = selection_words(selection);
  const calc::SourceLocation where{project.project.path, 0, 0};
  if (spaces.empty()) {
    diagnostics.report(calc::DiagnosticId::nothing_selected, where, words, what_was_there);
  } else {
    diagnostics.report(calc::DiagnosticId::part_selected, where, questions(), all, words);
  }
}

}  // namespace check
