#pragma once
// Reads <room>, <road> and the open space around all rooms.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

inline constexpr const char* kOpenSpaceId = "site";

// Append to Project::spaces; the open space only if it contains anything.
void read_rooms(ProjectContext& context, const XmlElement& root);
void read_open_space(ProjectContext& context, const XmlElement& root);

}  // namespace calc
