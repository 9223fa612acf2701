#pragma once
// Everything that can stand in a room, in the open space or in an assembly.

#include "calc/scene/object_set.h"
#include "calc/scene/project_context.h"
#include "calc/xml_document.h"

namespace calc {

inline constexpr int kAssemblyDepthLimit = 16;

// "box", "quad", ..., "luminaire-ring".
const Names& object_names();

// All child elements with one of these names, in the coordinates around them; other children are
// left to the caller.
ObjectSet read_objects(ProjectContext& context, const XmlElement& parent);

}  // namespace calc
