#include "report/tools/import/ifc_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kWorkOfProduct = std::size_t{16} << 20;
constexpr std::size_t kWorkOfInstance = 64;  // however short it is
// The file's own is that of its bytes so many times, and this.
constexpr std::size_t kTimesBytes = 8, kWorkOfFile = std::size_t{64} << 20;

}  // namespace

IfcFile::IfcFile(const StepText& text, IfcUnits units)
    : text_(text), units_(std::move(units)), of_product_(kWorkOfProduct), of_file_(kWorkOfFile) {
  for (std::uint32_t i = 0; i < text.size(); ++i) {
    of_file_ += kTimesBytes * (text.bytes(i) + kWorkOfInstance);
  }
}

void IfcFile::begin_product() { of_product_ = kWorkOfProduct; }

void IfcFile::work(std::size_t amount) {
  if (amount > of_file_) {
    of_file_ = 0;
    throw IfcLeftOut{"earlier shapes of the file have used up the work that is allowed"};
  }
  of_file_ -= amount;
  if (amount > of_product_) throw IfcLeftOut{"its shape is too large"};
  of_product_ -= amount;
}

std::uint32_t IfcFile::follow(const StepValue& reference, std::string_view what) {
  if (reference.is_null()) throw IfcLeftOut{fmt::format("it has no {}", what)};
  const std::optional<std::uint32_t> instance = text_.find(reference);
  if (!instance) throw IfcLeftOut{fmt::format("its {} is not in the file", what)};
  return *instance;
}

std::vector<StepValue> IfcFile::arguments(std::uint32_t instance, std::size_t least) {
  work(text_.bytes(instance) + kWorkOfInstance);
  std::vector<StepValue> arguments = text_.arguments(instance);
  if (arguments.size() < least) {
    throw IfcLeftOut{fmt::format("{} has {} arguments; at least {} are needed",
                                 text_.name(instance), arguments.size(), least)};
  }
  return arguments;
}

std::vector<StepValue> IfcFile::arguments_of(const StepValue& reference, std::string_view name,
                                             std::size_t least) {
  const std::uint32_t instance = follow(reference, name);
  if (text_.name(instance) != name) {
    throw IfcLeftOut{fmt::format("{} is found where {} is needed", text_.name(instance), name)};
  }
  return arguments(instance, least);
}

double IfcFile::number(const StepValue& value, std::string_view what) const {
  const std::optional<double> number = value.untyped().number();
  if (!number) throw IfcLeftOut{fmt::format("its {} is not a number", what)};
  return *number;
}

double IfcFile::length_m(const StepValue& value, std::string_view what) const {
  const double length_m = units_.length_m(number(value, what));
  if (!(std::fabs(length_m) <= kFarthestIfc)) {
    throw IfcLeftOut{fmt::format("its {} is beyond {:g} m", what, kFarthestIfc)};
  }
  return length_m;
}

double IfcFile::positive_length_m(const StepValue& value, std::string_view what) const {
  const double length = length_m(value, what);
  if (!(length > 0.0)) throw IfcLeftOut{fmt::format("its {} is not > 0", what)};
  return length;
}

glm::dvec3 IfcFile::coordinates_m(const StepValue& list) const {
  const std::vector<StepValue> items = list.items();
  if (items.size() < 2 || items.size() > 3) {
    throw IfcLeftOut{"a point without two or three coordinates"};
  }
  glm::dvec3 point(0.0);
  for (std::size_t i = 0; i < items.size(); ++i) {
    point[static_cast<glm::length_t>(i)] = length_m(items[i], "coordinate");
  }
  return point;
}

glm::dvec3 IfcFile::point_m(const StepValue& reference) {
  return coordinates_m(arguments_of(reference, "IFCCARTESIANPOINT", 1)[0]);
}

glm::dvec3 IfcFile::direction(const StepValue& reference) {
  const std::vector<StepValue> items = arguments_of(reference, "IFCDIRECTION", 1)[0].items();
  glm::dvec3 direction(0.0);
  if (items.size() == 2 || items.size() == 3) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      direction[static_cast<glm::length_t>(i)] = number(items[i], "direction");
    }
  }
  // Its longest part first, so that nothing overflows.
  const double longest =
      std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  if (!(longest > 0.0)) throw IfcLeftOut{"a direction without a length"};
  direction /= longest;
  return direction / std::sqrt(glm::dot(direction, direction));
}

}  // namespace cli
