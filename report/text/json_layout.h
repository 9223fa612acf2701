#pragma once
// JSON text that people can read and diff: objects one key per line, arrays of numbers on one line.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace report {

// Ends in '\n'. Broken UTF-8 becomes U+FFFD, a number that is not finite null.
std::string json_layout(const nlohmann::ordered_json& json);

}  // namespace report
