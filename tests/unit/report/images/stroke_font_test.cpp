#include "report/images/stroke_font.h"

#include "calc/base/utf8.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace report::stroke_font_test {
namespace {

// Whether both have the same drawing.
bool looks_like(const std::string& a, const std::string& b) {
  const TextStrokes one = text_strokes(a, 40), other = text_strokes(b, 40);
  return one.lines == other.lines;
}
constexpr const char* kUnknown = "漢";

TEST(StrokeFont, HasTheLettersOfOurLanguages) {
  for (char32_t code = 0x21; code < 0x7F; ++code) {
    EXPECT_FALSE(looks_like(calc::utf8_from_code_point(code), kUnknown))
        << std::hex << static_cast<std::uint32_t>(code);
  }
  for (char32_t code = 0xC0; code <= 0xFF; ++code) {
    EXPECT_FALSE(looks_like(calc::utf8_from_code_point(code), kUnknown))
        << std::hex << static_cast<std::uint32_t>(code);
  }
  for (const char* sign : {"–", "—", "−", "„", "“", "”", "’", "«", "»", "…", "·",
                           "×", "²", "³", "°", "§", "µ", "œ", "Œ", "≥", "≤", "Ω"}) {
    EXPECT_FALSE(looks_like(sign, kUnknown)) << sign;
  }
}

TEST(StrokeFont, DrawsABoxForOthers) {
  EXPECT_TRUE(looks_like("字", kUnknown));
  EXPECT_TRUE(looks_like("\xff", kUnknown));
  EXPECT_EQ(text_strokes("\xff\xff", 40).lines.size(), 2u);
  EXPECT_TRUE(text_strokes("", 40).lines.empty());
  EXPECT_TRUE(text_strokes("  ", 40).lines.empty());
}

// Signs are above letters, and higher above capitals; a cedilla is below.
TEST(StrokeFont, PutsMarksWhereTheyBelong) {
  const auto top = [](const char* text) {
    double y = 0.0;
    for (const auto& line : text_strokes(text, 40).lines)
      for (const glm::dvec2& place : line) y = std::min(y, place.y);
    return -y;
  };
  const auto bottom = [](const char* text) {
    double y = 0.0;
    for (const auto& line : text_strokes(text, 40).lines)
      for (const glm::dvec2& place : line) y = std::max(y, place.y);
    return y;
  };
  EXPECT_NEAR(top("o"), 20.0, 1e-9);
  EXPECT_GT(top("ö"), 25.0);
  EXPECT_NEAR(top("O"), 28.0, 1e-9);
  EXPECT_GT(top("Ö"), 33.0);
  EXPECT_NEAR(top("ı"), 20.0, 1e-9);
  EXPECT_NEAR(bottom("c"), 0.0, 1e-9);
  EXPECT_GT(bottom("ç"), 5.0);
  EXPECT_EQ(text_strokes("ö", 40).lines.size(), 3u);
}

TEST(StrokeFont, GrowsWithItsSizeAndItsText) {
  const TextStrokes small = text_strokes("12", 10), large = text_strokes("12", 20);
  EXPECT_NEAR(2.0 * small.width_px, large.width_px, 1e-9);
  EXPECT_NEAR(2.0 * small.pen_px, large.pen_px, 1e-9);
  // Figures are alike wide.
  EXPECT_EQ(text_strokes("111", 20).width_px, text_strokes("888", 20).width_px);
  for (const auto& line : large.lines) {
    EXPECT_GE(line.size(), 2u);
    for (const glm::dvec2& place : line) {
      EXPECT_GE(place.x, 0.0);
      EXPECT_LE(place.x, large.width_px);
    }
  }
}

TEST(StrokeFont, CutsWholeCharacters) {
  const std::string name = "Büroäöü";
  EXPECT_EQ(fitting_text(name, 20, 1000), name);
  EXPECT_EQ(fitting_text(std::string(1'000'000, 'i'), 20, 30),
            fitting_text(std::string(100, 'i'), 20, 30));
  for (double width_px = 0; width_px < 100; width_px += 3) {
    const std::string text = fitting_text(name, 20, width_px);
    EXPECT_FALSE(calc::first_invalid_utf8(text)) << text;
    if (text != "…") {
      EXPECT_LE(text_strokes(text, 20).width_px, width_px) << text;
    }
  }
}

}  // namespace
}  // namespace report::stroke_font_test
