#include "report/tools/advise/room_advice_json.h"

#include "report/tools/advise/advice_json_parts.h"

namespace cli {

using report::at_least_type;
using report::described_key;
using report::JsonKey;
using report::JsonKeys;
using report::list_of_keys;
using report::number_or_null_type;
using report::object_of_keys;
using report::schema_of_keys;
using report::type_of;

namespace {

AdviceJson count_type() { return at_least_type("integer", 0); }
AdviceJson text_list() { return list_of_keys(type_of("string")); }

JsonKey problem_key(const std::string& problem, const char* words) {
  return {"problem", problem, described_key(type_of("string"), words), false, !problem.empty()};
}
JsonKey unit_key(bool is_by_flux) {
  return {"unit", is_by_flux ? "lm" : "W",
          described_key({{"enum", {"lm", "W"}}}, "Unit of the cost of luminaires.")};
}

AdviceJson findings_type() {
  return described_key(list_of_keys(schema_of_keys(finding_keys({}))),
                       "As many as requirements, by other random numbers.");
}

JsonKeys asked_keys(const RoomRequirement& one) {
  const rules::Requirement& requirement = one.before.requirement;
  return {{"plane", requirement.plane_id, type_of("string")},
          {"id", requirement.id, type_of("string")},
          {"quantity", calc::name_of(requirement.metric), type_of("string")},
          {"limit", number_or_null(requirement.limit), number_or_null_type()},
          {"unit", rules::unit_of(requirement), type_of("string")},
          {"points", one.points,
           described_key(count_type(),
                         "From which light was followed; 0: from all, for their average.")},
          {"of_points", one.of_points,
           described_key(count_type(),
                         "That count. With fewer points a gain of a least value may be less.")},
          {"before", object_of_keys(finding_keys(one.before)), schema_of_keys(finding_keys({}))}};
}

AdviceJson asked_type() { return list_of_keys(schema_of_keys(asked_keys({}))); }

JsonKeys place_keys(const AdvisedPlace& place) {
  return {{"type", place.type, type_of("string")},
          {"group", place.group, type_of("string")},
          {"position_m", vector_json(place.position_m), vector_type()},
          {"c0", vector_json(place.c0), vector_type()},
          {"axis", vector_json(place.axis), vector_type()},
          {"cost", place.cost, at_least_type("number", 0)},
          {"share", place.share,
           described_key({{"type", "number"}, {"minimum", 0}, {"maximum", 1}},
                         "Share of the missing light, by the lower ends of gains.")},
          {"gain_lx", gains_json(place.gain_lx), gains_type("As many as requirements.")}};
}

AdviceJson places_type() { return list_of_keys(schema_of_keys(place_keys({}))); }

JsonKeys checked_keys(const CheckedPlaces& checked) {
  const bool is_checked = checked.problem.empty();
  return {{"places", list_by_keys(checked.places, place_keys), places_type()},
          {"is_checked", is_checked, type_of("boolean")},
          problem_key(checked.problem, "Why it could not be checked."),
          {"after", list_by_keys(checked.after, finding_keys), findings_type(), false, is_checked},
          {"passing", checked.passing,
           described_key(count_type(), "Requirements that count in the scene, in all rooms."),
           false, is_checked},
          {"asked", checked.asked, count_type(), false, is_checked},
          {"broken", checked.broken,
           described_key(text_list(), "Requirements that passed before and no longer do."), false,
           is_checked}};
}

JsonKeys turn_keys(const AdvisedTurn& turn) {
  return {{"id", turn.id, type_of("string")},
          {"type", turn.place.type, type_of("string")},
          {"group", turn.place.group, type_of("string")},
          {"position_m", vector_json(turn.place.position_m), vector_type()},
          {"turn_deg", turn.turn_deg,
           described_key(type_of("number"), "About its axis, counter-clockwise seen from behind.")},
          {"tilt_deg", turn.tilt_deg,
           described_key(type_of("number"), "Tilt of its axis, towards one of its C planes.")},
          {"tilt_to_deg", turn.tilt_to_deg, described_key(type_of("number"), "That C plane.")},
          {"c0", vector_json(turn.place.c0), vector_type()},
          {"axis", vector_json(turn.place.axis), vector_type()},
          {"share", turn.place.share,
           described_key(
               type_of("number"),
               "Share of the missing light, by the lower ends of gains; losses count against it.")},
          {"gain_lx", gains_json(turn.place.gain_lx), gains_type("As many as requirements.")}};
}

JsonKeys checked_turns_keys(const CheckedTurns& checked) {
  return {{"turns", list_by_keys(checked.turns, turn_keys),
           list_of_keys(schema_of_keys(turn_keys({})))},
          report::object_key("check", checked_keys(checked.check))};
}

JsonKeys spare_luminaire_keys(const SpareLuminaire& one) {
  return {{"id", one.id, type_of("string")},
          {"type", one.type, type_of("string")},
          {"group", one.group, type_of("string")},
          {"position_m", vector_json(one.position_m), vector_type()},
          {"cost", one.cost, at_least_type("number", 0)}};
}

JsonKeys surface_keys(const LighterSurface& surface) {
  const bool is_checked = !surface.after.empty();
  return {{"surface", surface.surface, type_of("string")},
          {"reflectance", surface.reflectance, described_key(type_of("number"), "By area.")},
          {"slope_lx", gains_json(surface.slope_lx),
           gains_type("Gain of the step, extrapolated from its start.")},
          {"step_lx", gains_json(surface.step_lx), gains_type("Gain of the step.")},
          {"is_checked", is_checked, type_of("boolean")},
          problem_key(surface.problem, "Why it was not."),
          {"after", list_by_keys(surface.after, finding_keys), findings_type(), false, is_checked}};
}

}  // namespace

JsonKeys room_places_keys(const RoomPlaces& room) {
  return {{"scene", room.scene, type_of("string")},
          {"space", room.space_id, type_of("string")},
          problem_key(room.problem, "Why there is no advice."),
          unit_key(room.is_by_flux),
          {"requirements", list_by_keys(room.requirements, asked_keys), asked_type()},
          {"left_out", room.left_out,
           described_key(text_list(), "Types and requirements that were not considered, and why.")},
          {"step_m",
           {room.step_m.x, room.step_m.y},
           {{"type", "array"}, {"items", type_of("number")}, {"minItems", 2}, {"maxItems", 2}}},
          {"least_distance_m", room.least_distance_m, at_least_type("number", 0)},
          {"cells", room.cells, count_type()},
          {"passing", room.passing, count_type()},
          {"asked", room.asked, count_type()},
          {"places", list_by_keys(room.places, place_keys),
           described_key(places_type(), "Free ones, best first.")},
          {"best", list_by_keys(room.best, checked_keys),
           described_key(list_of_keys(schema_of_keys(checked_keys({}))), "One luminaire more.")},
          {"together", object_of_keys(checked_keys(room.together.value_or(CheckedPlaces{}))),
           schema_of_keys(checked_keys({}), "As many luminaires as needed, by the same light."),
           false, room.together.has_value()}};
}

JsonKeys room_spare_keys(const RoomSpare& room) {
  return {{"space", room.space_id, type_of("string")},
          problem_key(room.problem, "Why there is no advice."),
          unit_key(room.is_by_flux),
          {"of", room.of, described_key(count_type(), "Luminaires of the room.")},
          {"passing", room.passing,
           described_key(count_type(), "Of all scenes and rooms, in the check.")},
          {"asked", room.asked, count_type()},
          {"luminaires", list_by_keys(room.luminaires, spare_luminaire_keys),
           described_key(list_of_keys(schema_of_keys(spare_luminaire_keys({}))),
                         "Luminaires that can be removed together.")}};
}

JsonKeys room_turns_keys(const RoomTurns& room) {
  return {{"scene", room.scene, type_of("string")},
          {"space", room.space_id, type_of("string")},
          problem_key(room.problem, "Why there is no advice."),
          {"requirements", list_by_keys(room.requirements, asked_keys), asked_type()},
          {"left_out", room.left_out,
           described_key(text_list(), "Luminaires and requirements that were not considered.")},
          {"luminaires", room.luminaires, count_type()},
          {"tried", room.tried, described_key(count_type(), "Other ways of hanging them.")},
          {"passing", room.passing, count_type()},
          {"asked", room.asked, count_type()},
          {"turns", list_by_keys(room.turns, turn_keys),
           described_key(list_of_keys(schema_of_keys(turn_keys({}))),
                         "Those that surely add a hundredth of the missing light, best first.")},
          {"best", list_by_keys(room.best, checked_turns_keys),
           described_key(list_of_keys(schema_of_keys(checked_turns_keys({}))), "One of them.")},
          {"together", object_of_keys(checked_turns_keys(room.together.value_or(CheckedTurns{}))),
           schema_of_keys(checked_turns_keys({}), "Several, each as it mends most."), false,
           room.together.has_value()}};
}

JsonKeys room_surfaces_keys(const RoomSurfaces& room) {
  return {{"scene", room.scene, type_of("string")},
          {"space", room.space_id, type_of("string")},
          problem_key(room.problem, "Why there is no advice."),
          {"requirements", list_by_keys(room.requirements, asked_keys), asked_type()},
          {"reflectance_step", kReflectanceStep, type_of("number")},
          {"surfaces", list_by_keys(room.surfaces, surface_keys),
           list_of_keys(schema_of_keys(surface_keys({})))}};
}

}  // namespace cli
