#pragma once
// Reads <housing> of a <luminaire-type>.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/reading/project_files.h"
#include "calc/scene/project.h"

#include <vector>

namespace calc {

// element: of the type, the next one of the project. light: of the type, at least one. Sets
// type.housing, and for a mesh the context's housing_meshes; neither after an error.
void read_housing(ProjectContext& context, const XmlElement& element,
                  const std::vector<PlacedWeb>& light, LuminaireType& type);

}  // namespace calc
