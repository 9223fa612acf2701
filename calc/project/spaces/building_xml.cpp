#include "calc/project/spaces/building_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/reading/project_elements.h"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace calc {
namespace {

// In at most so many steps as both lengths multiplied; fnmatch() knows no such limit.
bool is_like(std::string_view text, std::string_view pattern) {
  std::size_t t = 0, p = 0, after_star = std::string_view::npos, retry = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      after_star = ++p;
      retry = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (after_star != std::string_view::npos) {
      p = after_star;
      t = ++retry;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool is_room(const Space& space) { return !space.is_open_space() && !space.road; }

Names rooms_of(const Project& project) {
  Names names;
  for (const Space& space : project.spaces) {
    if (is_room(space)) names.emplace_back(space.id);
  }
  return names;
}

// In order, each once. Every pattern must be like one room at least: what is misspelt would be left
// out, and the rest is easier to meet.
std::vector<std::size_t> read_rooms(ProjectContext& context, ElementReader& reader) {
  const std::vector<Space>& spaces = context.project.spaces;
  std::set<std::size_t> rooms;
  const auto add = [&](std::string_view pattern) {
    bool is_found = false;
    for (std::size_t i = 0; i < spaces.size(); ++i) {
      if (!is_room(spaces[i]) || !is_like(spaces[i].id, pattern)) continue;
      rooms.insert(i);
      is_found = true;
    }
    return is_found;
  };
  const std::string given = reader.text_or("rooms", "*");
  const std::vector<std::string_view> patterns = split_words(given);
  if (patterns.empty()) {
    reader.report(DiagnosticId::missing_form, reader.where("rooms"), "building",
                  "the id of a room in 'rooms'; leave out 'rooms' for all rooms");
  }
  // Stands for the time, too, which many patterns for many rooms take.
  constexpr double kComparison = 64.0;
  const auto comparisons = static_cast<double>(patterns.size() * spaces.size());
  if (!context.files.take(kComparison * comparisons, reader.where(),
                          "the patterns in 'rooms' take")) {
    return {};
  }
  std::set<std::string_view> seen;
  for (const std::string_view word : patterns) {
    if (!seen.insert(word).second || add(word)) continue;
    if (reader.has("rooms")) {
      report_unknown_reference(reader, "rooms", "room", std::string(word),
                               rooms_of(context.project));
    } else {
      reader.report(DiagnosticId::missing_form, reader.where(), "building",
                    "at least one room in the project");
    }
  }
  return {rooms.begin(), rooms.end()};
}

}  // namespace

void read_buildings(ProjectContext& context, const XmlElement& root) {
  IdTable ids("building");
  FormerIds former("building");
  for (const XmlElement& child : root.children) {
    if (child.name != "building") continue;
    ElementReader reader(child, context.diagnostics);
    reader.allow(kBuildingElement);
    Building building;
    building.where = reader.where();
    building.id = reader.id();
    ids.add(reader, building.id, 0);
    building.was = former.read(reader, building.id);
    building.name = reader.text_or("name", "");
    building.rooms = read_rooms(context, reader);
    for (const XmlElement& part : child.children) {
      if (part.name == "require") building.requirements.push_back({part, ""});
    }
    // Each of its rooms has a line in each of its findings, in every format.
    constexpr double kLine = 4096.0;
    const auto lines = static_cast<double>(building.rooms.size() * building.requirements.size());
    if (!context.files.take(kLine * lines, child.where, "the rooms of the buildings take")) return;
    if (building.requirements.empty()) {
      reader.report(DiagnosticId::missing_form, reader.where(), "building",
                    "a <require> that all of its rooms together must meet");
    }
    context.project.buildings.push_back(std::move(building));
  }
  former.check(context.diagnostics);
}

}  // namespace calc
