#pragma once
// The version of luxgate that made something.

#include <string>

namespace report {

std::string program_version();  // "0.1.0"

}  // namespace report
