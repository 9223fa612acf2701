#pragma once
// Writes JSON text that people can read and diff: objects one key per line, arrays of numbers on
// one line.

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Returns text that ends in '\n'. Broken UTF-8 becomes U+FFFD, a number that is not finite null.
std::string json_layout(const nlohmann::ordered_json& json);

// Returns the text inside another JSON text, `depth` lists and objects deep: its lines are
// indented, but not the first, and nothing follows it.
std::string json_layout_within(const nlohmann::ordered_json& json, std::size_t depth);

// Return a gap for a value that is filled in later, and the text in pieces before, between and
// after such gaps.
nlohmann::ordered_json json_gap();
std::vector<std::string> json_layout_around_gaps(const nlohmann::ordered_json& json,
                                                 std::size_t depth);

}  // namespace report
