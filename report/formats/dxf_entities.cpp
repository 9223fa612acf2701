#include "report/formats/dxf_entities.h"

#include "report/formats/dxf_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace report {
namespace {

void begin(std::string_view entity, std::string_view layer, DxfText& dxf) {
  dxf_group(0, entity, dxf);
  dxf_group(8, layer, dxf);
}

void colour_group(DxfColour colour, DxfText& dxf) {
  if (colour != DxfColour::by_layer) dxf_group(62, static_cast<int>(colour), dxf);
}

void begin_table(std::string_view name, int entries, DxfText& dxf) {
  dxf_group(0, "TABLE", dxf);
  dxf_group(2, name, dxf);
  dxf_group(70, entries, dxf);
}

// What is looked at when the file is opened: all of it.
void view(const glm::dvec2& low, const glm::dvec2& high, DxfText& dxf) {
  constexpr double kLeast_m = 1.0, kAspect = 1.6, kRoom = 1.05;
  const glm::dvec2 size = glm::max(high - low, glm::dvec2(kLeast_m));
  const auto flat = [&dxf](int code, double x, double y) {
    dxf_group(code, x, dxf);
    dxf_group(code + 10, y, dxf);
  };
  const auto direction = [&](int code, double z) {
    flat(code, 0.0, 0.0);
    dxf_group(code + 20, z, dxf);
  };
  begin_table("VPORT", 1, dxf);
  dxf_group(0, "VPORT", dxf);
  dxf_group(2, "*ACTIVE", dxf);
  dxf_group(70, 0, dxf);
  flat(10, 0.0, 0.0);  // corners of the window
  flat(11, 1.0, 1.0);
  dxf_length(12, 0.5 * (low.x + high.x), dxf);
  dxf_length(22, 0.5 * (low.y + high.y), dxf);
  flat(13, 0.0, 0.0);  // snap and grid
  flat(14, 1.0, 1.0);
  flat(15, 1.0, 1.0);
  direction(16, 1.0);
  direction(17, 0.0);
  dxf_length(40, kRoom * std::max(size.y, size.x / kAspect), dxf);
  dxf_group(41, kAspect, dxf);
  dxf_group(42, 50.0, dxf);  // lens
  for (const int code : {43, 44, 50, 51}) dxf_group(code, 0.0, dxf);
  dxf_group(71, 0, dxf);
  dxf_group(72, 100, dxf);
  for (const int code : {73, 74}) dxf_group(code, 1, dxf);
  for (const int code : {75, 76, 77, 78}) dxf_group(code, 0, dxf);
  dxf_group(0, "ENDTAB", dxf);
}

}  // namespace

void dxf_group(int code, std::string_view value, DxfText& dxf) {
  dxf.bytes += fmt::format("{:>3}\r\n{}\r\n", code, value);
}
void dxf_group(int code, int value, DxfText& dxf) {
  dxf_group(code, fmt::format("{}", value), dxf);
}
void dxf_group(int code, double value, DxfText& dxf) { dxf_group(code, dxf_number(value), dxf); }
void dxf_length(int code, double metres, DxfText& dxf) {
  dxf_group(code, metres * dxf.per_metre, dxf);
}

void dxf_point(int code, const glm::dvec3& point, DxfText& dxf) {
  dxf_length(code, point.x, dxf);
  dxf_length(code + 10, point.y, dxf);
  dxf_length(code + 20, point.z, dxf);
}

void dxf_line(std::string_view layer, const glm::dvec3& from, const glm::dvec3& to, DxfText& dxf) {
  begin("LINE", layer, dxf);
  dxf_point(10, from, dxf);
  dxf_point(11, to, dxf);
}

void dxf_polyline(std::string_view layer, const std::vector<glm::dvec3>& corners, bool is_closed,
                  DxfColour colour, DxfText& dxf) {
  constexpr int kClosed = 1, kInSpace = 8, kCornerInSpace = 32;
  if (corners.size() < 2) return;
  const bool is_flat = std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
    return dxf_number(corner.z) == dxf_number(corners.front().z);
  });
  begin("POLYLINE", layer, dxf);
  colour_group(colour, dxf);
  dxf_group(66, 1, dxf);
  dxf_point(10, {0, 0, is_flat ? corners.front().z : 0.0}, dxf);
  dxf_group(70, (is_closed ? kClosed : 0) + (is_flat ? 0 : kInSpace), dxf);
  for (const glm::dvec3& corner : corners) {
    begin("VERTEX", layer, dxf);
    dxf_point(10, corner, dxf);
    if (!is_flat) dxf_group(70, kCornerInSpace, dxf);
  }
  begin("SEQEND", layer, dxf);
}

void dxf_circle(std::string_view layer, const glm::dvec3& middle, double radius_m, DxfText& dxf) {
  begin("CIRCLE", layer, dxf);
  dxf_point(10, middle, dxf);
  dxf_length(40, radius_m, dxf);
}

double dxf_width_m(std::string_view words, double height_m) {
  return static_cast<double>(words.size()) * height_m;
}

void dxf_words(std::string_view layer, const glm::dvec3& at, double height_m,
               std::string_view words, DxfAlign align, DxfColour colour, DxfText& dxf) {
  if (words.empty()) return;
  const bool is_middle = align == DxfAlign::middle;
  // Programs that know the second point alone place the text by that, others by the first.
  const glm::dvec3 start =
      is_middle ? at - 0.5 * glm::dvec3(dxf_width_m(words, height_m), height_m, 0.0) : at;
  begin("TEXT", layer, dxf);
  colour_group(colour, dxf);
  dxf_point(10, start, dxf);
  dxf_length(40, height_m, dxf);
  dxf_group(1, words, dxf);
  if (!is_middle) return;
  dxf_group(72, 1, dxf);
  dxf_point(11, at, dxf);
  dxf_group(73, 2, dxf);
}

namespace {

// Of an ATTRIB and an ATTDEF alike. at: of the insert.
void attribute_groups(const DxfAttribute& attribute, const glm::dvec3& at, double text_m,
                      DxfText& dxf) {
  constexpr int kHidden = 1;
  dxf_point(10, at + glm::dvec3(attribute.place_m, 0.0), dxf);
  dxf_length(40, text_m, dxf);
  dxf_group(1, attribute.value, dxf);
  dxf_group(2, attribute.tag, dxf);
  dxf_group(70, attribute.is_visible ? 0 : kHidden, dxf);
}

}  // namespace

void dxf_insert(std::string_view layer, std::string_view block, const glm::dvec3& at,
                double rotation_deg, const std::vector<DxfAttribute>& attributes, double text_m,
                DxfText& dxf) {
  begin("INSERT", layer, dxf);
  if (!attributes.empty()) dxf_group(66, 1, dxf);
  dxf_group(2, block, dxf);
  dxf_point(10, at, dxf);
  dxf_group(50, rotation_deg, dxf);
  if (attributes.empty()) return;
  for (const DxfAttribute& attribute : attributes) {
    begin("ATTRIB", layer, dxf);
    attribute_groups(attribute, at, text_m, dxf);
  }
  begin("SEQEND", layer, dxf);
}

void dxf_block(std::string_view layer, std::string_view block, std::string_view entities,
               const std::vector<DxfAttribute>& attributes, double text_m, DxfText& dxf) {
  begin("BLOCK", layer, dxf);
  dxf_group(2, block, dxf);
  dxf_group(70, attributes.empty() ? 0 : 2, dxf);
  dxf_point(10, {0, 0, 0}, dxf);
  dxf_group(3, block, dxf);
  dxf.bytes += entities;
  for (const DxfAttribute& attribute : attributes) {
    begin("ATTDEF", layer, dxf);
    dxf_group(3, attribute.tag, dxf);
    attribute_groups(attribute, {0, 0, 0}, text_m, dxf);
  }
  begin("ENDBLK", layer, dxf);
}

void dxf_section(std::string_view name, DxfText& dxf) {
  dxf_group(0, "SECTION", dxf);
  dxf_group(2, name, dxf);
}
void dxf_section_end(DxfText& dxf) { dxf_group(0, "ENDSEC", dxf); }

void dxf_head(const DxfHead& head, DxfText& dxf) {
  dxf_section("HEADER", dxf);
  dxf_group(9, "$ACADVER", dxf);
  dxf_group(1, "AC1009", dxf);
  dxf_group(9, "$DWGCODEPAGE", dxf);
  dxf_group(3, kDxfCodePage, dxf);
  dxf_group(9, "$EXTMIN", dxf);
  dxf_point(10, {head.low_m, 0.0}, dxf);
  dxf_group(9, "$EXTMAX", dxf);
  dxf_point(10, {head.high_m, 0.0}, dxf);
  dxf_group(9, "$LUNITS", dxf);
  dxf_group(70, 2, dxf);  // decimal
  dxf_group(9, "$INSUNITS", dxf);
  dxf_group(70, head.unit, dxf);
  dxf_group(9, "$TEXTSIZE", dxf);
  dxf_length(40, head.text_m, dxf);
  dxf_section_end(dxf);

  dxf_section("TABLES", dxf);
  view(head.low_m, head.high_m, dxf);
  begin_table("LTYPE", 1, dxf);
  dxf_group(0, "LTYPE", dxf);
  dxf_group(2, "CONTINUOUS", dxf);
  dxf_group(70, 0, dxf);
  dxf_group(3, "Solid line", dxf);
  dxf_group(72, 65, dxf);
  dxf_group(73, 0, dxf);
  dxf_group(40, 0.0, dxf);
  dxf_group(0, "ENDTAB", dxf);
  begin_table("LAYER", static_cast<int>(head.layers.size() + 1), dxf);
  const auto layer_row = [&dxf](std::string_view name, const DxfLayer& layer) {
    const int colour = static_cast<int>(layer.colour);
    dxf_group(0, "LAYER", dxf);
    dxf_group(2, name, dxf);
    dxf_group(70, layer.is_frozen ? 1 : 0, dxf);
    dxf_group(62, colour, dxf);
    dxf_group(6, "CONTINUOUS", dxf);
  };
  layer_row("0", {});
  for (const auto& [name, layer] : head.layers) layer_row(name, layer);
  dxf_group(0, "ENDTAB", dxf);
  begin_table("STYLE", 1, dxf);
  dxf_group(0, "STYLE", dxf);
  dxf_group(2, "STANDARD", dxf);
  dxf_group(70, 0, dxf);
  for (const int code : {40, 41, 50}) dxf_group(code, code == 41 ? 1.0 : 0.0, dxf);
  dxf_group(71, 0, dxf);
  dxf_group(42, 0.2, dxf);
  dxf_group(3, "txt", dxf);
  dxf_group(4, "", dxf);
  dxf_group(0, "ENDTAB", dxf);
  dxf_section_end(dxf);
}

}  // namespace report
