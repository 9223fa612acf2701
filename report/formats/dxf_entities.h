#pragma once
// Entities of a DXF file of R12, and the tables before them. Lengths are given in metres and
// written in the unit of the drawing; each function appends to `dxf`. Layers and blocks: names from
// dxf_name().

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

// Appends a group: its code and its value, which must be on one line.
void dxf_group(int code, std::string_view value, DxfText& dxf);
void dxf_group(int code, int value, DxfText& dxf);
void dxf_group(int code, double value, DxfText& dxf);
void dxf_length(int code, double metres, DxfText& dxf);
// Appends a point. code: for x; the codes of y and z are 10 and 20 higher.
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

// Appends a polyline, flat if all corners have one height, else in space; nothing for less than two
// corners.
void dxf_polyline(std::string_view layer, const std::vector<glm::dvec3>& corners, bool is_closed,
                  DxfColour colour, DxfText& dxf);

void dxf_circle(std::string_view layer, const glm::dvec3& middle, double radius_m, DxfText& dxf);

enum class DxfAlign { start, middle };  // its base line's start, or its middle, is at the point

// Appends words from dxf_text() or dxf_lines(); nothing for "".
void dxf_words(std::string_view layer, const glm::dvec3& at, double height_m,
               std::string_view words, DxfAlign align, DxfColour colour, DxfText& dxf);

// Returns an upper limit on the width of words with the font "txt".
double dxf_width_m(std::string_view words, double height_m);

// An attribute: tag and value from dxf_text().
struct DxfAttribute {
  std::string_view tag;
  std::string value;
  glm::dvec2 place_m{0.0};  // of the start of its base line, from the base point of the block
  bool is_visible = false;
};

// Appends an insert. text_m: height of its attributes, which do not turn with it.
void dxf_insert(std::string_view layer, std::string_view block, const glm::dvec3& at,
                double rotation_deg, const std::vector<DxfAttribute>& attributes, double text_m,
                DxfText& dxf);
// Appends a block. entities: of the block, around its base point 0. attributes: those of its
// inserts, with the default values for a new insert.
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
// Appends header and tables: all layers, one style "STANDARD", one line type.
void dxf_head(const DxfHead& head, DxfText& dxf);
void dxf_section(std::string_view name, DxfText& dxf);
void dxf_section_end(DxfText& dxf);

}  // namespace report
