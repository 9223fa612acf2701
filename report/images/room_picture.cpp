#include "report/images/room_picture.h"

#include "calc/base/elementary.h"
#include "report/images/canvas.h"
#include "report/images/stroke_font.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <utility>

namespace report {
namespace {

constexpr double kSeenShare = 0.97;
constexpr int kMargin = 24, kBarHeight = 18, kLeastWidth = 480;  // of a narrow picture
constexpr double kTitle_px = 22.0, kNumber_px = 18.0, kNote_px = 16.0;
constexpr double kCapital = 0.7;  // of the size of letters
constexpr Rgb kInk{27, 31, 36}, kQuiet{89, 97, 107}, kHalo{255, 255, 255};

std::size_t at(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x);
}

// Calls tell(index) for the drawn pixels of a picture's pixel.
template <class Tell>
void for_each_sample(const DrawnRoom& drawn, int x, int y, const Tell& tell) {
  for (int dy = 0; dy < kOversampling; ++dy) {
    for (int dx = 0; dx < kOversampling; ++dx) {
      tell(at(kOversampling * x + dx, kOversampling * y + dy, drawn.width));
    }
  }
}

// The value that this share of all is at most; 0 of none.
double at_share(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

constexpr std::uint32_t kSamples = kOversampling * kOversampling;  // of a pixel

class BandFinder {
 public:
  explicit BandFinder(const Palette& palette)
      : per_step_(1.0F / palette.step), last_(static_cast<float>(palette.colour.size() - 1)) {}
  // -1: nothing is there, or what is no number.
  std::int32_t operator()(float lx) const {
    return lx >= 0.0F ? static_cast<std::int32_t>(std::min(lx * per_step_, last_)) : -1;
  }

 private:
  float per_step_, last_;
};

// As one word, because compilers call memcmp() for each sample.
bool is_clear(const std::uint8_t* cover) {
  std::uint32_t word = 0;
  std::memcpy(&word, cover, sizeof word);
  return word == 0;
}

// A pixel of several colours. band: of its samples.
void paint_mixed(const DrawnRoom& drawn, const Palette& palette, int x, int y,
                 const std::array<std::int32_t, kSamples>& band, std::uint8_t* to) {
  std::array<std::uint32_t, 4> sum{};  // premultiplied, 255 times
  std::size_t sample = 0;
  for_each_sample(drawn, x, y, [&](std::size_t i) {
    const std::uint8_t* cover = &drawn.cover[4 * i];
    const std::int32_t at = band[sample++];
    const std::uint32_t through = 255U - cover[3];
    for (std::size_t k = 0; k < 4; ++k) sum[k] += 255U * cover[k];
    if (at < 0 || through == 0) return;
    const Rgb below = palette.colour[static_cast<std::size_t>(at)];
    sum[0] += through * below.r;
    sum[1] += through * below.g;
    sum[2] += through * below.b;
    sum[3] += through * 255U;
  });
  if (sum[3] == 0) return;
  for (std::size_t k = 0; k < 3; ++k) {
    to[k] = static_cast<std::uint8_t>(
        std::min<std::uint32_t>(255U, (255U * sum[k] + sum[3] / 2) / sum[3]));
  }
  to[3] = static_cast<std::uint8_t>((sum[3] + 255U * kSamples / 2) / (255U * kSamples));
}

// Below the picture, from there on: the bar, its numbers where they have room, and the unit.
void draw_colour_bar(const ColourScale& scale, const std::string& unit, int top, Canvas& canvas) {
  const int width = std::min(canvas.raster().width - 2 * kMargin - 60, 900), left = kMargin + 10;
  const auto x_of = [&](int band) { return left + band * width / scale.bands; };
  canvas.fill(left - 1, top - 1, width + 2, kBarHeight + 2, kInk);
  for (int band = 0; band < scale.bands; ++band) {
    canvas.fill(x_of(band), top, x_of(band + 1) - x_of(band), kBarHeight, band_colour(scale, band));
  }
  constexpr double kLeastGap = 10.0;
  double free = 0.0;  // where the next number may begin
  for (int band = 0; band <= scale.bands; ++band) {
    // Six digits: of 3 x 1.5e-5 a binary number is a little less.
    const std::string number = fmt::format("{:.6g}", scale.border(band));
    const double half = 0.5 * text_strokes(number, kNumber_px).width_px;
    if (x_of(band) - half < free) continue;
    canvas.write(number, {x_of(band), top + kBarHeight + 8 + kCapital * kNumber_px}, kNumber_px,
                 TextAnchor::middle, kInk);
    free = x_of(band) + half + kLeastGap;
  }
  canvas.write(unit, {left + width + 10, top + 0.5 * (kBarHeight + kCapital * kNumber_px)},
               kNumber_px, TextAnchor::start, kInk);
}

void draw_outlines(const PictureFrame& frame, const glm::dvec2& from, Canvas& canvas) {
  for (const auto& [width, colour] : {std::pair{4.5, kHalo}, std::pair{2.0, kInk}}) {
    for (const std::vector<glm::dvec2>& outline : frame.outlines) {
      if (outline.empty()) continue;
      std::vector<glm::dvec2> corners;
      for (const glm::dvec2& corner : outline) corners.push_back(from + corner);
      corners.push_back(corners.front());
      canvas.line(corners, width, colour);
    }
  }
}

// scale: null = no colour bar.
Raster framed(const Raster& picture, const ColourScale* scale, const PictureFrame& frame) {
  constexpr int kTitleHeight = 36, kBarSpace = kBarHeight + 32 + kMargin / 2, kNoteHeight = 26;
  const int above = frame.title.empty() ? 0 : kTitleHeight;
  const int bar_top = kMargin + above + picture.height + (scale == nullptr ? 8 : kMargin);
  const int note_top = bar_top + (scale == nullptr ? 0 : kBarSpace);
  const int width = std::max(picture.width, kLeastWidth);
  Canvas canvas(width + 2 * kMargin, note_top + (frame.note.empty() ? 0 : kNoteHeight) +
                                         (scale == nullptr ? kMargin - 8 : 0));
  canvas.put(picture, kMargin, kMargin + above);
  draw_outlines(frame, {kMargin, kMargin + above}, canvas);
  const auto write = [&](const std::string& words, double y, double size_px, Rgb colour) {
    canvas.write(fitting_text(words, size_px, width), {kMargin, y}, size_px, TextAnchor::start,
                 colour);
  };
  write(frame.title, kMargin + kCapital * kTitle_px, kTitle_px, kInk);
  if (scale != nullptr) draw_colour_bar(*scale, frame.unit, bar_top, canvas);
  write(frame.note, note_top + kCapital * kNote_px, kNote_px, kQuiet);
  return canvas.raster();
}

}  // namespace

Palette band_palette(const ColourScale& scale) {
  Palette palette{{}, static_cast<float>(scale.step)};
  for (int band = 0; band < scale.bands; ++band) palette.colour.push_back(band_colour(scale, band));
  return palette;
}

Raster paint_room(const DrawnRoom& drawn, const Palette& palette) {
  Raster raster;
  raster.width = drawn.width / kOversampling;
  raster.height = drawn.height / kOversampling;
  raster.rgba.resize(4 * static_cast<std::size_t>(raster.width) *
                     static_cast<std::size_t>(raster.height));
  const BandFinder band_of(palette);
  std::uint8_t* to = raster.rgba.data();
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x, to += 4) {
      std::array<std::int32_t, kSamples> band{};
      bool is_one_band = true;
      std::size_t k = 0;
      for_each_sample(drawn, x, y, [&](std::size_t i) {
        band[k] = band_of(drawn.lx[i]);
        is_one_band = is_one_band && band[k] == band[0] && is_clear(&drawn.cover[4 * i]);
        ++k;
      });
      if (!is_one_band) {
        paint_mixed(drawn, palette, x, y, band, to);
      } else if (band[0] >= 0) {
        const Rgb colour = palette.colour[static_cast<std::size_t>(band[0])];
        to[0] = colour.r, to[1] = colour.g, to[2] = colour.b, to[3] = 255;
      }
    }
  }
  return raster;
}

std::vector<float> mean_values(const DrawnRoom& drawn) {
  std::vector<float> result;
  for (int y = 0; y < drawn.height / kOversampling; ++y) {
    for (int x = 0; x < drawn.width / kOversampling; ++x) {
      float sum = 0.0F;
      int seen = 0;
      for_each_sample(drawn, x, y, [&](std::size_t i) {
        if (!(drawn.lx[i] >= 0.0F)) return;
        sum += drawn.lx[i];
        ++seen;
      });
      result.push_back(seen > 0 ? sum / static_cast<float>(seen) : -1.0F);
    }
  }
  return result;
}

ColourScale room_scale(std::span<const DrawnRoom> rooms) {
  std::vector<double> seen;
  for (const DrawnRoom& room : rooms) {
    std::copy_if(room.lx.begin(), room.lx.end(), std::back_inserter(seen),
                 [](float lx) { return lx >= 0.0F && !std::isinf(lx); });
  }
  ColourScale scale = make_colour_scale(0.0, at_share(std::move(seen), kSeenShare));
  // Rooms have more to tell than a plane: steps half as wide, where those are round as well.
  const double power = calc::pow(10.0, std::floor(calc::log10(scale.step) + 1e-9));
  if (scale.bands <= 6 && scale.step < 2.5 * power) {
    scale.step /= 2.0;
    scale.bands *= 2;
  }
  return scale;
}

Raster with_legend(const Raster& picture, const ColourScale& scale, const PictureFrame& frame) {
  return framed(picture, &scale, frame);
}

Raster with_frame(const Raster& picture, const PictureFrame& frame) {
  return framed(picture, nullptr, frame);
}

}  // namespace report
