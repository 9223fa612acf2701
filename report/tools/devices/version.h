#pragma once
// Describes the build of this program.

#include "report/shell/command/command.h"

#include <string>

namespace cli {

// Returns the answer to `luxgate version`: program, numbers, compiler, build type, Embree, vectors
// in use. Lines, or a JSON object that also lists the OpenGL devices, which takes a moment.
std::string version_text(bool as_json);

Command version_command();

}  // namespace cli
