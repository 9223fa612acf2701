#pragma once
// Reads the colour of light that photometry files state, in many notations.

#include <optional>
#include <string_view>

namespace calc {

// Colour rendering index between `low` and `high`, 0 < low <= high <= 100.
struct StatedRa {
  double low = 0.0, high = 0.0;
};

// Reads "80", "Ra 80", "CRI=80", "Ra>80", ">= 80", "80-89" and the groups of EULUMDAT and DIN 5035,
// "1A" to "4", also as "R1b". Empty: anything else, because its meaning is unknown.
std::optional<StatedRa> stated_ra(std::string_view text);

// Returns kelvin, 1000 to 25000, of "4000", "4000K", "4000 K". Empty: anything else.
std::optional<double> stated_colour_temperature_k(std::string_view text);

}  // namespace calc
