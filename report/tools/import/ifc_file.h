#pragma once
// What all readers of IFC instances share: following references, numbers in metres, and how much
// work a file may ask for.

#include "report/tools/import/ifc_units.h"
#include "report/tools/import/step_text.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Thrown by everything that reads one product; who asked for the product leaves it out, with this
// reason. why: a clause, the same for things alike.
struct IfcLeftOut {
  std::string why;
};

inline constexpr double kFarthestIfc = 1.0e9;  // metres: larger numbers are no building

class IfcFile {
 public:
  IfcFile(const StepText& text, IfcUnits units);

  const StepText& text() const { return text_; }
  const IfcUnits& units() const { return units_; }

  // The work that a product may ask for begins anew; that of the whole file goes on.
  void begin_product();
  // amount: in bytes of text that is read, or what takes as long.
  void work(std::size_t amount);

  // All of these throw IfcLeftOut; what: what is looked for, for the reason.
  std::uint32_t follow(const StepValue& reference, std::string_view what);
  // At least so many.
  std::vector<StepValue> arguments(std::uint32_t instance, std::size_t least);
  std::vector<StepValue> arguments_of(const StepValue& reference, std::string_view name,
                                      std::size_t least);
  double number(const StepValue& value, std::string_view what) const;
  double length_m(const StepValue& value, std::string_view what) const;
  double positive_length_m(const StepValue& value, std::string_view what) const;
  // Of a list of two or three lengths.
  glm::dvec3 coordinates_m(const StepValue& list) const;
  glm::dvec3 point_m(const StepValue& reference);    // IFCCARTESIANPOINT
  glm::dvec3 direction(const StepValue& reference);  // IFCDIRECTION, of length 1

 private:
  const StepText& text_;
  IfcUnits units_;
  std::size_t of_product_ = 0, of_file_ = 0;  // work left
};

}  // namespace cli
