#pragma once
// Finds the room of a design that contains a thing.

#include "report/tools/import/design.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace cli {

// Returns the room by its outline seen from above, without its holes. If there are several: those
// of the same storey, if both name it; then those with z between floor and ceiling, if z is known;
// then the smallest.
std::optional<std::size_t> room_at(const Design& design, const glm::dvec2& at,
                                   std::optional<double> z, const std::string& storey);

}  // namespace cli
