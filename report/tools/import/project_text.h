#pragma once
// A project file from a design and its map, as a person would write it.

#include "report/tools/import/design.h"
#include "report/tools/import/import_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

struct ProjectText {
  std::string xml;
  // Meshes that the project names, from its folder. A name follows from what is in it.
  struct File {
    std::string name, bytes;
  };
  std::vector<File> file;
  std::size_t rooms = 0, luminaires = 0, boxes = 0, planes = 0, routes = 0;  // written
};

// photometry: of each [[luminaire]] of the map its file from the project's folder; "" = there is
// none, so that its luminaires are left out. A hole of a room becomes a solid from floor to
// ceiling, since a prism has none: a box where it is a rectangle, else a mesh. Lengths to 0.1 mm,
// angles to 0.001 degrees. What is not written, or not as the design has it, is appended to the
// design's notes.
ProjectText project_text(Design& design, const ImportMap& map,
                         const std::vector<std::string>& photometry);

}  // namespace cli
