#include "report/revision/inputs.h"

#include "report/text/number_format.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace report {
namespace {

class Inputs {
 public:
  explicit Inputs(RevisionPlace place) : place_(std::move(place)) {}

  // Nothing where they are the same.
  void compare(const std::string& what, const std::string& item, const std::string& before,
               const std::string& after) {
    if (before == after) return;
    ChangedInput input{place_, what, before, after};
    input.place.item = item;
    list_.push_back(std::move(input));
  }
  std::vector<ChangedInput> take() { return std::move(list_); }

 private:
  RevisionPlace place_;
  std::vector<ChangedInput> list_;
};

std::string photometry_words(const LuminaireRow& row) {
  constexpr std::size_t kShown = 8;  // digits of the hash, as git shows them
  std::string words = row.photometry_file.empty() ? "luminous surface"
                                                  : fmt::format("{} ({})", row.photometry_file,
                                                                row.sha256.substr(0, kShown));
  if (!row.package.empty()) words += ", package " + row.package;
  if (std::isfinite(row.flux_lm)) words += ", " + format_lumens(row.flux_lm) + " lm";
  if (row.power_w > 0.0) words += ", " + format_watts(row.power_w) + " W";
  words += ", maintenance factor " + format_shortest(row.maintenance_factor);
  if (!row.housing_material.empty()) {
    words += fmt::format(", housing of {} {} m deep", row.housing_material,
                         format_shortest(row.housing_depth_m));
  }
  return words;
}

// What became of luminaires of one type.
struct Moves {
  std::size_t moved = 0, added = 0, removed = 0, turned = 0, regrouped = 0, reshaped = 0;
  double farthest_m = 0.0;
};

bool is_same_way(const glm::dvec3& a, const glm::dvec3& b) {
  const bool is_known = a != glm::dvec3(0.0) && b != glm::dvec3(0.0);
  return !is_known || glm::length(a - b) <= kSamePlace_m;
}

// Of the opening, wherever it is.
double size_of(const LuminaireMark& mark) {
  double size_m = 0.0;
  for (std::size_t k = 1; k < mark.outline_m.size(); ++k) {
    size_m += glm::length(mark.outline_m[k] - mark.outline_m[k - 1]);
  }
  return size_m;
}

Moves moves_of(const std::vector<LuminaireMark>& before, const std::vector<LuminaireMark>& after) {
  Moves moves;
  for (const PartPair<LuminaireMark>& pair : match_marks(before, after)) {
    if (pair.before == nullptr || pair.after == nullptr) {
      ++(pair.before == nullptr ? moves.added : moves.removed);
      continue;
    }
    const LuminaireMark &was = *pair.before, &is = *pair.after;
    if (!is_same_place(was.position_m, is.position_m)) {
      ++moves.moved;
      moves.farthest_m = std::max(moves.farthest_m, glm::length(was.position_m - is.position_m));
    }
    const bool is_turned = !is_same_way(was.c0, is.c0) || !is_same_way(was.axis, is.axis);
    if (is_turned) ++moves.turned;
    if (was.group != is.group) ++moves.regrouped;
    if (!is_turned && std::abs(size_of(was) - size_of(is)) > kSamePlace_m) ++moves.reshaped;
  }
  return moves;
}

std::string moves_words(const Moves& moves) {
  std::string words;
  const auto add = [&words](std::size_t count, const std::string& what) {
    if (count > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, what);
  };
  add(moves.added, "added");
  add(moves.removed, "removed");
  add(moves.moved, fmt::format("moved, up to {} m", format_metres(moves.farthest_m)));
  add(moves.turned, "turned");
  add(moves.regrouped, "in another group");
  add(moves.reshaped, "with another opening");
  return words;
}

std::map<std::string, std::vector<LuminaireMark>> by_type(const std::vector<LuminaireMark>& marks) {
  std::map<std::string, std::vector<LuminaireMark>> types;
  for (const LuminaireMark& mark : marks) types[mark.type_id].push_back(mark);
  return types;
}

void compare_luminaires(Inputs& inputs, const SpacePart& before, const SpacePart& after) {
  auto was = by_type(before.luminaires), is = by_type(after.luminaires);
  for (const auto& [type, marks] : was) is[type];
  for (const auto& [type, marks] : is) {
    const std::vector<LuminaireMark>& old = was[type];
    const std::string words = moves_words(moves_of(old, marks));
    if (words.empty()) continue;
    inputs.compare("luminaires", type, fmt::format("{}", old.size()),
                   fmt::format("{}: {}", marks.size(), words));
  }
}

bool is_same_body(const BodyMark& a, const BodyMark& b) {
  if (std::abs(a.low_z_m - b.low_z_m) > kSamePlace_m) return false;
  if (std::abs(a.high_z_m - b.high_z_m) > kSamePlace_m) return false;
  if (a.lines_m.size() != b.lines_m.size()) return false;
  for (std::size_t k = 0; k < a.lines_m.size(); ++k) {
    for (std::size_t end = 0; end < 2; ++end) {
      if (!is_same_place(a.lines_m[k][end], b.lines_m[k][end])) return false;
    }
  }
  return true;
}

std::string body_words(const BodyMark& body) {
  return fmt::format("{} to {} m high", format_metres(body.low_z_m), format_metres(body.high_z_m));
}

// Results of earlier versions do not know them.
void compare_materials(Inputs& inputs, const std::string& surface, const std::string& before,
                       const std::string& after) {
  if (!before.empty() && !after.empty()) inputs.compare("material", surface, before, after);
}

std::string levels_words(const SceneRow& scene) {
  std::string words;
  for (const auto& [group, level] : scene.level_of_group) {
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", group, format_shortest(level));
  }
  return words.empty() ? "all at 1" : words;
}

}  // namespace

std::vector<ChangedInput> compare_inputs(const ProjectPart& before, const ProjectPart& after,
                                         const RevisionPlace& place) {
  Inputs inputs(place);
  const auto types = match_luminaires(before.luminaires, after.luminaires);
  for (const PartPair<LuminaireRow>& pair : types) {
    // Of one that hangs nowhere, coming or going is nothing.
    if (pair.before == nullptr && pair.after->count == 0) continue;
    if (pair.after == nullptr && pair.before->count == 0) continue;
    const std::string was = pair.before != nullptr ? photometry_words(*pair.before) : "";
    const std::string is = pair.after != nullptr ? photometry_words(*pair.after) : "";
    inputs.compare("photometry", pair.after != nullptr ? pair.after->type_id : pair.before->type_id,
                   was, is);
  }
  const auto materials =
      match_parts(before.materials, after.materials, [](const MaterialRow& row) { return row.id; });
  for (const PartPair<MaterialRow>& pair : materials) {
    const auto words = [](const MaterialRow* row) {
      return row == nullptr ? std::string() : format_shortest(row->reflectance);
    };
    // Results of earlier versions know no materials.
    if (before.materials.empty() || after.materials.empty()) break;
    inputs.compare("reflectance", pair.after != nullptr ? pair.after->id : pair.before->id,
                   words(pair.before), words(pair.after));
  }
  const auto scenes =
      match_parts(before.scenes, after.scenes, [](const SceneRow& scene) { return scene.id; });
  for (const PartPair<SceneRow>& pair : scenes) {
    // Results of earlier versions know no scenes.
    if (before.scenes.empty() || after.scenes.empty()) break;
    inputs.compare("scene", pair.after != nullptr ? pair.after->id : pair.before->id,
                   pair.before != nullptr ? levels_words(*pair.before) : "",
                   pair.after != nullptr ? levels_words(*pair.after) : "");
  }
  return inputs.take();
}

std::vector<ChangedInput> compare_inputs(const SpacePart& before, const SpacePart& after,
                                         const RevisionPlace& place) {
  Inputs inputs(place);
  compare_luminaires(inputs, before, after);
  const auto finishes = match_parts(before.finishes, after.finishes,
                                    [](const SurfaceFinish& finish) { return finish.surface; });
  for (const PartPair<SurfaceFinish>& pair : finishes) {
    if (pair.before == nullptr || pair.after == nullptr) continue;  // the shape of the room tells
    compare_materials(inputs, pair.after->surface, pair.before->materials, pair.after->materials);
  }
  const auto bodies =
      match_parts(before.bodies, after.bodies, [](const BodyMark& body) { return body.id; });
  for (const PartPair<BodyMark>& pair : bodies) {
    if (pair.before == nullptr) {
      inputs.compare("body", pair.after->id, "", body_words(*pair.after));
    } else if (pair.after == nullptr) {
      inputs.compare("body", pair.before->id, body_words(*pair.before), "");
    } else if (!is_same_body(*pair.before, *pair.after)) {
      inputs.compare("body", pair.after->id, body_words(*pair.before),
                     body_words(*pair.after) + ", moved or of another shape");
    }
    if (pair.before == nullptr || pair.after == nullptr) continue;
    compare_materials(inputs, pair.after->id, pair.before->materials, pair.after->materials);
  }
  if (bodies.size() > 0 || before.triangles != after.triangles) {
    inputs.compare("triangles", "", fmt::format("{}", before.triangles),
                   fmt::format("{}", after.triangles));
  }
  const auto size = [](const SpacePart& space) {
    std::string words = format_metres(space.height_m) + " m high";
    for (const glm::dvec2& corner : space.footprint_m) {
      words += fmt::format(" ({}, {})", format_metres(corner.x), format_metres(corner.y));
    }
    return words;
  };
  inputs.compare("room", "", size(before), size(after));
  return inputs.take();
}

}  // namespace report
