#include "report/tools/import/ifc_placement.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace cli {
namespace {

constexpr double kParallel = 1.0e-9;  // sine of an angle

// x without what it has along z, of length 1.
glm::dvec3 across(const glm::dvec3& x, const glm::dvec3& z) {
  const glm::dvec3 part = x - glm::dot(x, z) * z;
  const double length = std::sqrt(glm::dot(part, part));
  if (!(length > kParallel)) throw IfcLeftOut{"two axes of a placement are parallel"};
  return part / length;
}

glm::dmat4 frame(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z,
                 const glm::dvec3& origin) {
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(origin, 1.0)};
}

// The direction that IFC takes where none is given.
glm::dvec3 default_x(const glm::dvec3& z) {
  const bool is_along_x = std::fabs(z.x) > 1.0 - kParallel;
  return is_along_x ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
}

}  // namespace

glm::dmat4 ifc_axis_placement(IfcFile& file, const StepValue& reference) {
  if (reference.is_null()) return glm::dmat4(1.0);
  const std::uint32_t instance = file.follow(reference, "placement");
  const std::string& name = file.text().name(instance);
  if (name == "IFCAXIS2PLACEMENT3D") {
    const std::vector<StepValue> a = file.arguments(instance, 3);
    const glm::dvec3 z = a[1].is_null() ? glm::dvec3(0.0, 0.0, 1.0) : file.direction(a[1]);
    const glm::dvec3 x = across(a[2].is_null() ? default_x(z) : file.direction(a[2]), z);
    return frame(x, glm::cross(z, x), z, file.point_m(a[0]));
  }
  if (name == "IFCAXIS2PLACEMENT2D") {
    const std::vector<StepValue> a = file.arguments(instance, 2);
    const glm::dvec3 z(0.0, 0.0, 1.0);
    const glm::dvec3 x =
        across(a[1].is_null() ? glm::dvec3(1.0, 0.0, 0.0) : file.direction(a[1]), z);
    return frame(x, glm::cross(z, x), z, file.point_m(a[0]));
  }
  throw IfcLeftOut{fmt::format("a placement by {} is not read", name)};
}

glm::dmat4 ifc_operator(IfcFile& file, const StepValue& reference) {
  const std::uint32_t instance = file.follow(reference, "target");
  const std::string& name = file.text().name(instance);
  const bool is_uneven = name == "IFCCARTESIANTRANSFORMATIONOPERATOR3DNONUNIFORM";
  if (!is_uneven && name != "IFCCARTESIANTRANSFORMATIONOPERATOR3D") {
    throw IfcLeftOut{fmt::format("a target by {} is not read", name)};
  }
  const std::vector<StepValue> a = file.arguments(instance, is_uneven ? 7 : 5);
  const glm::dvec3 z = a[4].is_null() ? glm::dvec3(0.0, 0.0, 1.0) : file.direction(a[4]);
  const glm::dvec3 x = across(a[0].is_null() ? default_x(z) : file.direction(a[0]), z);
  glm::dvec3 y = glm::cross(z, x);
  if (!a[1].is_null() && glm::dot(file.direction(a[1]), y) < 0.0) y = -y;  // a mirror
  const auto scale = [&](std::size_t i, double otherwise) {
    const double factor = a[i].is_null() ? otherwise : file.number(a[i], "scale");
    if (!(factor > 1.0e-6 && factor < 1.0e6)) throw IfcLeftOut{"its scale is not plausible"};
    return factor;
  };
  const double by_x = scale(3, 1.0);
  const double by_y = is_uneven ? scale(5, by_x) : by_x;
  const double by_z = is_uneven ? scale(6, by_x) : by_x;
  return frame(by_x * x, by_y * y, by_z * z, file.point_m(a[2]));
}

glm::dmat4 IfcPlacements::world_from(const StepValue& reference) {
  std::vector<std::pair<std::uint32_t, glm::dmat4>> chain;  // of frames in their parents'
  StepValue next = reference;
  glm::dmat4 world(1.0);
  do {
    const std::uint32_t instance = file_.follow(next, "placement");
    const auto found = known_.find(instance);
    if (found != known_.end()) {
      world = found->second;
      break;
    }
    if (chain.size() >= kLongestPlacementChain) {
      throw IfcLeftOut{fmt::format("its placement is a chain of more than {}, or refers to itself",
                                   kLongestPlacementChain)};
    }
    if (file_.text().name(instance) != "IFCLOCALPLACEMENT") {
      throw IfcLeftOut{fmt::format("a placement by {} is not read", file_.text().name(instance))};
    }
    const std::vector<StepValue> a = file_.arguments(instance, 2);
    if (a[1].is_null()) throw IfcLeftOut{"a placement without a place"};
    chain.emplace_back(instance, ifc_axis_placement(file_, a[1]));
    next = a[0];
  } while (!next.is_null());
  for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
    world = world * link->second;
    known_.emplace(link->first, world);
  }
  return world;
}

}  // namespace cli
