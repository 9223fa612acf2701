#include "report/check/selection.h"

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

bool fits(const Selection& selection, const calc::Space& space, const calc::CalcPlane& plane) {
  return fits(selection.planes, {plane.id, plane.name}) &&
         (fits(selection.tags, plane.tags) || fits(selection.tags, space.tags));
}

bool fits(const Selection& selection, const rules::Requirement& requirement) {
  return fits(selection.requirements,
              {requirement.id, std::string(calc::name_of(requirement.metric))});
}

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
  bool has_space = false, has_plane = false, has_tag = false;
  for (const calc::Space& space : project.project.spaces) {
    spaces.add(space.id);
    if (!fits(selection, space)) continue;
    has_space = true;
    for (const calc::CalcPlane& plane : space.planes) {
      planes.add(plane.id);
      for (const auto* list : {&space.tags, &plane.tags}) {
        for (const std::string& tag : *list) tags.add(tag);
      }
      if (!fits(selection.planes, {plane.id, plane.name})) continue;
      has_plane = true;
      if (!fits(selection, space, plane)) continue;
      has_tag = true;
      for (const rules::Requirement& requirement : project.requirements) {
        if (requirement.plane_id == plane.id) requirements.add(requirement.id);
      }
    }
  }
  if (!has_space) return spaces.words();
  if (!has_plane) return planes.words();
  return has_tag ? requirements.words() : tags.words();
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
  const std::size_t all = project.requirements.size() + project.buildings.size();
  const std::string what_was_there = what_there_is(selection, project);
  std::vector<calc::Space>& spaces = project.project.spaces;
  std::erase_if(spaces, [&](const calc::Space& space) { return !fits(selection, space); });
  std::set<std::string> chosen;  // planes
  for (const calc::Space& space : spaces) {
    for (const calc::CalcPlane& plane : space.planes) {
      if (fits(selection, space, plane)) chosen.insert(plane.id);
    }
    for (const calc::LeftOutPlane& left_out : space.left_out) {
      if (fits(selection, space, left_out.plane)) chosen.insert(left_out.plane.id);
    }
  }
  std::erase_if(project.requirements, [&](const rules::Requirement& requirement) {
    return !chosen.contains(requirement.plane_id) || !fits(selection, requirement);
  });
  if (!selection.requirements.empty()) {
    chosen.clear();
    for (const rules::Requirement& requirement : project.requirements) {
      chosen.insert(requirement.plane_id);
    }
  }
  const auto is_left_out = [&](const calc::CalcPlane& plane) { return !chosen.contains(plane.id); };
  for (calc::Space& space : spaces) {
    std::erase_if(space.left_out,
                  [&](const auto& left_out) { return is_left_out(left_out.plane); });
    std::erase_if(space.planes, is_left_out);
  }
  std::erase_if(spaces, [](const calc::Space& space) { return space.planes.empty(); });
  project.project.buildings.clear();
  project.buildings.clear();
  const std::string words = selection_words(selection);
  const calc::SourceLocation where{project.project.path, 0, 0};
  if (spaces.empty()) {
    diagnostics.report(calc::DiagnosticId::nothing_selected, where, words, what_was_there);
  } else {
    diagnostics.report(calc::DiagnosticId::part_selected, where, project.requirements.size(), all,
                       words);
  }
}

}  // namespace check
