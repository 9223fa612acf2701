#pragma once
// False colours of what a rasteriser drew of a room.

#include "report/heatmap.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace report {

// Rows from the top, kOversampling times as wide and high as the picture that is made of it.
struct DrawnRoom {
  int width = 0, height = 0;        // multiples of kOversampling
  std::vector<float> lx;            // of the surface seen, < 0 = none
  std::vector<std::uint8_t> cover;  // RGBA over it, premultiplied
};
inline constexpr int kOversampling = 2;

// Paints values and puts the cover over them; transparent where there is neither.
Raster paint_room(const DrawnRoom& drawn, const std::function<Rgb(float)>& colour);

// The mean of what is seen in each pixel, < 0 where there is nothing.
std::vector<float> mean_values(const DrawnRoom& drawn);

// From 0 to what all but the brightest hundredth of the pixels have, and the given values.
ColourScale room_scale(std::span<const DrawnRoom> rooms, std::span<const double> values_lx);

// On white, with a colour bar below.
Raster with_legend(const Raster& picture, const ColourScale& scale);

}  // namespace report
