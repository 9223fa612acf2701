#pragma once
// What this program is made of.

#include "report/shell/command/command.h"

#include <string>

namespace cli {

// The answer to `luxgate version`: program, numbers, compiler, build type, Embree, vectors in use.
// Lines, or a JSON object that has the OpenGL devices too, which takes a moment.
std::string version_text(bool as_json);

Command version_command();

}  // namespace cli
