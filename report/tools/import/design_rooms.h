#pragma once
// In which room of a design a thing stands.

#include "report/tools/import/design.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace cli {

// By the outline as seen from above, without its holes. Of several: those of the storey, where both
// say one; then those with z between floor and ceiling, where z is known; then the smallest.
std::optional<std::size_t> room_at(const Design& design, const glm::dvec2& at,
                                   std::optional<double> z, const std::string& storey);

}  // namespace cli
