#include "rules/verdict/coverage.h"

#include "calc/base/sentences.h"
#include "calc/project/spaces/plane_area.h"
#include "calc/scene/polygon.h"
#include "rules/applicability/covered_surface.h"
#include "rules/pack/limit.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace rules {
namespace {

struct Asked {
  const RulePack* pack = nullptr;
  const RuleRow* row = nullptr;
  RowLevel level;
  std::map<std::string, double> facts;
  std::string scene;
  const calc::Workplace* workplace = nullptr;  // null: <require> elements
  std::vector<std::pair<const RuleCheck*, const Finding*>> findings;
};

// Returns the workplaces; null for <require> elements.
std::vector<const calc::Workplace*> workplaces_of(const calc::Space& space,
                                                  const RuleOrigin& origin) {
  if (origin.workplaces.empty()) return {nullptr};
  std::vector<const calc::Workplace*> found;
  for (const calc::Workplace& workplace : space.workplaces) {
    const bool asks = std::find(origin.workplaces.begin(), origin.workplaces.end(), workplace.id) !=
                      origin.workplaces.end();
    if (asks) found.push_back(&workplace);
  }
  return found;
}

// Returns the entry about the same row, or a new one.
Asked& asked_by(std::vector<Asked>& all, Asked about) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Asked& asked) {
    return asked.pack == about.pack && asked.row == about.row && asked.level == about.level &&
           asked.scene == about.scene && asked.workplace == about.workplace;
  });
  if (same != all.end()) return *same;
  return all.emplace_back(std::move(about));
}

// Returns whether the workplace could not make a plane of the role, and itself requires nothing of
// it.
bool lacks(const Asked& asked, const std::string& role) {
  const std::vector<calc::UnmadeZone>& unmade = asked.workplace->unmade;
  return std::any_of(
             unmade.begin(), unmade.end(),
             [&](const calc::UnmadeZone& zone) { return zone.role == role && !zone.left_out; }) &&
         std::none_of(asked.findings.begin(), asked.findings.end(),
                      [&](const auto& finding) { return finding.first->role == role; });
}

// Joins planes of <require> elements with the workplace of the same row: a board that the project
// draws itself belongs to the classroom's workplace, which could not know its place.
void join_planes(std::vector<Asked>& all) {
  for (Asked& planes : all) {
    if (planes.workplace != nullptr) continue;
    std::vector<std::pair<const RuleCheck*, const Finding*>> apart;
    std::vector<std::pair<Asked*, decltype(apart)::value_type>> joined;
    for (const auto& finding : planes.findings) {
      const std::size_t before = joined.size();
      for (Asked& asked : all) {
        const bool is_same_row = asked.workplace != nullptr && asked.pack == planes.pack &&
                                 asked.row == planes.row && asked.level == planes.level &&
                                 asked.scene == planes.scene && asked.facts == planes.facts;
        if (is_same_row && lacks(asked, finding.first->role)) joined.emplace_back(&asked, finding);
      }
      if (joined.size() == before) apart.push_back(finding);
    }
    for (const auto& [asked, finding] : joined) asked->findings.push_back(finding);
    planes.findings = std::move(apart);
  }
  std::erase_if(all, [](const Asked& asked) { return asked.findings.empty(); });
}

std::vector<Asked> asked_in(const calc::Space& space, const std::vector<JudgedPlane>& planes,
                            const std::vector<RulePack>& packs) {
  std::vector<Asked> all;
  for (const JudgedPlane& judged : planes) {
    for (const Finding& finding : *judged.findings) {
      const RuleOrigin& origin = finding.requirement.origin;
      if (origin.row.empty()) continue;
      const auto pack = std::find_if(packs.begin(), packs.end(), [&](const RulePack& candidate) {
        return candidate.full_id() == origin.pack;
      });
      if (pack == packs.end()) continue;
      const RuleRow* row = pack->find_row(origin.row);
      const RuleCheck* check = pack->find_check(origin.check);
      if (row == nullptr || check == nullptr) continue;
      for (const calc::Workplace* workplace : workplaces_of(space, origin)) {
        asked_by(
            all,
            {&*pack, row, origin.level, origin.facts, finding.requirement.scene, workplace, {}})
            .findings.emplace_back(check, &finding);
      }
    }
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const Asked& asked) { return asked.workplace != nullptr; });
  join_planes(all);
  return all;
}

void add_zone_words(const std::string& role, const std::string& zone, const calc::Message& text,
                    calc::Message& words) {
  append(words, zone == role ? text : calc::Message::words(zone) + ": " + text, ", ");
}

// Adds, for a role and its parts ("wall.1"), why there is no plane of them.
void cover_unmade(const calc::Workplace& workplace, std::string_view today, bool is_asked,
                  RoleCoverage& coverage) {
  calc::Message not_made;
  bool has_ended = false, is_place_unknown = false;
  for (const calc::UnmadeZone& zone : workplace.unmade) {
    if (zone.role != coverage.role && !zone.role.starts_with(coverage.role + ".")) continue;
    is_place_unknown = is_place_unknown || zone.is_place_unknown;
    if (!zone.left_out) {
      add_zone_words(coverage.role, zone.role, zone.why, not_made);
      continue;
    }
    const bool is_over = !zone.left_out->holds_on(today);
    coverage.left_out.push_back({zone.role, *zone.left_out, is_over});
    add_zone_words(coverage.role, zone.role,
                   is_over ? ended_words(*zone.left_out) : waiver_words(*zone.left_out),
                   coverage.words);
    has_ended = has_ended || is_over;
  }
  if (coverage.left_out.empty()) coverage.words = not_made;
  if (!is_asked && !not_made.empty()) {
    coverage.state = is_place_unknown ? RoleState::never_asked : RoleState::not_made;
  }
  if (!is_asked && !coverage.left_out.empty()) coverage.state = RoleState::left_out;
  if (has_ended) coverage.state = RoleState::left_out_ended;
}

// Returns whether two walls are side by side in one line, within the kinks and jogs of drawings:
// two degrees, 5 cm.
bool goes_on(const RoomSurface& wall, const RoomSurface& other) {
  constexpr double kAlike = 0.9994, kJog_m = 0.05;
  if (&wall == &other || glm::dot(wall.u, other.u) < kAlike) return false;
  const glm::dvec3 face = glm::cross(other.u, other.v);
  const glm::dvec3 offset_m = wall.origin_m - other.origin_m;
  const auto width_m = [](const RoomSurface& of) {
    double most_m = 0.0;
    for (const glm::dvec2& corner : of.outline_m) most_m = std::max(most_m, corner.x);
    return most_m;
  };
  const double along_m = glm::dot(offset_m, other.u);
  const bool is_beside =
      std::abs(along_m - width_m(other)) <= kJog_m || std::abs(along_m + width_m(wall)) <= kJog_m;
  return std::abs(glm::dot(offset_m, face)) <= kJog_m && is_beside;
}

// Returns walls without planes of these requirements, of those that are wide enough to count:
// "without the walls r.wall2, r.wall3". A workplace makes a plane of every wall, and names those
// that it could not make.
calc::Message walls_not_asked(const calc::Space& space, const std::vector<RequirementName>& of,
                              double strip_m) {
  if (!space.shell) return calc::say<calc::Sentence::walls_unknown>();
  calc::Message words;
  const std::vector<RoomSurface> walls = surfaces_of(space, ".wall");
  for (const RoomSurface& wall : walls) {
    // A piece of a straight wall is as wide as all of it.
    const bool is_wide = has_inside(wall, strip_m) ||
                         std::any_of(walls.begin(), walls.end(), [&](const RoomSurface& other) {
                           return goes_on(wall, other) && has_inside(other, strip_m);
                         });
    if (!is_wide) continue;
    const bool is_asked =
        std::any_of(space.planes.begin(), space.planes.end(), [&](const calc::CalcPlane& plane) {
          const auto* area = std::get_if<calc::PlanarArea>(&plane.area);
          return area != nullptr &&
                 std::any_of(of.begin(), of.end(),
                             [&](const auto& name) { return name.plane_id == plane.id; }) &&
                 !covered_surfaces(*area, strip_m, {wall},
                                   has_inside(wall, strip_m) ? strip_m : 0.0)
                      .empty();
        });
    if (!is_asked) append(words, calc::Message::words(wall.id), ", ");
  }
  return words.empty() ? words : calc::say<calc::Sentence::without_walls>(words);
}

// Returns the alternative to a check; null: it has none.
const RuleCheck* alternative_to(const RuleCheck& check, const RulePack& pack) {
  if (!check.instead_of.empty()) return pack.find_check(check.instead_of);
  const auto found = std::find_if(pack.checks.begin(), pack.checks.end(),
                                  [&](const auto& other) { return other.instead_of == check.id; });
  return found == pack.checks.end() ? nullptr : &*found;
}

// Returns planes on which the row requires illuminance but no glare; "" = there are none.
calc::Message areas_without(const Asked& asked, const std::vector<RequirementName>& glare) {
  calc::Message words;
  for (const auto& [check, finding] : asked.findings) {
    const std::string& plane_id = finding->requirement.plane_id;
    const bool is_rated = std::any_of(glare.begin(), glare.end(),
                                      [&](const auto& name) { return name.plane_id == plane_id; });
    const bool is_area =
        finding->requirement.metric == Metric::average && check->role == asked.pack->role;
    if (is_rated || !is_area) continue;
    append(words, calc::Message::words(plane_id), ", ");
  }
  return words;
}

// Returns planes of the zone that a role surrounds, or holds, without such a plane around them: the
// role is only required for some of them. Null place: the role has no such zone. "" = there are
// none.
calc::Message zones_without(const calc::Space& space, const Asked& asked, const RulePlane* place,
                            const std::vector<RequirementName>& of) {
  if (place == nullptr) return {};
  const bool is_around = !place->around.empty(), has_band = place->area == ZoneArea::task_and_band;
  std::string inside = is_around ? place->around : place->holds;
  for (const RulePlane& other : asked.pack->planes) {
    if (has_band && other.area == ZoneArea::task) inside = other.role;
  }
  if (inside.empty()) return {};
  std::vector<const calc::CalcPlane*> inner, outer;
  for (const calc::CalcPlane& plane : space.planes) {
    if (!std::holds_alternative<calc::PlanarArea>(plane.area)) continue;
    const bool is_outer = std::any_of(of.begin(), of.end(),
                                      [&](const auto& name) { return name.plane_id == plane.id; });
    const bool is_inner =
        std::any_of(asked.findings.begin(), asked.findings.end(), [&](const auto& finding) {
          return finding.first->role == inside && finding.second->requirement.plane_id == plane.id;
        });
    if (is_outer) outer.push_back(&plane);
    if (is_inner) inner.push_back(&plane);
  }
  if (outer.empty() || inner.size() < 2) return {};  // one: its planes are held against it
  calc::Message words;
  for (const calc::CalcPlane* zone : inner) {
    std::vector<const calc::PlanarArea*> others;
    for (const calc::CalcPlane* other : inner) {
      if (other != zone) others.push_back(&std::get<calc::PlanarArea>(other->area));
    }
    const ZoneAround around{&std::get<calc::PlanarArea>(zone->area), 0.0, place->width_m,
                            !is_around};
    const bool has_near = std::any_of(outer.begin(), outer.end(), [&](const auto* plane) {
      return comes_near(std::get<calc::PlanarArea>(plane->area), around);
    });
    const bool has_own = std::any_of(outer.begin(), outer.end(), [&](const auto* plane) {
      const auto& area = std::get<calc::PlanarArea>(plane->area);
      if (has_near && !comes_near(area, around)) return false;
      return covered_zone(area, area.margin_m, around, others, space, place->margin_m) >=
             1.0 - place->missing_share;
    });
    if (!has_own) append(words, calc::Message::words(zone->id), ", ");
  }
  return words;
}

// Returns the remark on the eyes of a role.
calc::Message eyes_of_role(const calc::Space& space, const Asked& asked, const std::string& role) {
  std::vector<EyesAsked> eyes;
  for (const auto& [check, finding] : asked.findings) {
    if (check->role != role || check->severity == Severity::advice) continue;
    for (const calc::CalcPlane& plane : space.planes) {
      if (plane.id == finding->requirement.plane_id) eyes.push_back({&plane, finding});
    }
  }
  return eyes_in_part(eyes);
}

bool asks(const Asked& asked, const RuleCheck& check) {
  return std::any_of(asked.findings.begin(), asked.findings.end(),
                     [&](const auto& finding) { return finding.first == &check; });
}

// Returns the project's reason for a role that is required with another number.
calc::Message special_words(const calc::Workplace& workplace, const RulePlane* place) {
  if (place == nullptr) return {};
  if (place->area == ZoneArea::task && workplace.is_task_place_unknown) {
    return calc::say<calc::Sentence::task_anywhere>();
  }
  return place->area == ZoneArea::walls && workplace.front_wall
             ? calc::say<calc::Sentence::front_wall>(*workplace.front_wall + 1)
             : calc::Message();
}

// Returns why the colour rendering of a row is not required along with its own role.
calc::Message rendering_words(const RuleCheck& check, const Asked& asked, const LimitScope& scope,
                              const RenderingProblem& problem) {
  const Limit limit = evaluate_limit(check, scope);
  if (limit.status != LimitStatus::known) return limit.reason;
  const calc::Message why = problem(asked.scene, check.comparison, limit.value.value);
  // It could be decided, but the row has no task along with which it is required.
  if (why.empty()) return calc::say<calc::Sentence::no_place>();
  return calc::say<calc::Sentence::rendering_not_stated>(check.quantity->name, why);
}

// Returns the coverage; empty: the row requires nothing of the role, or advice only.
std::optional<RoleCoverage> cover(const calc::Space& space, const Asked& asked,
                                  const std::string& role, std::string_view today,
                                  const RenderingProblem& rendering_problem) {
  const LimitScope scope{*asked.pack, asked.row, asked.level, asked.facts};
  const RuleCheck* needed = required_check(
      role, scope, [](const RuleCheck& check) { return check.severity != Severity::advice; });
  if (needed == nullptr) return std::nullopt;
  RoleCoverage coverage;
  coverage.role = role;
  Outcome outcome = Outcome::nothing_asked;
  bool is_asked = false, has_waived = false;
  for (const auto& [check, finding] : asked.findings) {
    if (check->role != role || check->severity == Severity::advice) continue;
    outcome = graver(outcome, outcome_of(*finding));
    has_waived = has_waived || outcome_of(*finding) == Outcome::waived;
    coverage.of.push_back({finding->requirement.plane_id, finding->requirement.id});
    is_asked = true;
  }
  if (is_asked) coverage.state = state_of(outcome, has_waived);
  const RuleCheck* other = alternative_to(*needed, *asked.pack);
  if (other != nullptr && !is_asked && asked.workplace == nullptr) {
    // Missed is the one that the other stands for.
    if (!asks(asked, *other) && !needed->instead_of.empty()) return std::nullopt;
    if (asks(asked, *other)) {
      coverage.state = RoleState::not_made;
      coverage.words = calc::say<calc::Sentence::judged_instead>(other->id);
      return coverage;
    }
  }
  if (asked.workplace != nullptr) cover_unmade(*asked.workplace, today, is_asked, coverage);
  // Where the pack says no place the project has to draw the plane, and has not.
  const RulePlane* place = asked.pack->find_plane(role);
  const bool has_place = place != nullptr && place->area != ZoneArea::none;
  if (is_asked && asked.workplace != nullptr && coverage.words.empty()) {
    coverage.words = special_words(*asked.workplace, place);
  }
  if (is_asked && asked.workplace == nullptr && has_place && place->area == ZoneArea::walls) {
    coverage.words = walls_not_asked(space, coverage.of, place->margin_m);
    if (!coverage.words.empty()) coverage.state = RoleState::asked_in_part;
  }
  if (is_asked && asked.workplace == nullptr && has_place && place->area == ZoneArea::ceiling &&
      !space.shell) {
    coverage.state = RoleState::asked_in_part;
    coverage.words = calc::say<calc::Sentence::ceiling_unknown>();
  }
  if (coverage.state == RoleState::met && asked.workplace == nullptr &&
      needed->quantity->derived == calc::DerivedQuantity::ugr) {
    coverage.words = eyes_of_role(space, asked, role);
    if (!coverage.words.empty()) coverage.state = RoleState::asked_in_part;
  }
  if (coverage.state == RoleState::met && asked.workplace == nullptr &&
      needed->quantity->derived != calc::DerivedQuantity::ugr) {
    const calc::Message without = zones_without(space, asked, place, coverage.of);
    if (!without.empty()) {
      coverage.state = RoleState::asked_in_part;
      coverage.words = calc::say<calc::Sentence::field_glare_not_everywhere>(without);
    }
  }
  if (is_asked && needed->quantity->of_space == Metric::glare_rating) {
    const calc::Message elsewhere = areas_without(asked, coverage.of);
    if (!elsewhere.empty()) {
      coverage.state = RoleState::asked_in_part;
      coverage.words = calc::say<calc::Sentence::field_glare_not_everywhere>(elsewhere);
    }
  }
  const bool is_for_project = !has_place && other == nullptr;
  if (coverage.state == RoleState::not_made && is_for_project) {
    coverage.state = RoleState::never_asked;
  }
  const bool is_of_makers = needed->quantity->of_space == Metric::colour_rendering;
  const bool is_measured = needed->quantity->kernel || needed->quantity->of_space;
  // Colour is asked along with the row's own role alone.
  const bool is_own_asked =
      asked.workplace != nullptr ||
      std::any_of(asked.findings.begin(), asked.findings.end(),
                  [](const auto& one) { return one.second->requirement.origin.is_of_own_role; });
  if (!is_asked && ((is_of_makers && is_own_asked) || !is_measured)) {
    coverage.state = RoleState::not_possible;
    coverage.words = is_of_makers
                         ? rendering_words(*needed, asked, scope, rendering_problem)
                         : calc::say<calc::Sentence::not_on_planes>(needed->quantity->name);
  }
  return coverage;
}

}  // namespace

calc::Message eyes_in_part(const std::vector<EyesAsked>& eyes) {
  constexpr double kOneWay = 0.866;  // cosine of 30 degrees
  constexpr double kSamePlace_m = 1.0;
  struct Eye {
    glm::dvec3 place_m, way;
    const calc::PlanarArea* area;  // null: of a list
    bool is_at(const glm::dvec3& other_m) const {
      if (area == nullptr) return glm::distance(place_m, other_m) <= kSamePlace_m;
      const glm::dvec2 flat = calc::area_coordinates(*area, other_m);
      return calc::contains_point(area->outline_m, flat) ||
             calc::distance_to_boundary(area->outline_m, flat) <= kSamePlace_m;
    }
  };
  std::vector<Eye> all;
  bool is_rated = false;
  for (const auto& [plane, finding] : eyes) {
    is_rated = is_rated || finding->reason.empty();
    if (const auto* list = std::get_if<calc::PointList>(&plane->area)) {
      for (std::size_t i = 0; i < list->normal.size(); ++i) {
        all.push_back({list->position_m[i], list->normal[i], nullptr});
      }
    } else if (const auto* area = std::get_if<calc::PlanarArea>(&plane->area)) {
      glm::dvec3 middle_m(0.0);
      for (const glm::dvec2& corner : area->outline_m) {
        middle_m += area->origin_m + corner.x * area->u + corner.y * area->v;
      }
      all.push_back(
          {middle_m / static_cast<double>(area->outline_m.size()), plane->direction, area});
    }
  }
  if (!is_rated) return calc::say<calc::Sentence::eyes_see_nothing>();
  // Wherever somebody looks, somebody looks another way from there.
  const bool has_one_way = std::any_of(all.begin(), all.end(), [&](const Eye& eye) {
    return std::none_of(all.begin(), all.end(), [&](const Eye& other) {
      return glm::dot(eye.way, other.way) <= kOneWay && other.is_at(eye.place_m);
    });
  });
  return has_one_way ? calc::say<calc::Sentence::eyes_one_way>() : calc::Message();
}

RoleState state_of(Outcome outcome, bool has_waived) {
  switch (outcome) {
    case Outcome::pass:
      return has_waived ? RoleState::waived : RoleState::met;
    case Outcome::fail:
      return RoleState::failed;
    case Outcome::undecided:
      return RoleState::undecided;
    case Outcome::waived:
      return RoleState::waived;
    case Outcome::not_judged:
    case Outcome::warned:
    case Outcome::nothing_asked:
      break;
  }
  return RoleState::not_judged;
}

bool RowCoverage::is_whole() const {
  return std::none_of(roles.begin(), roles.end(), [](const RoleCoverage& role) {
    return role.state == RoleState::never_asked || role.state == RoleState::left_out_ended ||
           role.state == RoleState::asked_in_part;
  });
}

bool RowCoverage::asks_all() const {
  return is_whole() && std::none_of(roles.begin(), roles.end(), [](const RoleCoverage& role) {
           return role.state == RoleState::not_possible;
         });
}

bool RowCoverage::has_exceptions() const {
  return std::any_of(roles.begin(), roles.end(), [](const RoleCoverage& role) {
    return role.state == RoleState::waived ||
           std::any_of(role.left_out.begin(), role.left_out.end(),
                       [](const LeftOutZone& zone) { return !zone.has_ended; });
  });
}

bool RowCoverage::is_accepted() const {
  return std::all_of(roles.begin(), roles.end(), [](const RoleCoverage& role) {
    return role.state == RoleState::met || role.state == RoleState::waived ||
           role.state == RoleState::left_out || role.state == RoleState::not_made ||
           role.state == RoleState::not_possible;
  });
}

std::vector<const calc::CalcPlane*> planes_asked(const calc::Space& space, std::string_view today) {
  std::vector<const calc::CalcPlane*> planes;
  for (const calc::CalcPlane& plane : space.planes) planes.push_back(&plane);
  for (const calc::LeftOutPlane& left_out : space.left_out) {
    if (!left_out.by.holds_on(today)) planes.push_back(&left_out.plane);
  }
  return planes;
}

calc::Message ended_words(const calc::Waiver& by) {
  return calc::say<calc::Sentence::left_out_ended>(by.until, by.owner, by.reason);
}

std::vector<RowCoverage> row_coverage(const calc::Space& space,
                                      const std::vector<JudgedPlane>& planes,
                                      const std::vector<RulePack>& packs, std::string_view today,
                                      const RenderingProblem& rendering_problem) {
  std::vector<RowCoverage> rows;
  for (const Asked& asked : asked_in(space, planes, packs)) {
    RowCoverage row;
    if (asked.workplace != nullptr) {
      row.workplace = asked.workplace->id;
      row.was = asked.workplace->was;
    }
    const std::string level = level_words(asked.level);
    row.clause = calc::Message::words(
        fmt::format("{}:{} {}{}", asked.pack->title, asked.pack->edition, asked.row->ref,
                    level.empty() ? "" : fmt::format(" ({})", level)));
    if (!asked.scene.empty()) {
      row.clause = calc::say<calc::Sentence::clause_in_scene>(row.clause, asked.scene);
    }
    row.is_user_supplied = !asked.pack->is_built_in;
    for (const std::string& role : asked.pack->roles()) {
      if (std::optional<RoleCoverage> covered =
              cover(space, asked, role, today, rendering_problem)) {
        row.roles.push_back(std::move(*covered));
      }
    }
    if (!row.roles.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace rules
