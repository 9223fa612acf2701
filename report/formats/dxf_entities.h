#pragma once
// Entities of a DXF file of R12, and the tables that stand before them. Lengths are given in metres
// and written in the unit of the drawing; each function appends to `dxf`. Layers and blocks: names
// that dxf_name() makes.

#include <glm/glm.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// A piece of the file.
struct DxfText {
  std::string bytes;
  double per_metre = 1.0;  // units of the drawing
};

// A group: its code and its value, which must be on one line.
void dxf_group(int code, std::string_view value, DxfText& dxf);
void dxf_group(int code, int value, DxfText& dxf);
void dxf_group(int code, double value, DxfText& dxf);
void dxf_length(int code, double metres, DxfText& dxf);
// Of a code for x; y and z have the codes 10 and 20 further.
void dxf_point(int code, const glm::dvec3& point, DxfText& dxf);

// Colours by their numbers (AutoCAD's).
enum class DxfColour {
  red = 1,
  green = 3,
  cyan = 4,
  blue = 5,
  magenta = 6,
  ink = 7,  // black on white, white on black
  grey = 8,
  orange = 30,
  sky = 150,
  by_layer = 256
};

void dxf_line(std::string_view layer, const glm::dvec3& from, const glm::dvec3& to, DxfText& dxf);

// Flat where all corners are of one height, else in space. Nothing of less than two corners.
void dxf_polyline(std::string_view layer, const std::vector<glm::dvec3>& corners, bool is_closed,
                  DxfColour colour, DxfText& dxf);

void dxf_circle(std::string_view layer, const glm::dvec3& middle, double radius_m, DxfText& dxf);

enum class DxfAlign { start, middle };  // its base line's start, or its middle, is at the point

// words: as dxf_text() or dxf_lines() make them; nothing of "".
void dxf_words(std::string_view layer, const glm::dvec3& at, double height_m,
               std::string_view words, DxfAlign align, DxfColour colour, DxfText& dxf);

// How wide words are at most, with the font "txt".
double dxf_width_m(std::string_view words, double height_m);

// Tag and value, as dxf_text() makes it.
struct DxfAttribute {
  std::string_view tag;
  std::string value;
  glm::dvec2 place_m{0.0};  // of the start of its base line, from the base point of the block
  bool is_visible = false;
};

// text_m: height of its attributes, which do not turn with it.
void dxf_insert(std::string_view layer, std::string_view block, const glm::dvec3& at,
                double rotation_deg, const std::vector<DxfAttribute>& attributes, double text_m,
                DxfText& dxf);
// entities: of the block, around its base point 0. attributes: those that its inserts have, with
// the values that a new insert is offered.
void dxf_block(std::string_view layer, std::string_view block, std::string_view entities,
               const std::vector<DxfAttribute>& attributes, double text_m, DxfText& dxf);

struct DxfLayer {
  DxfColour colour = DxfColour::ink;
  bool is_frozen = false;
};
struct DxfHead {
  std::map<std::string, DxfLayer> layers;  // by name
  glm::dvec2 low_m{0.0}, high_m{0.0};      // of everything that is not frozen
  double text_m = 0.0;                     // height of texts
  int unit = 0;                            // of the drawing, as $INSUNITS numbers them
};
// Header and tables: all layers, one style "STANDARD", one line type.
void dxf_head(const DxfHead& head, DxfText& dxf);
void dxf_section(std::string_view name, DxfText& dxf);
void dxf_section_end(DxfText& dxf);

}  // namespace report
