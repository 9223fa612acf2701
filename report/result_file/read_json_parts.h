#pragma once
// What read_json() is made of: one function for each kind of thing in a result file. All of them
// throw BadJson.

#include "report/document/document.h"
#include "report/result_file/json_cursor.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace report {

// read_json_values.cpp
int read_whole(const JsonCursor& at, std::int64_t low = 0);  // low..INT_MAX
std::size_t read_size(const JsonCursor& at);
std::optional<double> read_optional_number(const JsonCursor& at);  // finite, or null
glm::dvec3 read_vec3(const JsonCursor& at);
glm::dvec2 read_vec2(const JsonCursor& at);
std::vector<glm::dvec2> read_polygon(const JsonCursor& at);
calc::Estimate read_estimate(const JsonCursor& at);
calc::SourceLocation read_location(const JsonCursor& at);

// read_json_luminaire.cpp
LuminaireRow read_luminaire(const JsonCursor& at);

// read_json_finding.cpp; plane: its id and quantity are known already
rules::Verdict read_verdict(const JsonCursor& at);
rules::Finding read_finding(const JsonCursor& at, const PlanePart& plane);

// read_json_aggregate.cpp
rules::AggregateFinding read_aggregate(const JsonCursor& at);

// read_json_plane.cpp
PlanePart read_plane(const JsonCursor& at, const std::string& space_id);

// read_json_space.cpp
SpacePart read_space(const JsonCursor& at);

}  // namespace report
