#pragma once
// <material>, <luminaire-type> and <scene>: what rooms and results refer to.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

void read_materials(ProjectContext& context, const XmlElement& root);
void read_luminaire_types(ProjectContext& context, const XmlElement& root);
// After all luminaires, whose groups it refers to.
void read_light_scenes(ProjectContext& context, const XmlElement& root);

}  // namespace calc
