#pragma once
// A building from a design file (DXF, IFC), independent of the format: the readers of these files
// return it and the writer of projects takes it. Metres, degrees, world coordinates with z up, as
// in the file, except for the removed origin.

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cli {

// Largest distance between an arc and its chords.
inline constexpr double kChordError_m = 1.0e-3;

// The place of a thing in its file, to find it again at the next import, and for readers of the
// report. key: unique in the file and the same in its next version if the file allows it (GlobalId
// of IFC, handle of DXF, else layer and place). place: in words, "layer A-ROOM, line 812".
struct DesignSource {
  std::string key, place;
};

struct DesignRoom {
  DesignSource source;
  std::string number, name, use;                // as the file says them, UTF-8; empty: not said
  std::string storey;                           // empty: not said
  std::vector<glm::dvec2> outline_m;            // simple, counter-clockwise, at least 3 corners
  std::vector<std::vector<glm::dvec2>> hole_m;  // clockwise
  double floor_z_m = 0.0;
  std::optional<double> height_m;  // > 0; a plan does not know it
  std::size_t rule = 0;  // which [[room]] of the map took it; the first where nothing else decides
  std::vector<std::string> doubt = {};  // about its shape, in words, as the notes say them
};

struct DesignLuminaire {
  DesignSource source;
  std::string type;  // name of the block or of the type: what a map gives photometry to
  std::string storey;
  glm::dvec3 position_m{0.0};  // of the point of insertion
  bool has_height = false;     // false: z is not known
  double rotation_deg = 0.0;   // counter-clockwise seen from above, [0, 360)
  bool is_mirrored = false;
  std::vector<std::pair<std::string, std::string>> attribute;  // name and value, in file order
  std::optional<std::size_t> rule;  // which [[luminaire]] of the map took it; none: not decided yet
};

// Furniture and other obstacles: an upright box.
struct DesignBox {
  DesignSource source;
  std::string name;
  glm::dvec3 centre_m{0.0};  // of its foot
  glm::dvec3 size_m{0.0};    // before rotation, all > 0
  double rotation_deg = 0.0;
  std::size_t rule = 0;  // as of rooms: [[furniture]]
};

// A route for people, or the outline of a calculation plane.
struct DesignLine {
  DesignSource source;
  std::string name;
  std::vector<glm::dvec3> point_m;
  std::size_t rule = 0;  // as of rooms: [[plane]], [[route]]
};

// A fact about the file that readers of the report must know, reported once for equal things.
struct DesignNote {
  // left_out: requested by the map but not imported; not_asked: not requested.
  enum class Kind { taken, left_out, doubt, not_asked };
  Kind kind = Kind::left_out;
  std::string what, why, place;  // of the first one
  std::size_t count = 1;
};

struct Design {
  std::string file;
  std::string unit, unit_reason;  // "mm", "stated by the map; the header says inch"
  double metres_per_unit = 1.0;   // of numbers that stay text, such as attributes
  glm::dvec3 origin_m{0.0};       // taken away from all coordinates
  std::vector<DesignRoom> room;
  std::vector<DesignLuminaire> luminaire;
  std::vector<DesignBox> box;
  std::vector<DesignLine> route, plane;
  std::vector<DesignNote> note;
};

}  // namespace cli
