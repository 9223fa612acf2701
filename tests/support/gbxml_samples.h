#pragma once
// A small gbXML building made in memory.

#include <glm/glm.hpp>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace calc::tests {

inline std::string poly_loop(const std::vector<glm::dvec3>& corners) {
  std::string text = "<PlanarGeometry><PolyLoop>";
  for (const glm::dvec3& p : corners) {
    text += fmt::format(
        "<CartesianPoint><Coordinate>{}</Coordinate><Coordinate> {}\n</Coordinate>"
        "<Coordinate>{}</Coordinate></CartesianPoint>",
        p.x, p.y, p.z);
  }
  return text + "</PolyLoop></PlanarGeometry>\n";
}

inline std::string gbxml_opening(const std::string& id, const std::string& type,
                                 const std::vector<glm::dvec3>& corners) {
  return fmt::format("<Opening id=\"{}\" openingType=\"{}\">", id, type) + poly_loop(corners) +
         "</Opening>";
}

inline std::string gbxml_surface(const std::string& id, const std::string& type,
                                 const std::vector<std::string>& spaces,
                                 const std::vector<glm::dvec3>& corners,
                                 const std::string& openings = "") {
  std::string text = fmt::format("<Surface id=\"{}\" surfaceType=\"{}\">", id, type);
  for (const std::string& space : spaces) {
    text += fmt::format("<AdjacentSpaceId spaceIdRef=\"{}\"/>", space);
  }
  return text + poly_loop(corners) + openings + "</Surface>\n";
}

// Space "low" (0..4 x 0..3 x 0..2.5) with a window of 2 x 1 in its south wall, below space "high".
inline std::string two_rooms(
    const std::string& window = gbxml_opening("window", "FixedWindow",
                                              {{1, 0, 1}, {3, 0, 1}, {3, 0, 2}, {1, 0, 2}})) {
  return "<?xml version=\"1.0\"?>\n<!-- a <sample> -->\n"
         "<gbXML xmlns=\"http://www.gbxml.org/schema\" lengthUnit=\"Meters\">\n<Campus id=\"c\">"
         "<Building id=\"b\">\n<Space id=\"low\"><Name> Low room </Name></Space>\n"
         "<Space id=\"high\"/><Space id=\"empty\"/></Building>\n" +
         gbxml_surface("slab", "SlabOnGrade", {"low"},
                       {{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}}) +
         gbxml_surface("south", "ExteriorWall", {"low"},
                       {{0, 0, 0}, {4, 0, 0}, {4, 0, 2.5}, {0, 0, 2.5}}, window) +
         gbxml_surface("north", "ExteriorWall", {"low"},
                       {{0, 3, 0}, {0, 3, 2.5}, {4, 3, 2.5}, {4, 3, 0}}) +
         gbxml_surface("west", "InteriorWall", {"low", "low"},
                       {{0, 0, 0}, {0, 0, 2.5}, {0, 3, 2.5}, {0, 3, 0}}) +
         gbxml_surface("east", "ExteriorWall", {"low"},
                       {{4, 0, 0}, {4, 3, 0}, {4, 3, 2.5}, {4, 0, 2.5}}) +
         gbxml_surface("deck", "InteriorFloor", {"high", "low"},
                       {{0, 0, 2.5}, {4, 0, 2.5}, {4, 3, 2.5}, {0, 3, 2.5}}) +
         gbxml_surface("roof", "Roof", {"high"}, {{0, 0, 5}, {4, 0, 5}, {4, 3, 5}, {0, 3, 5}}) +
         gbxml_surface("tree", "Shade", {}, {{9, 0, 0}, {9, 1, 0}, {9, 1, 1}}) +
         "</Campus></gbXML>\n";
}

}  // namespace calc::tests
