#pragma once
// False colours of a plane: colour map, a scale with round steps, and the picture itself.

#include "calc/base/names.h"
#include "report/document/document.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace report {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};

// Returns the colour of the map cividis at t, limited to [0, 1]: dark blue to yellow, lightness
// rises evenly, made for all common forms of colour-vision deficiency and for grey print. [Nunez18;
// ten anchors, linear between them]
Rgb cividis(double t);
// Returns blue, cyan, green, yellow, red, magenta, evenly spaced and linear between them, t as
// above. Its lightness rises and falls: in grey print, and for some readers, colours cannot be told
// apart.
Rgb false_colour(double t);
std::string hex_colour(Rgb colour);  // "#00204d"
// Returns whether black text reads better than white on this colour (relative luminance, WCAG 2.2).
// The better of the two has a contrast of at least 4.58 on any colour.
bool needs_dark_text(Rgb colour);

// Bands of colours: band i covers [border(i), border(i + 1)), in the unit of the values. They are
// of equal width with round limits, or classes, which get wider upwards.
struct ColourScale {
  double low = 0.0;
  double step = 1.0;                 // 1, 2 or 5 times a power of ten; not of classes
  int bands = 1;                     // 1 to 12
  std::vector<double> classes = {};  // their bands + 1 borders; empty: bands of equal width
  ColourMap map = ColourMap::cividis;

  bool has_classes() const { return !classes.empty(); }
  // i: 0 to bands.
  double border(int i) const {
    return has_classes() ? classes[static_cast<std::size_t>(i)] : low + step * i;
  }
  double high() const { return border(bands); }
};

// Returns a scale over [lowest, highest], both finite; a nearly even field still gets steps of at
// least 1 % of its value, so that noise does not look like structure.
ColourScale make_colour_scale(double lowest, double highest);
// Classes by the series 1, 1.5, 2, 3, 5, 7.5, 10, in which standards step illuminances, so that a
// corridor and a task area both show how their light decreases (scale of illuminance in EN
// 12464-1). They cover [lowest, highest], 0 <= lowest <= highest > 0, both finite; the first begins
// at 0 if lowest is below 0.01, or more than 12 would be needed. fine: with 1.2, 2.5, 4 and 6 as
// well.
enum class ClassSeries { of_standards, fine };
ColourScale make_class_scale(double lowest, double highest,
                             ClassSeries series = ClassSeries::of_standards);
// Returns the index of the band of a value; values outside go to the first or last band.
int band_of(const ColourScale& scale, double value);
Rgb band_colour(const ColourScale& scale, int band);

// Returns the scale of a computed plane: its points, without limits of requirements.
ColourScale scale_of(const PlanePart& plane, ColourMap map = ColourMap::cividis);

// 8-bit RGBA, top row first. Row order: the top row is the one with the largest v, as in a plan.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

// Returns false for point lists and for planes without points: they have no cells and so no heat
// map.
bool has_cells(const PlanePart& plane);

// Returns false if an observer has no glare source: there is then no rating, and no colour for it.
bool has_all_values(const PlanePart& plane);

// Returns one square of pixels_per_cell >= 1 per cell; cells without a point are transparent. Needs
// has_cells().
Raster plane_raster(const PlanePart& plane, const ColourScale& scale, int pixels_per_cell);

// Returns the pixels per cell for a picture of about `wanted` pixels on its longer side, at least
// 1.
int pixels_per_cell(const PlanePart& plane, int wanted);

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::ColourMap> {
  static constexpr EnumName<report::ColourMap> list[] = {
      {report::ColourMap::cividis, "cividis"}, {report::ColourMap::false_colour, "false-colour"}};
};

}  // namespace calc
