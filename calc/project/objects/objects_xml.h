#pragma once
// Reads all objects that a room, the open space or an assembly may contain.

#include "calc/base/xml_document.h"
#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"

namespace calc {

inline constexpr int kAssemblyDepthLimit = 16;

// Returns all child elements that are objects (kObjects), in the coordinates around them; the
// caller reads the other children.
ObjectSet read_objects(ProjectContext& context, const XmlElement& parent);

}  // namespace calc
