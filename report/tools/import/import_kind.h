#pragma once
// Finds the kind of a plan before it is read.

#include <string>
#include <string_view>

namespace cli {

// Returns true for IFC models, also for packed ones and those in XML, whose reader refuses them by
// name. Requires that import_kind_problem() found nothing.
bool is_read_as_ifc(std::string_view bytes);

// Returns "cannot import 'hall.obj': it is an OBJ mesh; import reads DXF and IFC. ...", or "" if it
// may be a drawing or a model.
std::string import_kind_problem(std::string_view bytes, const std::string& path);

// Returns the problem of a reader of drawings, with further words if the contents are not known as
// DXF.
std::string unread_drawing(std::string_view bytes, const std::string& path,
                           const std::string& problem);

}  // namespace cli
