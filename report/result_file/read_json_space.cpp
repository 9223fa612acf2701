#include "report/result_file/read_json_parts.h"

#include <array>

namespace report {
namespace {

// What later versions added may be missing.
LuminaireMark luminaire_mark(const JsonCursor& at) {
  LuminaireMark mark{read_vec3(at["position_m"]), at["type"].text()};
  if (const auto group = at.find("group")) mark.group = group->text();
  if (const auto outline = at.find("outline_m")) mark.outline_m = read_polygon(*outline);
  if (const auto c0 = at.find("c0")) mark.c0 = read_vec2(*c0);
  return mark;
}

BodyMark body_mark(const JsonCursor& at) {
  BodyMark mark;
  mark.id = at["id"].text();
  mark.low_z_m = at["low_z_m"].finite();
  mark.high_z_m = at["high_z_m"].finite();
  mark.lines_m = at["lines_m"].list_of([](const JsonCursor& line) {
    const std::vector<JsonCursor> c = line.items(4);
    return std::array{glm::dvec2(c[0].finite(), c[1].finite()),
                      glm::dvec2(c[2].finite(), c[3].finite())};
  });
  return mark;
}

}  // namespace

SpacePart read_space(const JsonCursor& at) {
  SpacePart s;
  s.id = at["id"].text();
  s.name = at["name"].text();
  s.footprint_m = read_polygon(at["footprint_m"]);
  s.floor_z_m = at["floor_z_m"].finite();
  if (const auto power = at.find("power")) {
    s.power = {(*power)["power_w"].finite(), (*power)["area_m2"].finite(),
               read_whole((*power)["luminaires"]), read_whole((*power)["without_power"])};
  }
  s.height_m = at["height_m"].finite();
  s.triangles = read_size(at["triangles"]);
  s.degenerate_triangles = read_size(at["degenerate_triangles"]);
  s.luminaires = at["luminaires"].list_of(luminaire_mark);
  if (const auto bodies = at.find("bodies")) s.bodies = bodies->list_of(body_mark);
  if (const auto left_out = at.find("bodies_left_out")) s.bodies_left_out = read_size(*left_out);
  const JsonCursor balance = at["flux_balance"];
  s.balance = {balance["emitted_lm"].number(), balance["untraced_lm"].number(),
               read_estimate(balance["absorbed_lm"]), read_estimate(balance["escaped_lm"])};
  if (const auto notes = at.find("notes")) {
    s.notes = notes->list_of([](const JsonCursor& note) { return note.text(); });
  }
  s.planes = at["planes"].list_of([&](const JsonCursor& p) { return read_plane(p, s.id); });
  return s;
}

}  // namespace report
