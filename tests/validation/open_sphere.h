#pragma once
// Integrating spheres of triangles, with a lamp of 1000 lm in the middle.

#include "report/tools/selftest/scene.h"
#include "tests/validation/open_places.h"
#include "tests/validation/open_tables.h"

#include <optional>
#include <string>

namespace validation {

struct SphereCase {
  cli::selftest::Scene scene;
  Places places;
  double largest_rho = 0.0;
  double known_to = 0.0;  // relative: quadrature, and what triangles lack to the sphere
  std::string note;       // for the number's name
};

// "rho=0.5" with "E total, mesh average": the mesh that lies beside the tables; "ideal sphere":
// 5120 triangles of its own. Empty for other words.
std::optional<SphereCase> sphere_case(const std::string& name, const std::string& quantity,
                                      const Tables& tables);

}  // namespace validation
