#include "calc/project/objects/luminaires_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/project/objects/frame.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace calc {
namespace {

constexpr double kSamePoint_m = 1.0e-9;

glm::dmat3 read_orientation_for_axis(ElementReader& reader, const glm::dvec3& axis) {
  reader.exclude("rotation", "c0");
  if (!reader.has("c0")) return luminaire_frame(axis, read_angle_rad(reader, "rotation"));
  const std::size_t errors = reader.diagnostics().error_count();
  const glm::dvec3 c0 = read_vector(reader, "c0");
  const std::optional<glm::dmat3> frame = luminaire_frame_towards(axis, c0);
  if (frame) return *frame;
  if (reader.diagnostics().error_count() == errors) {
    reader.report(DiagnosticId::c0_parallel_to_axis, reader.where("c0"), reader.element().name);
  }
  return luminaire_frame(axis, 0.0);
}

glm::dmat3 read_orientation(ElementReader& reader) {
  const glm::dvec3 axis =
      reader.has("axis") ? read_direction(reader, "axis") : glm::dvec3(0, 0, -1);
  return read_orientation_for_axis(reader, axis);
}

glm::dmat3 read_aimed_orientation(const ProjectContext& context, ElementReader& reader,
                                  const glm::dvec3& position_m) {
  const std::size_t errors = reader.diagnostics().error_count();
  glm::dvec3 axis = read_point_m(context, reader, "aim") - position_m;
  if (glm::length(axis) < kSamePoint_m) {
    if (reader.diagnostics().error_count() == errors) {
      reader.report(DiagnosticId::aim_at_itself, reader.where("aim"), reader.element().name);
    }
    axis = {0, 0, -1};
  }
  return read_orientation_for_axis(reader, axis);
}

// What all luminaires of one element have in common; position and orientation are filled in later.
Luminaire read_common(ProjectContext& context, ElementReader& reader, const ElementRow& row) {
  reader.allow_attributes(row);
  Luminaire luminaire;
  luminaire.id = reader.text_or("id", "");
  luminaire.type = context.luminaire_types.find(reader, "type");
  luminaire.world_from_luminaire = glm::dmat3(1.0);
  luminaire.where = reader.where();
  if (reader.has("group")) {
    luminaire.group = trim(reader.text("group"));
    context.groups.insert(luminaire.group);
  }
  reader.allow_children(row);
  return luminaire;
}

}  // namespace

std::vector<Luminaire> read_luminaire(ProjectContext& context, ElementReader& reader) {
  Luminaire luminaire = read_common(context, reader, kLuminaireElement);
  luminaire.position_m = read_point_m(context, reader, "position");
  reader.exclude("axis", "aim");
  luminaire.world_from_luminaire =
      reader.has("aim") ? read_aimed_orientation(context, reader, luminaire.position_m)
                        : read_orientation(reader);
  if (!reader.ok()) return {};
  return {luminaire};
}

std::vector<Luminaire> read_luminaire_grid(ProjectContext& context, ElementReader& reader) {
  Luminaire common = read_common(context, reader, kLuminaireGridElement);
  const glm::dvec3 origin = read_point_m(context, reader, "origin");
  const std::vector<double> size = reader.numbers("size", 2, "2 numbers (x y)", kPositive);
  const int columns = reader.integer("columns", 1);
  const int rows = reader.integer("rows", 1);
  const glm::dmat3 turn = rotation_about_z(read_angle_rad(reader, "array-rotation"));
  common.world_from_luminaire = turn * read_orientation(reader);
  if (!reader.ok()) return {};
  if (!check_room_for(context, reader, static_cast<double>(columns) * rows, 0)) return {};
  const glm::dvec3 cell =
      glm::dvec3(size[0] / columns, size[1] / rows, 0) * context.metres_per_unit;
  std::vector<Luminaire> luminaires;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Luminaire luminaire = common;
      luminaire.id = fmt::format("{}[{},{}]", common.id, column, row);
      luminaire.position_m = origin + turn * (cell * glm::dvec3(column + 0.5, row + 0.5, 0));
      luminaires.push_back(std::move(luminaire));
    }
  }
  return luminaires;
}

std::vector<Luminaire> read_luminaire_line(ProjectContext& context, ElementReader& reader) {
  Luminaire common = read_common(context, reader, kLuminaireLineElement);
  const glm::dvec3 from = read_point_m(context, reader, "from");
  const glm::dvec3 to = read_point_m(context, reader, "to");
  const bool to_the_ends = reader.choice_or("edge", kLineEndsType.words, 0) == 1;
  const int count = reader.integer("count", 1);
  common.world_from_luminaire = read_orientation(reader);
  if (!reader.ok()) return {};
  if (glm::distance(from, to) < kSamePoint_m) {
    reader.report(DiagnosticId::line_without_length, reader.where("to"));
  }
  if (to_the_ends && count < 2) {
    reader.report(DiagnosticId::number_out_of_range, reader.where("count"), "count",
                  reader.element().name, count, "a whole number from 2 with edge=\"end\"");
  }
  if (!reader.ok() || !check_room_for(context, reader, count, 0)) return {};
  std::vector<Luminaire> luminaires;
  for (int i = 0; i < count; ++i) {
    const double share = to_the_ends ? static_cast<double>(i) / (count - 1) : (i + 0.5) / count;
    Luminaire luminaire = common;
    luminaire.id = fmt::format("{}[{}]", common.id, i);
    luminaire.position_m = from + share * (to - from);
    luminaires.push_back(std::move(luminaire));
  }
  return luminaires;
}

std::vector<Luminaire> read_luminaire_ring(ProjectContext& context, ElementReader& reader) {
  Luminaire common = read_common(context, reader, kLuminaireRingElement);
  const glm::dvec3 centre = read_point_m(context, reader, "centre");
  const double radius = reader.number("radius", kPositive) * context.metres_per_unit;
  const double start_rad = read_angle_rad(reader, "start");
  const bool turns = reader.choice_or("turn", kRingTurnType.words, 0) == 0;
  const int count = reader.integer("count", 1);
  common.world_from_luminaire = read_orientation(reader);
  if (!reader.ok() || !check_room_for(context, reader, count, 0)) return {};
  std::vector<Luminaire> luminaires;
  for (int i = 0; i < count; ++i) {
    const glm::dmat3 turn = rotation_about_z(start_rad + 2.0 * kPi * i / count);
    Luminaire luminaire = common;
    luminaire.id = fmt::format("{}[{}]", common.id, i);
    luminaire.position_m = centre + turn * glm::dvec3(radius, 0, 0);
    if (turns) luminaire.world_from_luminaire = turn * common.world_from_luminaire;
    luminaires.push_back(std::move(luminaire));
  }
  return luminaires;
}

std::vector<Luminaire> read_luminaire_list(ProjectContext& context, ElementReader& reader) {
  reader.allow(kLuminaireListElement);
  const std::string file = reader.text("file");
  const LuminaireList* list =
      file.empty() ? nullptr : context.files.luminaire_list(file, reader.where("file"));
  if (list == nullptr || !reader.ok()) return {};
  if (!check_room_for(context, reader, static_cast<double>(list->entry.size()), 0)) return {};
  std::vector<Luminaire> luminaires;
  for (const LuminaireEntry& entry : list->entry) {
    Luminaire luminaire;
    luminaire.where = {list->file, entry.line, 0};
    luminaire.id = reader.text("id") + "." + entry.name;
    const std::optional<std::size_t> type = context.luminaire_types.look_up(entry.type);
    if (!type) {
      reader.report(
          DiagnosticId::luminaire_list_line, luminaire.where,
          fmt::format("unknown luminaire type '{}'{}", shorten_utf8(entry.type, 60),
                      suggestion(shorten_utf8(entry.type, 60), context.luminaire_types.ids())));
      return {};
    }
    luminaire.type = *type;
    luminaire.position_m = entry.position_m;
    const glm::dvec3 axis =
        entry.aim_m ? *entry.aim_m - entry.position_m : entry.axis.value_or(glm::dvec3(0, 0, -1));
    luminaire.world_from_luminaire = luminaire_frame(glm::normalize(axis), entry.rotation_rad);
    luminaire.group = entry.group;
    if (!entry.group.empty()) context.groups.insert(entry.group);
    luminaires.push_back(std::move(luminaire));
  }
  return luminaires;
}

}  // namespace calc
