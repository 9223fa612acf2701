#pragma once
// Everything that can stand in a room, in the open space or in an assembly.

#include "calc/base/xml_document.h"
#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"

namespace calc {

inline constexpr int kAssemblyDepthLimit = 16;

// All child elements that are objects (kObjects), in the coordinates around them; other children
// are left to the caller.
ObjectSet read_objects(ProjectContext& context, const XmlElement& parent);

}  // namespace calc
