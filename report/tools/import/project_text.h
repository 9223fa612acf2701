#pragma once
// Writes a project file from a design and its map, in the form that a person would write.

#include "report/tools/import/design.h"
#include "report/tools/import/import_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

struct ProjectText {
  std::string xml;
  // Meshes that the project names, from its folder. Names follow from the contents.
  struct File {
    std::string name, bytes;
  };
  std::vector<File> file;
  std::size_t rooms = 0, luminaires = 0, boxes = 0, planes = 0, routes = 0;  // written
};

// Returns the project. photometry: for each [[luminaire]] of the map its file from the project's
// folder; "" = there is none, and its luminaires are omitted. A hole of a room becomes a solid from
// floor to ceiling, because a prism has no holes: a box for a rectangle, else a mesh. Lengths to
// 0.1 mm, angles to 0.001 degrees. Omissions and changes are appended to the design's notes.
ProjectText project_text(Design& design, const ImportMap& map,
                         const std::vector<std::string>& photometry);

}  // namespace cli
