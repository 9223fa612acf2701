#include "report/text/storey_title.h"

#include "report/text/text_numbers.h"

#include <cmath>

namespace report {

std::string storey_title(const Texts& t, double floor_z_m) {
  constexpr double kSteps = 20.0;  // of a metre
  const double height = std::round(floor_z_m * kSteps) / kSteps;
  const char* sign = height > 0.0 ? "+" : height < 0.0 ? "−" : "±";
  return t.say<Text::storey_at>(sign + format_fixed(t, std::abs(height), 2));
}

}  // namespace report
