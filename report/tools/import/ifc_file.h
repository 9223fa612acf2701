#pragma once
// Shared by all readers of IFC instances: following references, numbers in metres, and the limit of
// work for a file.

#include "report/tools/import/ifc_units.h"
#include "report/tools/import/step_text.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Thrown by all functions that read a product; their caller omits the product with this reason.
// why: a clause, equal for equal reasons.
struct IfcLeftOut {
  std::string why;
};

inline constexpr double kFarthestIfc = 1.0e9;  // metres: larger numbers are no building

class IfcFile {
 public:
  IfcFile(const StepText& text, IfcUnits units);

  const StepText& text() const { return text_; }
  const IfcUnits& units() const { return units_; }

  // Restarts the count of work for a product; the count of the whole file continues.
  void begin_product();
  // Counts work. amount: bytes of text that are read, or work that takes as long.
  void work(std::size_t amount);

  // Return parts of the file; all of these throw IfcLeftOut. what: name of the wanted part, for the
  // reason.
  std::uint32_t follow(const StepValue& reference, std::string_view what);
  // Returns at least this many arguments.
  std::vector<StepValue> arguments(std::uint32_t instance, std::size_t least);
  std::vector<StepValue> arguments_of(const StepValue& reference, std::string_view name,
                                      std::size_t least);
  double number(const StepValue& value, std::string_view what) const;
  double length_m(const StepValue& value, std::string_view what) const;
  double positive_length_m(const StepValue& value, std::string_view what) const;
  // Returns the coordinates in a list of two or three lengths.
  glm::dvec3 coordinates_m(const StepValue& list) const;
  glm::dvec3 point_m(const StepValue& reference);    // IFCCARTESIANPOINT
  glm::dvec3 direction(const StepValue& reference);  // IFCDIRECTION, of length 1

 private:
  const StepText& text_;
  IfcUnits units_;
  std::size_t of_product_ = 0, of_file_ = 0;  // work left
};

}  // namespace cli
