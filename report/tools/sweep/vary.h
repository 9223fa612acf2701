#pragma once
// The variations of a sweep: paths with their values, and all combinations.

#include "report/check/set_values.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

inline constexpr std::size_t kMostVariants = 100'000;

struct Vary {
  std::string path;
  std::vector<std::string> values;  // as the project file would have them, none twice
};

// Reads "linear.flux-lm=3000:5000:500", "L.columns=3,4,6:10:2": values, and ranges from:to:step,
// which end at or before `to`. Numbers of a range have as many decimals as it is written with.
// Empty with a problem, which says what is allowed.
std::optional<Vary> parse_vary(const std::string& text, std::string& problem);

// Returns the number of combinations; above kMostVariants only some larger number.
std::size_t count_variants(const std::vector<Vary>& vary);
// Returns the values of the variant with that number, from 0; the last path varies fastest. One
// value for each path.
std::vector<std::string> values_of_variant(const std::vector<Vary>& vary, std::size_t variant);
// Returns the values with their paths.
std::vector<check::SetValue> settings_of_variant(const std::vector<Vary>& vary,
                                                 const std::vector<std::string>& values);

}  // namespace cli
