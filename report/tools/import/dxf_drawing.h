#pragma once
// A DXF file as a drawing: layers, blocks and entities, and their places in the world. Lengths in
// the file's unit; angles in degrees.

#include "report/tools/import/dxf_curve.h"
#include "report/tools/import/dxf_pairs.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// Limits, so that no file uses all memory or time.
inline constexpr std::size_t kMostDxfEntities = 2'000'000;  // as the file has them
inline constexpr std::size_t kMostDxfPlaced = 1'000'000;    // with those of blocks, each time
inline constexpr std::size_t kDeepestDxfBlock = 32;
inline constexpr std::size_t kLongestDxfHandle = 16;     // digits; longer ones are none
inline constexpr std::size_t kLongestDxfName = 1020;     // bytes, of layers and blocks: 255 letters
inline constexpr std::size_t kMostDxfWork = 10'000'000;  // in points, to measure blocks

struct DxfVertex {
  glm::dvec3 at{0.0};
  double bulge = 0.0;  // tan(angle / 4) of the arc to the next one; > 0: counter-clockwise
};

// The side from a vertex to the next, if it is neither a line nor an arc.
struct DxfCurvedSide {
  std::size_t vertex;
  DxfCurve curve;
};

struct DxfEntity {
  // outline: HATCH, one for each of its loops. curve: ELLIPSE, SPLINE. face: 3DFACE, SOLID, TRACE.
  // mesh: corners of polyface and polygon meshes.
  enum class Kind { line, polyline, outline, insert, text, circle, arc, curve, face, mesh, point };
  Kind kind = Kind::point;
  std::string layer, handle;  // handle: "" in old files
  std::size_t place = 0;      // of its first pair
  bool is_closed = false, is_hidden = false;
  bool is_in_world = false;  // points are in world coordinates, else in those of `normal`
  glm::dvec3 normal{0.0, 0.0, 1.0};
  std::vector<DxfCurvedSide> side;  // by vertex
  std::vector<DxfVertex> vertex;  // of circles and arcs the centre, of texts and inserts the place
  double radius = 0.0, start_deg = 0.0, end_deg = 0.0;
  std::string text;   // plain, on one line
  std::string block;  // of INSERT: as the user calls it, also where it is a dynamic one
  std::string block_in_file;
  glm::dvec3 scale{1.0};
  double rotation_deg = 0.0;
  int columns = 1, rows = 1;
  double column_step = 0.0, row_step = 0.0;
  std::vector<std::pair<std::string, std::string>> attribute;
  bool is_clipped = false;  // XCLIP: part of the block's content is hidden
};

struct DxfBlock {
  std::string name;
  glm::dvec3 base{0.0};
  std::vector<DxfEntity> entity;
  bool is_external = false;  // an xref: its content is in another file
};

struct DxfLayer {
  std::string name;
  bool is_off = false, is_frozen = false;
};

// Skipped entities: {kind, layer, why}, with their number.
using DxfSkipped = std::map<std::array<std::string, 3>, std::size_t>;

struct DxfDrawing {
  std::string version;                    // "AC1015"; "" = not said
  std::optional<int> unit;                // $INSUNITS
  std::map<std::string, DxfLayer> layer;  // by dxf_key()
  std::map<std::string, DxfBlock> block;  // by dxf_key()
  std::vector<DxfEntity> entity;          // of model space
  DxfSkipped skipped;
  std::string text_doubt;  // see DxfTexts
  std::string end_doubt;   // that its end is missing, but no part of it; "" = it is whole
  bool is_binary = false;
  std::string place_words(std::size_t place) const;
};

// Returns the key of a name: names are compared without case.
std::string dxf_key(std::string_view name);

// Returns the drawing; empty exactly if `problem` says why.
std::optional<DxfDrawing> read_dxf(std::string_view bytes, std::string& problem);

// World = matrix * (point of the entity's own coordinates, 1).
struct DxfPlaced {
  const DxfEntity* entity = nullptr;
  glm::dmat4 to_world{1.0};  // of INSERT: of the block's coordinates, its base not yet taken away
  std::string layer;         // the block reference's, where the entity is on layer 0 of a block
  std::string key;           // handles on the way to it; "" = the file has none
  int column = 0, row = 0;   // of an INSERT with several
  bool is_off = false;       // its layer is, or that of a reference on the way

  glm::dvec3 at(std::size_t vertex) const;
  // Returns its corners in the world, with arcs and curves as chords at most that far from them.
  // Mirrors and turns keep bulges; in a stretched block they become chords of the stretched arc.
  // reached: above largest_error if a limit of dxf_curve.h leaves the chords farther away; else
  // equal.
  std::vector<glm::dvec3> corners(double largest_error, double* reached = nullptr) const;
};

// Visits every entity of model space at each of its places; an INSERT with rows and columns once
// for each. visit: returns for an INSERT whether to enter its block. Hidden entities are skipped
// and counted in `skipped`. Returns "" or the limit that was met.
std::string visit_dxf(const DxfDrawing& drawing, const std::function<bool(const DxfPlaced&)>& visit,
                      DxfSkipped& skipped);

// Returns the work of finding its corners, as a number of points with equal work.
std::size_t corner_work(const DxfEntity& entity);

// The extent of a block in its own coordinates: lines, outlines, arcs and faces, with those of
// nested blocks; texts do not count.
struct DxfExtent {
  glm::dvec3 low{0.0}, high{0.0};
  bool is_any = false;
  std::size_t faces = 0, meshes = 0;  // among what it is of
  std::string problem;                // why it cannot be measured; is_any is false then
};
// Returns the extent. work: the remaining work (see kMostDxfWork), which is reduced.
DxfExtent extent_of_block(const DxfDrawing& drawing, const std::string& block_in_file,
                          std::size_t& work);

}  // namespace cli
