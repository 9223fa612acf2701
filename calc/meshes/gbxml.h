#pragma once
// Reads from gbXML (Green Building XML) the surfaces around a space. Prefixes of names are ignored,
// lengths become metres.

#include "calc/base/diagnostics.h"
#include "calc/scene/polygon_mend.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct GbxmlOpening {
  std::string id, type;  // openingType
  std::vector<glm::dvec3> corner_m;
  int line = 0;
};

struct GbxmlSurface {
  struct Side {
    std::string space;  // spaceIdRef
    std::string type;   // as the space sees it; "" = the surface's type
  };
  std::string id, type;  // surfaceType
  std::vector<Side> side;
  std::vector<glm::dvec3> corner_m;
  std::vector<GbxmlOpening> opening;
  int line = 0;
};

struct GbxmlSpace {
  std::string id, name;
  std::vector<glm::dvec3> floor_m;  // corners of its own PlanarGeometry; empty if it has none
};

struct GbxmlBuilding {
  std::string file;
  std::vector<GbxmlSpace> space;
  std::vector<GbxmlSurface> surface;
};

// Returns whether the root element is gbXML, with any prefix, in any encoding of decoded_xml().
bool is_gbxml(std::string_view bytes);

// Returns the building; empty if and only if an error was reported.
std::optional<GbxmlBuilding> parse_gbxml(std::string bytes, const std::string& name,
                                         Diagnostics& diagnostics);

// A surface without its openings, or an opening.
struct GbxmlPart {
  std::string id, type;
  std::vector<glm::dvec3> vertex_m;
  std::vector<glm::uvec3> triangle;
};

struct GbxmlRoom {
  std::string name;
  std::vector<GbxmlPart> part;
  // The outline of the space's own PlanarGeometry, else of the floor if it is one polygon; empty if
  // that is not horizontal. The height is that of the highest surface above it.
  std::vector<glm::dvec2> footprint_m;
  double floor_z_m = 0.0, height_m = 0.0;
  // Repairs (polygon_mend.h), and the missing area of what could not be repaired.
  Mending mending;
  std::size_t polygons_mended = 0, polygons_left_out = 0;
  double area_left_out_m2 = 0.0;
};

// Returns all surfaces next to the space. Each point belongs to one part: openings are cut out of
// their surface, and out of each other. InteriorFloor is distinguished from Ceiling by its place
// below or above the middle of the room, unless the file states the space's view of it. Outlines
// are repaired, and unusable ones are omitted with their area; a warning reports both. Empty, with
// an error at `where`, if there is no such space or it has no surface.
std::optional<GbxmlRoom> gbxml_room(const GbxmlBuilding& building, const std::string& space_id,
                                    const SourceLocation& where, Diagnostics& diagnostics);

}  // namespace calc
