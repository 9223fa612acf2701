#pragma once
// What this program is made of.

#include <string>

namespace cli {

std::string program_version();  // "0.1.0"
// The answer to `luxgate version`: program, numbers, compiler, build type, Embree, vectors in use.
// Lines, or a JSON object that has the OpenGL devices too, which takes a moment.
std::string version_text(bool as_json);

}  // namespace cli
