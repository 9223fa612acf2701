#include "report/tools/advise/room_advice_json.h"

#include <cmath>

namespace cli {
namespace {

using RoomJson = nlohmann::ordered_json;

RoomJson room_number_json(double value) {
  return std::isfinite(value) ? RoomJson(value) : RoomJson(nullptr);
}

RoomJson gain_json(const calc::Estimate& estimate) {
  return {{"value", room_number_json(estimate.value)},
          {"low", room_number_json(estimate.low)},
          {"high", room_number_json(estimate.high)}};
}

RoomJson gains_json(const std::vector<calc::Estimate>& estimates) {
  RoomJson json = RoomJson::array();
  for (const calc::Estimate& one : estimates) json.push_back(gain_json(one));
  return json;
}

RoomJson checked_finding_json(const rules::Finding& finding) {
  RoomJson json{{"verdict", calc::name_of(finding.verdict)}};
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  const calc::Estimate& measured = finding.measured;
  json["value"] = is_judged ? room_number_json(measured.value) : RoomJson(nullptr);
  json["low"] = is_judged ? room_number_json(measured.low) : RoomJson(nullptr);
  json["high"] = is_judged ? room_number_json(measured.high) : RoomJson(nullptr);
  return json;
}

RoomJson findings_json(const std::vector<rules::Finding>& findings) {
  RoomJson json = RoomJson::array();
  for (const rules::Finding& one : findings) json.push_back(checked_finding_json(one));
  return json;
}

RoomJson requirements_json(const std::vector<RoomRequirement>& requirements) {
  RoomJson json = RoomJson::array();
  for (const RoomRequirement& one : requirements) {
    const rules::Requirement& requirement = one.before.requirement;
    json.push_back({{"plane", requirement.plane_id},
                    {"id", requirement.id},
                    {"quantity", calc::name_of(requirement.metric)},
                    {"limit", room_number_json(requirement.limit)},
                    {"unit", rules::unit_of(requirement)},
                    {"points", one.points},
                    {"before", checked_finding_json(one.before)}});
  }
  return json;
}

RoomJson place_vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

RoomJson place_json(const AdvisedPlace& place) {
  return {{"type", place.type},
          {"group", place.group},
          {"position_m", place_vector_json(place.position_m)},
          {"c0", place_vector_json(place.c0)},
          {"axis", place_vector_json(place.axis)},
          {"cost", place.cost},
          {"share", place.share},
          {"gain_lx", gains_json(place.gain_lx)}};
}

RoomJson list_of_places(const std::vector<AdvisedPlace>& places) {
  RoomJson json = RoomJson::array();
  for (const AdvisedPlace& one : places) json.push_back(place_json(one));
  return json;
}

RoomJson checked_json(const CheckedPlaces& checked) {
  RoomJson json{{"places", list_of_places(checked.places)},
                {"is_checked", checked.problem.empty()}};
  if (!checked.problem.empty()) {
    json["problem"] = checked.problem;
    return json;
  }
  json["after"] = findings_json(checked.after);
  json["passing"] = checked.passing;
  json["asked"] = checked.asked;
  json["broken"] = checked.broken;
  return json;
}

}  // namespace

RoomJson places_json(const std::vector<RoomPlaces>& rooms) {
  RoomJson json = RoomJson::array();
  for (const RoomPlaces& room : rooms) {
    RoomJson one{{"scene", room.scene}, {"space", room.space_id}};
    if (!room.problem.empty()) one["problem"] = room.problem;
    one["unit"] = room.is_by_flux ? "lm" : "W";
    one["requirements"] = requirements_json(room.requirements);
    one["left_out"] = room.left_out;
    one["step_m"] = {room.step_m.x, room.step_m.y};
    one["least_distance_m"] = room.least_distance_m;
    one["cells"] = room.cells;
    one["passing"] = room.passing;
    one["asked"] = room.asked;
    one["places"] = list_of_places(room.places);
    one["best"] = RoomJson::array();
    for (const CheckedPlaces& checked : room.best) one["best"].push_back(checked_json(checked));
    if (room.together) one["together"] = checked_json(*room.together);
    json.push_back(std::move(one));
  }
  return json;
}

RoomJson spare_json(const std::vector<RoomSpare>& rooms) {
  RoomJson json = RoomJson::array();
  for (const RoomSpare& room : rooms) {
    RoomJson one{{"space", room.space_id}};
    if (!room.problem.empty()) one["problem"] = room.problem;
    one["unit"] = room.is_by_flux ? "lm" : "W";
    one["of"] = room.of;
    one["passing"] = room.passing;
    one["asked"] = room.asked;
    one["luminaires"] = RoomJson::array();
    for (const SpareLuminaire& its : room.luminaires) {
      one["luminaires"].push_back({{"id", its.id},
                                   {"type", its.type},
                                   {"group", its.group},
                                   {"position_m", place_vector_json(its.position_m)},
                                   {"cost", its.cost}});
    }
    json.push_back(std::move(one));
  }
  return json;
}

RoomJson surfaces_json(const std::vector<RoomSurfaces>& rooms) {
  RoomJson json = RoomJson::array();
  for (const RoomSurfaces& room : rooms) {
    RoomJson one{{"scene", room.scene}, {"space", room.space_id}};
    if (!room.problem.empty()) one["problem"] = room.problem;
    one["requirements"] = requirements_json(room.requirements);
    one["reflectance_step"] = kReflectanceStep;
    one["surfaces"] = RoomJson::array();
    for (const LighterSurface& surface : room.surfaces) {
      RoomJson its{{"surface", surface.surface},
                   {"reflectance", surface.reflectance},
                   {"slope_lx", gains_json(surface.slope_lx)},
                   {"step_lx", gains_json(surface.step_lx)},
                   {"is_checked", !surface.after.empty()}};
      if (!surface.problem.empty()) its["problem"] = surface.problem;
      if (!surface.after.empty()) its["after"] = findings_json(surface.after);
      one["surfaces"].push_back(std::move(its));
    }
    json.push_back(std::move(one));
  }
  return json;
}

}  // namespace cli
