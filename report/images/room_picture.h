#pragma once
// False colours of a rasterised room, and the frame around pictures.

#include "report/images/heatmap.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace report {

// Rows from the top, kOversampling times as wide and high as the final picture.
struct DrawnRoom {
  int width = 0, height = 0;        // multiples of kOversampling
  std::vector<float> lx;            // of the surface seen, < 0 = none
  std::vector<std::uint8_t> cover;  // RGBA over it, premultiplied
};
inline constexpr int kOversampling = 2;

// Colours of equal steps of a value from 0; larger values have the last colour.
struct Palette {
  std::vector<Rgb> colour;  // at least one
  float step = 1.0F;
};
Palette band_palette(const ColourScale& scale);  // low = 0

// Paints values and puts the cover over them; transparent if there is neither.
Raster paint_room(const DrawnRoom& drawn, const Palette& palette);

// Returns the mean of the visible values in each pixel, < 0 if there are none.
std::vector<float> mean_values(const DrawnRoom& drawn);

// Returns a scale from 0 to the value that only a few brightest pixels exceed: a place close to a
// luminaire must not compress the colours of the room.
ColourScale room_scale(std::span<const DrawnRoom> rooms);

// Words around a picture and on it. Words that do not fit are cut.
struct PictureFrame {
  std::string title = {};                              // above; "" = none
  std::string note = {};                               // below; "" = none
  std::string unit = "lx";                             // of the colour bar
  std::vector<std::vector<glm::dvec2>> outlines = {};  // closed lines, in the picture's pixels
};

// Returns the picture on white, with a colour bar below.
Raster with_legend(const Raster& picture, const ColourScale& scale, const PictureFrame& frame = {});
// Returns the picture without a colour bar.
Raster with_frame(const Raster& picture, const PictureFrame& frame);

}  // namespace report
