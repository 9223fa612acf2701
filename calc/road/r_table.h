#pragma once
// Road surfaces: tables of the reduced luminance coefficient r of CIE 140 / EN 13201-3, for a view
// 1 degree below the horizon. L = I r / H^2 of one luminaire; r = q cos^3(epsilon).
//
// Sources of the figures: public programs that print them, compared cell by cell (the standard
// itself was not at hand). R1, R2, R4 and C2: three sources, R3: four; C1, W3 and W4: only one, so
// trust them less. 19 cells differ between sources; each was chosen by majority, by a corrected
// print of CIE 140 (C2 at beta 2 for tan 0.5 and 3.5, at beta 0 for tan 11.5), or because the other
// figure breaks its row and column (swapped digits in R1, a shifted row in R2). Of such cells only
// R4 at tan 4.5, beta 90 is open (6.4 here, or 6.2); W3 at tan 10, beta 2 (168.1) is a likely
// misprint, near 124, and kept. On a mean luminance these cells weigh 0.02 % (R3).
//
// S1 = r(beta 0, tan 2) / r(beta 0, tan 0) of each table is that of its class. Q0, the mean of q
// over the solid angle, is 1.4 to 4 % above its nominal value for every table, by the range of
// integration used: never rescale a table by it.

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace calc {

inline constexpr std::size_t kRTableTans = 29, kRTableBetas = 20;

inline constexpr std::array<double, kRTableTans> kRTableTan{
    0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5,  3.0,  3.5,  4.0,  4.5, 5.0,
    5.5, 6.0,  6.5, 7.0,  7.5, 8.0,  8.5, 9.0,  9.5, 10.0, 10.5, 11.0, 11.5, 12.0};
inline constexpr std::array<double, kRTableBetas> kRTableBeta_deg{
    0.0,  2.0,  5.0,  10.0, 15.0,  20.0,  25.0,  30.0,  35.0,  40.0,
    45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0, 180.0};

struct RTable {
  std::string_view name;
  double q0;  // nominal, of the figures, cd / (m^2 lx)
  bool is_wet;
  std::array<std::array<double, kRTableBetas>, kRTableTans> r_1e4;  // [tan][beta], r * 10^4, >= 0
};

// Returns R1 R2 R3 R4 C1 C2 W3 or W4; nullptr for other names.
const RTable* r_table(std::string_view name);
std::vector<std::string_view> r_table_names();

// Returns r * 10^4, bilinear between the nodes. tan_epsilon >= 0: of the light's angle from the
// vertical; 0 beyond the table's 12 (which belongs to it, with 1e-9 for rounding), because holding
// the last value would add light without a measurement. beta_deg in [0, 180]: between the vertical
// planes of view and light, 0 where the luminaire is beyond the point as the eye sees it.
double r_1e4(const RTable& table, double tan_epsilon, double beta_deg);

}  // namespace calc
