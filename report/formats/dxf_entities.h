#pragma once
// Entities of a DXF file of R12, and the tables that stand before them. Lengths in metres; each
// function appends to `dxf`. Layers and blocks: names that dxf_name() makes.

#include <glm/glm.hpp>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {

// A group: its code and its value, which must be on one line.
void dxf_group(int code, std::string_view value, std::string& dxf);
void dxf_group(int code, int value, std::string& dxf);
void dxf_group(int code, double value, std::string& dxf);
// Of a code for x; y and z have the codes 10 and 20 further.
void dxf_point(int code, const glm::dvec3& point, std::string& dxf);

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

void dxf_line(std::string_view layer, const glm::dvec3& from, const glm::dvec3& to,
              std::string& dxf);

// Flat where all corners are of one height, else in space. Nothing of less than two corners.
void dxf_polyline(std::string_view layer, const std::vector<glm::dvec3>& corners, bool is_closed,
                  DxfColour colour, std::string& dxf);

void dxf_circle(std::string_view layer, const glm::dvec3& middle, double radius_m,
                std::string& dxf);

enum class DxfAlign { start, middle };  // its base line's start, or its middle, is at the point

// words: as dxf_text() or dxf_lines() make them; nothing of "".
void dxf_words(std::string_view layer, const glm::dvec3& at, double height_m,
               std::string_view words, DxfAlign align, DxfColour colour, std::string& dxf);

// How wide words are at most, with the font "txt".
double dxf_width_m(std::string_view words, double height_m);

// Tag and value, as dxf_text() makes it; not visible in the drawing.
using DxfAttribute = std::pair<std::string_view, std::string>;

void dxf_insert(std::string_view layer, std::string_view block, const glm::dvec3& at,
                double rotation_deg, const std::vector<DxfAttribute>& attributes, std::string& dxf);
// entities: of the block, around its base point 0. tags: of the attributes that its inserts have.
void dxf_block(std::string_view layer, std::string_view block, std::string_view entities,
               const std::vector<std::string_view>& tags, std::string& dxf);

struct DxfLayer {
  DxfColour colour = DxfColour::ink;
  bool is_off = false;
};
// Header and tables: all layers by name, one style "STANDARD", one line type. low, high: of
// everything drawn; equal corners where there is nothing.
void dxf_head(const std::map<std::string, DxfLayer>& layers, const glm::dvec2& low,
              const glm::dvec2& high, std::string& dxf);
void dxf_section(std::string_view name, std::string& dxf);
void dxf_section_end(std::string& dxf);

}  // namespace report
