#include "report/text/json_layout.h"
#include "report/tools/advise/advice.h"
#include "report/tools/advise/advice_json_parts.h"
#include "report/tools/advise/room_advice_json.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace cli {
namespace {

using report::at_least_type;
using report::described_key;
using report::JsonKeys;
using report::list_of_keys;
using report::number_or_null_type;
using report::object_of_keys;
using report::one_of_names;
using report::schema_of_keys;
using report::type_of;

AdviceJson indices(const std::vector<std::size_t>& list) {
  AdviceJson json = AdviceJson::array();
  for (const std::size_t i : list) json.push_back(i);
  return json;
}

JsonKeys requirement_keys(const AdvisedRequirement& one, bool has_levels) {
  const rules::Requirement& requirement = one.before.requirement;
  return {{"space", one.space, type_of("string")},
          {"plane", requirement.plane_id, type_of("string")},
          {"id", requirement.id, type_of("string")},
          {"quantity", calc::name_of(requirement.metric), type_of("string")},
          {"comparison", calc::name_of(requirement.comparison), one_of_names<rules::Comparison>()},
          {"limit", number_or_null(requirement.limit), number_or_null_type()},
          {"unit", rules::unit_of(requirement), type_of("string")},
          {"clause", requirement.clause.english(), type_of("string")},
          {"is_searched", one.not_searched.empty(),
           described_key(type_of("boolean"), "Whether it is a condition of the search.")},
          {"not_searched", one.not_searched.english(),
           described_key(type_of("string"), "Why it is not a condition."), false,
           !one.not_searched.empty()},
          {"before", object_of_keys(finding_keys(one.before)), schema_of_keys(finding_keys({}))},
          {"after", object_of_keys(finding_keys(one.after)),
           schema_of_keys(finding_keys({}),
                          "With the levels, by other random numbers; with more-light by the same "
                          "light. Only where there are levels."),
           false, has_levels}};
}

JsonKeys group_keys(const AdvisedGroup& group, bool has_levels) {
  return {
      {"group", group.group,
       described_key(type_of("string"), "Empty: luminaires without a group.")},
      {"luminaires", group.luminaires, at_least_type("integer", 0)},
      {"power_w", group.power_w, at_least_type("number", 0)},
      {"flux_lm", group.flux_lm, at_least_type("number", 0)},
      {"energy_kwh", group.energy_kwh,
       described_key(at_least_type("number", 0), "For a year, by the rooms that state their use."),
       false, group.energy_kwh > 0.0},
      {"level_now", group.now, at_least_type("number", 0)},
      {"level", group.level,
       described_key(at_least_type("number", 0),
                     "Above 1: so many times the light. Only where there are levels."),
       false, has_levels}};
}

JsonKeys limit_keys(const AdvisedLimit& one) {
  AdviceJson lx = AdviceJson::array();
  for (std::size_t g = 0; g + 1 < one.lx.size(); ++g) lx.push_back(number_or_null(one.lx[g]));
  return {{"requirement", one.requirement, index_type()},
          {"saved_per_percent", one.cost_per_percent,
           described_key(at_least_type("number", 0),
                         "How much a limit would save that is looser by one percent.")},
          {"place_m", vector_json(one.place_m.value_or(glm::dvec3(0.0))),
           described_key(vector_type(), "Where the room is least; without: on average."), false,
           one.place_m.has_value()},
          {"lx_of_group", std::move(lx), list_of_keys(number_or_null_type())},
          {"lx_of_others", number_or_null(one.lx.empty() ? 0.0 : one.lx.back()),
           described_key(number_or_null_type(), "Light that no level changes.")}};
}

JsonKeys scene_keys(const SceneAdvice& advice) {
  const bool has_levels = advice.has_levels();
  return {
      {"scene", advice.scene, described_key(type_of("string"), "Empty: full output.")},
      {"outcome", calc::name_of(advice.outcome), one_of_names<AdviceOutcome>()},
      {"is_all_met", has_levels && advice.is_all_met(),
       described_key(type_of("boolean"),
                     "There are levels, and all requirements of the scene pass with them.")},
      {"reason", advice.reason.english(), described_key(type_of("string"), "Only with none-found."),
       false, !advice.reason.empty()},
      {"unit", calc::name_of(advice.unit),
       described_key(one_of_names<CostUnit>(),
                     "The unit of costs: lumens where the power of a luminaire is not known, kWh a "
                     "year with --least energy.")},
      {"now", advice.now, described_key(at_least_type("number", 0), "With the current levels.")},
      {"advised", advice.advised, at_least_type("number", 0), false, has_levels},
      {"least", advice.least,
       described_key(at_least_type("number", 0), "No levels that meet the conditions need less."),
       false, has_levels},
      {"groups",
       list_by_keys(advice.groups,
                    [&](const AdvisedGroup& group) { return group_keys(group, has_levels); }),
       list_of_keys(schema_of_keys(group_keys({}, true)))},
      {"left_alone", advice.left_alone,
       described_key(list_of_keys(type_of("string")),
                     "Groups of rooms without a requirement in this scene: they keep their levels, "
                     "and are in no sum.")},
      {"requirements",
       list_by_keys(
           advice.requirements,
           [&](const AdvisedRequirement& one) { return requirement_keys(one, has_levels); }),
       list_of_keys(schema_of_keys(requirement_keys({}, true)))},
      {"limits", list_by_keys(advice.limits, limit_keys),
       described_key(list_of_keys(schema_of_keys(limit_keys({}))),
                     "Limits that decide the least cost, most expensive first; empty if the levels "
                     "are not the least ones.")},
      {"raised_for", indices(advice.raised_for),
       described_key(list_of_keys(index_type()),
                     "Requirements outside the search that the least cost would not meet, so that "
                     "the levels are higher.")},
      {"aggregates_not_met", advice.aggregates_not_met,
       described_key(list_of_keys(type_of("string")),
                     "Aggregates, classes and sums of rule packs that do not pass with the levels "
                     "(verdict).")},
      {"contradicting", indices(advice.contradicting),
       described_key(
           list_of_keys(index_type()),
           "Requirements that surely cannot be met together by dimming: one smallest set, of "
           "which there may be others.")}};
}

JsonKeys package_light_keys(const PackageLight& light) {
  return {{"article", light.article,
           described_key(type_of("string"),
                         "Empty: what the photometry file or the project states without one.")},
          {"flux_lm", light.flux_lm, at_least_type("number", 0)},
          {"power_w", light.power_w,
           described_key(at_least_type("number", 0), "Power of one luminaire; 0: not known.")}};
}

JsonKeys package_type_keys(const AdvisedPackage& type) {
  return {{"type", type.type, type_of("string")},
          {"luminaires", type.luminaires, at_least_type("integer", 0)},
          {"where_nothing_is_asked", type.where_nothing_is_asked,
           described_key(at_least_type("integer", 0), "Of these luminaires; they change as well.")},
          report::object_key("now", package_light_keys(type.now)),
          report::object_key("advised", package_light_keys(type.advised))};
}

JsonKeys package_keys(const PackageAdvice& advice) {
  const bool is_found = advice.problem.empty();
  return {
      {"problem", advice.problem, described_key(type_of("string"), "Why there is no advice."),
       false, !is_found},
      {"unit", advice.is_by_flux ? "lm" : "W", {{"enum", {"lm", "W"}}}},
      {"combinations", advice.combinations, at_least_type("integer", 0)},
      {"not_excluded", advice.not_excluded,
       described_key(at_least_type("integer", 0),
                     "Undecided combinations among those that need less.")},
      {"now", advice.now,
       described_key(at_least_type("number", 0), "Sum over all luminaires of these types.")},
      {"advised", advice.advised, at_least_type("number", 0), false, is_found},
      {"is_as_now", is_found && advice.is_as_now(), type_of("boolean")},
      {"types", list_by_keys(advice.types, package_type_keys),
       list_of_keys(schema_of_keys(package_type_keys({}))), false, is_found},
      {"scenes", list_by_keys(advice.scenes, scene_keys),
       described_key(list_of_keys(schema_of_keys(scene_keys({}))),
                     "Groups whose levels change with it; the others keep their current levels."),
       false, is_found},
      {"next_below", advice.next_below,
       described_key(type_of("string"),
                     "What the combination next below does not meet with the current levels."),
       false, is_found && !advice.next_below.empty()},
      {"is_all_met", advice.is_all_met,
       described_key(type_of("boolean"),
                     "Everything passes in that check, with what rule packs make of it.")},
      {"not_met", advice.not_met,
       described_key(list_of_keys(type_of("string")), "In that check, what counts."), false,
       is_found},
      {"passing_now", advice.passing_now, at_least_type("integer", 0)},
      {"passing", advice.passing,
       described_key(at_least_type("integer", 0),
                     "In all scenes and rooms, by other random numbers."),
       false, is_found},
      {"asked", advice.asked, at_least_type("integer", 0), false, is_found}};
}

JsonKeys written_keys(const WrittenAdvice& written) {
  return {{"file", written.file, type_of("string")},
          {"what", written.what, {{"enum", {"levels", "packages", "places", "turns"}}}},
          {"passing", written.passing, at_least_type("integer", 0)},
          {"asked", written.asked, at_least_type("integer", 0)},
          {"not_met", written.not_met, list_of_keys(type_of("string"))}};
}

JsonKeys advice_keys(const Advice& advice) {
  const RoomAdvice& rooms = advice.rooms;
  return {
      {"format", "luxgate-advice", {{"const", "luxgate-advice"}}},
      {"format_version", 1, {{"const", 1}}},
      {"project", advice.project, type_of("string")},
      {"scenes", list_by_keys(advice.scenes, scene_keys),
       list_of_keys(schema_of_keys(scene_keys({})))},
      {"not_met_besides", advice.not_met_besides,
       described_key(list_of_keys(type_of("string")),
                     "Requirements that count, do not pass and do not depend on levels.")},
      {"written", object_of_keys(written_keys(advice.written.value_or(WrittenAdvice{}))),
       schema_of_keys(written_keys({}), "With --write: the file, and the result of its check."),
       false, advice.written.has_value()},
      {"packages", object_of_keys(package_keys(advice.packages.value_or(PackageAdvice{}))),
       schema_of_keys(package_keys({}), "With --packages: which lamp packages are sufficient."),
       false, advice.packages.has_value()},
      {"places", list_by_keys(rooms.places.value_or(std::vector<RoomPlaces>{}), room_places_keys),
       described_key(list_of_keys(schema_of_keys(room_places_keys({}))),
                     "With --places: where one more luminaire helps."),
       false, rooms.places.has_value()},
      {"spare", list_by_keys(rooms.spare.value_or(std::vector<RoomSpare>{}), room_spare_keys),
       described_key(list_of_keys(schema_of_keys(room_spare_keys({}))),
                     "With --places: which luminaires can be removed."),
       false, rooms.spare.has_value()},
      {"turns", list_by_keys(rooms.turns.value_or(std::vector<RoomTurns>{}), room_turns_keys),
       described_key(list_of_keys(schema_of_keys(room_turns_keys({}))),
                     "With --turns: which luminaires to turn or tilt."),
       false, rooms.turns.has_value()},
      {"surfaces",
       list_by_keys(rooms.surfaces.value_or(std::vector<RoomSurfaces>{}), room_surfaces_keys),
       described_key(list_of_keys(schema_of_keys(room_surfaces_keys({}))),
                     "With --surfaces: what lighter surfaces add."),
       false, rooms.surfaces.has_value()}};
}

}  // namespace

std::string render_advice_json(const Advice& advice) {
  return report::json_layout(object_of_keys(advice_keys(advice)));
}

std::string advice_schema() {
  return report::json_layout(report::schema_of_file("luxgate advise", advice_keys({})));
}

}  // namespace cli
