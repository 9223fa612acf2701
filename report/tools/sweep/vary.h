#pragma once
// What a sweep varies: paths with the values of each, and all their combinations.

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

// "linear.flux-lm=3000:5000:500", "L.columns=3,4,6:10:2": values, and ranges from:to:step, which
// end at or before `to`. Numbers of a range have as many decimals as it is written with. Empty with
// a problem, which says what is allowed.
std::optional<Vary> parse_vary(const std::string& text, std::string& problem);

// Of all combinations; more than kMostVariants are only known to be more.
std::size_t count_variants(const std::vector<Vary>& vary);
// Of the variant of that number, from 0; the last one varies fastest. One value for each path.
std::vector<std::string> values_of_variant(const std::vector<Vary>& vary, std::size_t variant);
// The same with their paths.
std::vector<check::SetValue> settings_of_variant(const std::vector<Vary>& vary,
                                                 const std::vector<std::string>& values);

}  // namespace cli
