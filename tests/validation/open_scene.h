#pragma once
// Scenes of the open validation cases.

#include "report/tools/selftest/scene.h"
#include "tests/validation/open_tables.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace validation {

// Corners of a surface's polygon.
std::vector<glm::dvec3> corners_of(const Row& surface);

// The rectangle that four corners make; empty if they make none. Its normal is the right-hand one.
std::optional<cli::selftest::Rectangle> rectangle_of(const std::vector<glm::dvec3>& corners);

// Surfaces, their own light, and luminaires of a case. rho: in place of every surface's own;
// NotCovered if it takes what the program has not.
cli::selftest::Scene open_scene(const std::string& id, const Tables& tables,
                                std::optional<double> rho);

// Where luminaires of the case are, arrays spelled out.
std::vector<glm::dvec3> lamps_of(const std::string& id, const Tables& tables);

}  // namespace validation
