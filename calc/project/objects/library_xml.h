#pragma once
// Reads <material>, <luminaire-type> and <scene>: the definitions that rooms and results refer to.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

void read_materials(ProjectContext& context, const XmlElement& root);
void read_luminaire_types(ProjectContext& context, const XmlElement& root);
// Requires that all luminaires are read, because it refers to their groups.
void read_light_scenes(ProjectContext& context, const XmlElement& root);

}  // namespace calc
