#include "report/images/stroke_font.h"

#include "calc/base/utf8.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace report {
namespace {

// Units of the font's drawings: the size is 40, capitals are 28 high, small letters 20, y upwards
// from the base line.
constexpr double kUnits = 40.0, kPen = 3.3, kBetween = 7.5, kCapitalRise = 8.5, kMarkAside = 2.0;

// Of a letter: how wide its drawing is, and its path. "M x y" begins a line, "L" goes on straight,
// "h" and "v" by a quarter of an ellipse that starts horizontally or vertically, "c" by a cubic
// Bézier curve with two control points.
struct Letter {
  char32_t code;
  double width;
  const char* path;
};

constexpr Letter kLetters[] = {
    {U' ', 4, ""},
    {U'!', 1, "M.5 28 L.5 9 M.5 0 L.5 .6"},
    {U'"', 7, "M0 28 L0 20 M7 28 L7 20"},
    {U'#', 18, "M6 28 L3 0 M15 28 L12 0 M1 19 L18 19 M0 9 L17 9"},
    {U'$', 17, "M16.5 22 v9 27 h.5 20.8 v8.5 14.5 h17 7.5 v8.5 1 h0 6 M8.5 31 L8.5 -3"},
    {U'%', 26,
     "M6 28 h12 21.5 v6 15 h0 21.5 v6 28 M21 28 L5 0 M20 13 h26 6.5 v20 0 h14 6.5 v20 13"},
    {U'&', 22,
     "M22 0 L6 17.5 c3.5 20.5 3 28 9.5 28 c16 28 15.5 20 11 17.5 L5.5 14.5 c1.5 12.5 0 10 0 7 "
     "v8.5 0 c15 0 20.5 6 20.5 13"},
    {U'\'', 1, "M.5 28 L.5 20"},
    {U'(', 6, "M6 31 c-2 22 -2 4 6 -5"},
    {U')', 6, "M0 31 c8 22 8 4 0 -5"},
    {U'*', 12, "M6 28 L6 15 M.5 25 L11.5 18 M11.5 25 L.5 18"},
    {U'+', 16, "M0 12 L16 12 M8 4 L8 20"},
    {U',', 2, "M1.5 1 L0 -5"},
    {U'-', 9, "M0 10.5 L9 10.5"},
    {U'.', 1, "M.5 0 L.5 .6"},
    {U'/', 11, "M0 -3 L11 30"},
    {U'0', 17, "M8.5 28 h17 14 v8.5 0 h0 14 v8.5 28"},
    {U'1', 17, "M2.5 22 L10 28 L10 0"},
    {U'2', 17, "M.5 20.5 v8.5 28 h16.5 20.5 c16.5 15 11 11 .3 0 L17 0"},
    {U'3', 17, "M1 23 v8.5 28 h16 21.5 v8.5 15 L5.5 15 M8.5 15 h17 7.5 v8.5 0 h0 5.5"},
    {U'4', 17, "M13 0 L13 28 L0 8 L17.5 8"},
    {U'5', 17, "M15.5 28 L2.5 28 L1.3 14.5 c3 17 5.5 18 8.3 18 h17 9 v8.5 0 h0 5"},
    {U'6', 17, "M13.5 28 c5 22.5 0 16.5 0 9 v8.5 0 h17 9 v8.5 18 h0 9"},
    {U'7', 17, "M.5 28 L17 28 L6 0"},
    {U'8', 17, "M8.5 15 h1 21.5 v8.5 28 h16 21.5 v8.5 15 h17 7.5 v8.5 0 h0 7.5 v8.5 15"},
    {U'9', 17, "M3.5 0 c12 5.5 17 11.5 17 19 v8.5 28 h0 19 v8.5 10 h17 19"},
    {U':', 1, "M.5 0 L.5 .6 M.5 17 L.5 17.6"},
    {U';', 2, "M1.5 1 L0 -5 M1.3 17 L1.3 17.6"},
    {U'<', 15, "M15 20 L0 12 L15 4"},
    {U'=', 16, "M0 16.5 L16 16.5 M0 8 L16 8"},
    {U'>', 15, "M0 20 L15 12 L0 4"},
    {U'?', 15, "M0 21.5 v7.5 28 h15 21.5 c15 15 7.3 15.5 7.3 8.5 M7.3 0 L7.3 .6"},
    {U'@', 30,
     "M22 8.5 L22 19 M22 13.5 v15.5 19 h8.5 13.3 v15 7.5 h22 13 M22 10 v25.5 7.5 c29 7.5 30 11 30 "
     "14 v15.5 28 h0 11.5 v15 -6 c19 -6 22 -5 24 -3.5"},
    {U'A', 22, "M0 0 L11 28 L22 0 M3.7 9.5 L18.3 9.5"},
    {U'B', 18, "M0 15 L9.5 15 h18 7.5 v10 0 L0 0 L0 28 L9 28 h16 21.5 v9 15"},
    {U'C', 21, "M21 21.5 v12 28 h0 14 v12 0 h21 6.5"},
    {U'D', 21, "M0 0 L0 28 L8 28 h21 14 v8 0 L0 0"},
    {U'E', 16, "M16 28 L0 28 L0 0 L16 0 M0 15 L14 15"},
    {U'F', 16, "M16 28 L0 28 L0 0 M0 14.5 L14 14.5"},
    {U'G', 22, "M21 21.5 v12 28 h0 14 v12 0 h22 9.5 L22 13.5 L13.5 13.5"},
    {U'H', 20, "M0 0 L0 28 M20 0 L20 28 M0 15 L20 15"},
    {U'I', 0, "M0 0 L0 28"},
    {U'J', 12, "M12 28 L12 8 v6 0 h0 5"},
    {U'K', 19, "M0 0 L0 28 M18 28 L0 11 M6.5 17 L19 0"},
    {U'L', 15, "M0 28 L0 0 L15 0"},
    {U'M', 24, "M0 0 L0 28 L12 8 L24 28 L24 0"},
    {U'N', 20, "M0 0 L0 28 L20 0 L20 28"},
    {U'O', 24, "M12 28 h24 14 v12 0 h0 14 v12 28"},
    {U'P', 18, "M0 0 L0 28 L10 28 h18 20.5 v10 13 L0 13"},
    {U'Q', 24, "M12 28 h24 14 v12 0 h0 14 v12 28 M15 7 L24 -2"},
    {U'R', 19, "M0 0 L0 28 L10 28 h18 20.5 v10 13 L0 13 M10 13 L19 0"},
    {U'S', 17, "M16.5 22 v9 28 h.5 21.3 v8.5 14.5 h17 7.5 v8.5 0 h0 6"},
    {U'T', 20, "M0 28 L20 28 M10 28 L10 0"},
    {U'U', 20, "M0 28 L0 10 v10 0 h20 10 L20 28"},
    {U'V', 21, "M0 28 L10.5 0 L21 28"},
    {U'W', 30, "M0 28 L7.5 0 L15 27 L22.5 0 L30 28"},
    {U'X', 19, "M0 0 L19 28 M0 28 L19 0"},
    {U'Y', 20, "M0 28 L10 13 L20 28 M10 13 L10 0"},
    {U'Z', 18, "M0 28 L18 28 L0 0 L18 0"},
    {U'[', 6, "M6 31 L0 31 L0 -5 L6 -5"},
    {U'\\', 11, "M0 30 L11 -3"},
    {U']', 6, "M0 31 L6 31 L6 -5 L0 -5"},
    {U'^', 12, "M0 20 L6 28 L12 20"},
    {U'_', 18, "M0 -4 L18 -4"},
    {U'`', 6, "M0 28 L6 23"},
    {U'a', 15, "M1.5 16 v8 20 h15 13 L15 0 M15 11.5 L7 11.5 h0 5.7 v6.5 0 h15 6.5"},
    {U'b', 17, "M0 28 L0 0 M0 10 v8.5 20 h17 10 v8.5 0 h0 10"},
    {U'c', 15, "M15 15.5 v8.5 20 h0 10 v8.5 0 h15 4.5"},
    {U'd', 17, "M17 28 L17 0 M17 10 v8.5 20 h0 10 v8.5 0 h17 10"},
    {U'e', 17, "M0 10.5 L17 10.5 v8.5 20 h0 10 v8.5 0 h16 4.5"},
    {U'f', 11, "M11 28 L10 28 h4 22 L4 0 M0 19.5 L10 19.5"},
    {U'g', 17, "M17 20 L17 -1 v8.5 -8 h1 -4.5 M17 10 v8.5 20 h0 10 v8.5 0 h17 10"},
    {U'h', 15, "M0 28 L0 0 M0 11.5 v8 20 h15 12.5 L15 0"},
    {U'i', 1, "M.5 20 L.5 0 M.5 27 L.5 27.6"},
    {U'j', 5, "M5 20 L5 -3 v0 -8 M5 27 L5 27.6"},
    {U'k', 15, "M0 28 L0 0 M14 20 L0 7.5 M5.3 12.2 L15 0"},
    {U'l', 5, "M0 28 L0 4.5 v5 0"},
    {U'm', 25, "M0 20 L0 0 M0 12 v6.5 20 h12.5 13 L12.5 0 M12.5 12 v19 20 h25 13 L25 0"},
    {U'n', 15, "M0 20 L0 0 M0 11.5 v8 20 h15 12.5 L15 0"},
    {U'o', 17, "M8.5 20 h17 10 v8.5 0 h0 10 v8.5 20"},
    {U'p', 17, "M0 20 L0 -8 M0 10 v8.5 20 h17 10 v8.5 0 h0 10"},
    {U'q', 17, "M17 20 L17 -8 M17 10 v8.5 20 h0 10 v8.5 0 h17 10"},
    {U'r', 9, "M0 20 L0 0 M0 11.5 v7.5 20 L9 20"},
    {U's', 13.5, "M13 16 v7 20 h.5 15.3 v6.8 10.4 h13.5 5.2 v6.8 0 h0 4"},
    {U't', 10, "M4 26 L4 5 v9 0 L10 0 M0 20 L10 20"},
    {U'u', 15, "M0 20 L0 7.5 v7 0 h15 8.5 M15 20 L15 0"},
    {U'v', 16, "M0 20 L8 0 L16 20"},
    {U'w', 24, "M0 20 L6 0 L12 19 L18 0 L24 20"},
    {U'x', 15, "M0 0 L15 20 M0 20 L15 0"},
    {U'y', 16, "M0 20 L8 0 M16 20 L4.8 -8"},
    {U'z', 14, "M0 20 L14 20 L0 0 L14.5 0"},
    {U'{', 7, "M7 31 L6 31 h3 27 L3 16 v0 13 h3 10 L3 -1 v6 -5 L7 -5"},
    {U'|', 0, "M0 31 L0 -5"},
    {U'}', 7, "M0 31 L1 31 h4 27 L4 16 v7 13 h4 10 L4 -1 v1 -5 L0 -5"},
    {U'~', 16, "M0 10 c3 16 6.5 14.5 8 12 c9.5 9.5 13 8 16 14"},
    {U'¡', 1, "M.5 0 L.5 19 M.5 28 L.5 27.4"},
    {U'£', 17, "M16 23 v10.5 28 h4.5 21 L4.5 5 v0 0 L16 0 M0 13.5 L13 13.5"},
    {U'§', 15,
     "M14 24 v7.5 28 h1.5 23 c1.5 18 15 17 15 11.5 v10 7.5 M5 18.5 h0 14.5 c0 9 13.5 8.5 "
     "13.5 3 v7.5 -2 h1 2"},
    {U'«', 16, "M7 17 L0 10 L7 3 M16 17 L9 10 L16 3"},
    {U'»', 16, "M0 17 L7 10 L0 3 M9 17 L16 10 L9 3"},
    {U'°', 9, "M4.5 28 h9 23.5 v4.5 19 h0 23.5 v4.5 28"},
    {U'±', 16, "M0 14 L16 14 M8 6 L8 22 M0 0 L16 0"},
    {U'²', 9, "M.3 25 v4.5 28 h8.5 24.3 c8.5 21.5 5 19.5 0 15 L9 15"},
    {U'³', 9, "M.5 26 v4.3 28 h8.3 24.9 v4.5 21.8 h8.8 18.3 v4.3 15 h0 17.3"},
    {U'¹', 6, "M0 25 L5 28 L5 15"},
    {U'µ', 15, "M0 20 L0 -8 M0 7.5 v7 0 h15 8.5 M15 20 L15 0"},
    {U'·', 1, "M.5 11 L.5 11.6"},
    {U'ª', 9, "M.5 25.5 v4.5 28 h9 24 L9 16 M9 22.5 L4 22.5 h0 19 v4 16 h9 19.5"},
    {U'º', 9, "M4.5 28 h9 22 v4.5 16 h0 22 v4.5 28"},
    {U'¿', 15, "M15 6.5 v7.5 0 h0 6.5 c0 13 7.7 12.5 7.7 19.5 M7.7 28 L7.7 27.4"},
    {U'Æ', 31, "M0 0 L14 28 L31 28 M31 0 L16 0 L16 28 M4.8 9.5 L16 9.5 M16 15 L29 15"},
    {U'Ð', 24, "M3 0 L3 28 L11 28 h24 14 v11 0 L3 0 M-2 15 L11 15"},
    {U'×', 13, "M0 5.5 L13 18.5 M0 18.5 L13 5.5"},
    {U'Ø', 24, "M12 28 h24 14 v12 0 h0 14 v12 28 M1 -2 L23 30"},
    {U'Þ', 18, "M0 0 L0 28 M0 22.5 L10 22.5 h18 14.5 v10 6.5 L0 6.5"},
    {U'ß', 17, "M0 0 L0 20.5 v7.5 28 h15 22 v8.5 15.5 L7.5 15.5 M8.5 15.5 h17 7.7 v9 0 L6 0"},
    {U'æ', 29,
     "M1.5 16 v8 20 h14 13 L14 10.5 L29 10.5 v21.5 20 h14 10.5 v21.5 0 h28.5 4.5 M14 11.5 L7 11.5 "
     "h0 5.7 v6.5 0 h14 6.5"},
    {U'ð', 17, "M8.5 18 h17 9 v8.5 0 h0 9 v8.5 18 h17 9 c17 19 12 25 5 29 M4 22.5 L14 28"},
    {U'÷', 16, "M0 12 L16 12 M8 19.5 L8 20.1 M8 4 L8 4.6"},
    {U'ø', 17, "M8.5 20 h17 10 v8.5 0 h0 10 v8.5 20 M1 -2 L16 22"},
    {U'þ', 17, "M0 28 L0 -8 M0 10 v8.5 20 h17 10 v8.5 0 h0 10"},
    {U'ı', 1, "M.5 20 L.5 0"},
    {U'Œ', 35, "M35 28 L12 28 h0 14 v12 0 L35 0 M20 28 L20 0 M20 15 L33 15"},
    {U'œ', 31,
     "M15.5 10 v7.7 20 h0 10 v7.7 0 h15.5 10 M15.5 10.5 L31 10.5 v23.3 20 h15.5 10 v23.3 0 h30.5 "
     "4.5"},
    {U'–', 16, "M0 10.5 L16 10.5"},
    {U'—', 26, "M0 10.5 L26 10.5"},
    {U'−', 16, "M0 12 L16 12"},
    {U'‘', 3, "M0 20 L2 27.5"},
    {U'’', 3, "M2.5 28 L.5 20.5"},
    {U'‚', 3, "M2 1 L0 -5"},
    {U'“', 9, "M0 20 L2 27.5 M6.5 20 L8.5 27.5"},
    {U'”', 9, "M2.5 28 L.5 20.5 M9 28 L7 20.5"},
    {U'„', 8, "M2 1 L0 -5 M8 1 L6 -5"},
    {U'•', 5, "M1.5 11 L3.5 11 L3.5 13 L1.5 13 L1.5 11"},
    {U'…', 19, "M.5 0 L.5 .6 M9.5 0 L9.5 .6 M18.5 0 L18.5 .6"},
    {U'€', 20, "M20 22.5 v12.5 28 h4 14 v12.5 0 h20 5.5 M0 17 L14 17 M0 11 L14 11"},
    {U'≈', 16,
     "M0 14 c3 20 6.5 18.5 8 16 c9.5 13.5 13 12 16 18 M0 5 c3 11 6.5 9.5 8 7 c9.5 4.5 13 "
     "3 16 9"},
    {U'≤', 15, "M15 22 L0 15 L15 8 M0 1 L15 1"},
    {U'≥', 15, "M0 22 L15 15 L0 8 M0 1 L15 1"},
    {U'Ω', 22, "M0 0 L7 0 c1 6 0 11 0 15 v11 28 h22 15 c22 11 21 6 15 0 L22 0"},
    {U'Φ', 22, "M11 24 h22 14 v11 4 h0 14 v11 24 M11 28 L11 0"},
};

// Around x = 0, above small letters.
constexpr Letter kMarks[] = {
    {U'`', 0, "M-4 28.5 L2 23.5"},
    {U'´', 0, "M-2 23.5 L4 28.5"},
    {U'^', 0, "M-5.5 23.5 L0 28.5 L5.5 23.5"},
    {U'~', 0, "M-6.5 24.5 c-4 29.5 -1.5 27.5 0 26 c1.5 24.5 4 22.5 6.5 27.5"},
    {U'¨', 0, "M-4.5 26 L-4.5 26.6 M4.5 26 L4.5 26.6"},
    {U'°', 0, "M0 31 h3.7 27.3 v0 23.6 h-3.7 27.3 v0 31"},
    {U'¸', 0, "M.5 0 L-.5 -3 c3.5 -2.5 4.5 -8 -3.5 -7.5"},
    {U'ˇ', 0, "M-5.5 28.5 L0 23.5 L5.5 28.5"},
};

// From U+00C0 and U+00E0 on: a letter and its mark; "  " = it has a drawing of its own.
constexpr std::u32string_view
    kCapitals = U"A`A´A^A~A¨A°  C¸E`E´E^E¨I`I´I^I¨  N~O`O´O^O~O¨    U`U´U^U¨Y´",
    kSmall = U"a`a´a^a~a¨a°  c¸e`e´e^e¨ı`ı´ı^ı¨  n~o`o´o^o~o¨    u`u´u^u¨y´  y¨";

struct Marked {
  char32_t letter, mark;
  bool is_capital;
};
std::optional<Marked> marked(char32_t code) {
  switch (code) {
    case U'Š':
      return Marked{U'S', U'ˇ', true};
    case U'š':
      return Marked{U's', U'ˇ', false};
    case U'Ž':
      return Marked{U'Z', U'ˇ', true};
    case U'ž':
      return Marked{U'z', U'ˇ', false};
    default:
      break;
  }
  if (code < 0xC0 || code > 0xFF) return std::nullopt;
  const bool is_capital = code < 0xE0;
  const std::u32string_view table = is_capital ? kCapitals : kSmall;
  const std::size_t at = 2 * (code - (is_capital ? 0xC0 : 0xE0));
  if (at >= table.size() || table[at] == U' ') return std::nullopt;
  return Marked{table[at], table[at + 1], is_capital};
}

const Letter* find_letter(std::span<const Letter> letters, char32_t code) {
  const auto found = std::find_if(letters.begin(), letters.end(),
                                  [&](const Letter& one) { return one.code == code; });
  return found == letters.end() ? nullptr : &*found;
}

// Draws letters beside each other.
class Pen {
 public:
  explicit Pen(double size_px) : scale_(size_px / kUnits) { strokes_.pen_px = kPen * scale_; }

  void letter(char32_t code) {
    constexpr Letter kBox{U'\0', 15, "M0 0 L0 28 L15 28 L15 0 L0 0"};
    const bool is_narrow = code == 0x2009 || code == 0x202F;
    if (code == 0xA0 || is_narrow) code = U' ';
    const std::optional<Marked> parts = marked(code);
    const Letter* letter = find_letter(kLetters, parts ? parts->letter : code);
    if (letter == nullptr) letter = &kBox;
    if (has_letters_) from_ += kBetween;
    // Marks are wider than an i.
    const double aside = parts && letter->width < kBetween ? kMarkAside : 0.0;
    from_ += aside;
    path(letter->path, {from_, 0.0});
    if (parts) {
      const double rise = parts->is_capital && parts->mark != U'¸' ? kCapitalRise : 0.0;
      path(find_letter(kMarks, parts->mark)->path, {from_ + 0.5 * letter->width, rise});
    }
    from_ += is_narrow ? 0.0 : letter->width + aside;
    has_letters_ = true;
  }

  TextStrokes done() {
    strokes_.width_px = scale_ * from_;
    return std::move(strokes_);
  }

 private:
  static double number(std::string_view& path) {
    path.remove_prefix(std::min(path.find_first_not_of(' '), path.size()));
    double value = 0.0;
    const auto end = std::from_chars(path.data(), path.data() + path.size(), value).ptr;
    path.remove_prefix(static_cast<std::size_t>(end - path.data()));
    return value;
  }
  static glm::dvec2 place(std::string_view& path) {
    const double x = number(path);
    return {x, number(path)};
  }

  void path(std::string_view path, const glm::dvec2& from) {
    constexpr double kRound = 0.5523;  // of a quarter of a circle by a cubic curve
    glm::dvec2 at(0.0);
    while (!path.empty()) {
      const char order = path.front();
      path.remove_prefix(1);
      if (order == ' ') continue;
      const glm::dvec2 first = place(path);
      glm::dvec2 to = first;
      if (order == 'M') {
        strokes_.lines.emplace_back();
        add(from + to);
      } else if (order == 'L') {
        add(from + to);
      } else if (order == 'h') {
        curve(from, at, {at.x + kRound * (to.x - at.x), at.y},
              {to.x, to.y + kRound * (at.y - to.y)}, to);
      } else if (order == 'v') {
        curve(from, at, {at.x, at.y + kRound * (to.y - at.y)},
              {to.x + kRound * (at.x - to.x), to.y}, to);
      } else {
        const glm::dvec2 second = place(path);
        to = place(path);
        curve(from, at, first, second, to);
      }
      at = to;
    }
  }

  void curve(const glm::dvec2& from, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
             const glm::dvec2& d) {
    constexpr int kPieces = 8;
    for (int k = 1; k <= kPieces; ++k) {
      const double t = static_cast<double>(k) / kPieces, s = 1.0 - t;
      add(from + s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
    }
  }
  void add(const glm::dvec2& place) {
    strokes_.lines.back().emplace_back(scale_ * place.x, -scale_ * place.y);
  }

  double scale_;
  double from_ = 0.0;
  bool has_letters_ = false;
  TextStrokes strokes_;
};

}  // namespace

TextStrokes text_strokes(std::string_view utf8, double size_px) {
  Pen pen(size_px);
  while (!utf8.empty()) {
    const calc::Utf8Character character = calc::first_character(utf8);
    pen.letter(character.length > 0 ? character.code : U'\0');
    utf8.remove_prefix(std::max<std::size_t>(character.length, 1));
  }
  return pen.done();
}

std::string fitting_text(std::string_view utf8, double size_px, double width_px) {
  // Of any length, and each of the tries below draws all of it.
  const double most = std::max(width_px, 0.0) * kUnits / (kBetween * size_px) + 2.0;
  std::size_t bytes = 0;
  for (double seen = 0.0; seen < most && bytes < utf8.size(); seen += 1.0)
    bytes += std::max<std::size_t>(calc::first_character(utf8.substr(bytes)).length, 1);
  utf8 = utf8.substr(0, bytes);
  std::string text(utf8);
  while (!utf8.empty() && text_strokes(text, size_px).width_px > width_px) {
    while (!utf8.empty() && calc::is_utf8_continuation(utf8.back())) utf8.remove_suffix(1);
    if (!utf8.empty()) utf8.remove_suffix(1);
    text = std::string(utf8) + "…";
  }
  return text;
}

}  // namespace report
