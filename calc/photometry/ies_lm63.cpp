#include "calc/photometry/ies_lm63.h"

#include "calc/photometry/ies_header.h"
#include "calc/photometry/ies_opening.h"
#include "calc/photometry/number_stream.h"
#include "calc/photometry/text_encoding.h"
#include "calc/photometry/web_assembly.h"
#include "calc/text.h"
#include "calc/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr double kMostLikelyLargest_m = 6.0;  // openings beyond these are probably in another unit
constexpr double kMostLikelySmallest_m = 0.003;
constexpr double kEfficiencyLimit = 1.02;  // of the lamps' lumens

class Lm63Reader {
 public:
  Lm63Reader(const Lm63Header& header, const std::string& name, Diagnostics& diagnostics)
      : header_(header),
        name_(name),
        diagnostics_(diagnostics),
        numbers_(header.numbers, header.tilt_line) {}

  std::optional<PhotometricWeb> read() {
    warn_of_header();
    if (!read_tilt() || !read_lamps() || !read_counts_and_type() || !read_opening() ||
        !read_factors() || !read_table()) {
      return std::nullopt;
    }
    if (!check_rest()) return std::nullopt;
    std::optional<PhotometricWeb> web =
        make_checked_web(std::move(table_), opening_, std::move(source_), diagnostics_);
    if (web) warn_of_result(*web);
    return web;
  }

 private:
  SourceLocation at(int line) const { return {name_, line, 0}; }
  SourceLocation here() const { return at(line_); }

  // The next number; reports a missing or a malformed one.
  std::optional<double> number(std::string_view field) {
    const std::optional<NumberStream::Token> token = numbers_.next();
    if (!token) {
      diagnostics_.report(DiagnosticId::photometry_end, at(numbers_.line()), field);
      return std::nullopt;
    }
    line_ = token->line;
    const std::optional<double> value = parse_photometry_number(token->text);
    if (!value)
      diagnostics_.report(DiagnosticId::photometry_number, here(), field, quotable(token->text));
    return value;
  }

  bool refuse(std::string_view field, double value, std::string_view allowed) {
    diagnostics_.report(DiagnosticId::photometry_value, here(), field, fmt::format("{}", value),
                        allowed);
    return false;
  }

  bool read_number(std::string_view field, double& value) {
    const std::optional<double> found = number(field);
    if (found) value = *found;
    return found.has_value();
  }

  // A whole number ("1.0" is one), within [lowest, highest].
  bool read_whole(std::string_view field, int lowest, int highest, int& value) {
    double found = 0.0;
    if (!read_number(field, found)) return false;
    if (found != std::floor(found) || found < lowest || found > highest) {
      return refuse(field, found, fmt::format("a whole number from {} to {}", lowest, highest));
    }
    value = static_cast<int>(found);
    return true;
  }

  // Whether the file still has this many numbers: checked before anything of that size is made.
  bool check_present(std::string_view what, std::size_t count) {
    const std::size_t present = numbers_.count_remaining();
    if (count <= present) return true;
    diagnostics_.report(DiagnosticId::photometry_count, here(), what, count, present);
    return false;
  }

  void warn_of_header() {
    line_ = 1;
    source_.format = header_.tag;
    if (!header_.version_known) {
      diagnostics_.report(DiagnosticId::photometry_version, here(), quotable(header_.tag));
    }
    const std::vector<std::string_view> missing = missing_keywords(header_);
    if (!missing.empty()) {
      diagnostics_.report(DiagnosticId::photometry_keywords, here(),
                          fmt::format("{}", fmt::join(missing, ", ")));
    }
    source_.luminaire_name = header_.keyword("LUMINAIRE");
    if (source_.luminaire_name.empty()) source_.luminaire_name = header_.keyword("LUMCAT");
    source_.manufacturer = header_.keyword("MANUFAC");
  }

  bool read_tilt() {
    line_ = header_.tilt_line;
    std::string tilt = header_.tilt;
    std::transform(tilt.begin(), tilt.end(), tilt.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    if (tilt == "NONE") return true;
    if (tilt != "INCLUDE") {
      diagnostics_.report(DiagnosticId::photometry_unsupported, here(),
                          fmt::format("TILT={}", quotable(header_.tilt)),
                          "TILT=NONE and TILT=INCLUDE");
      return false;
    }
    int geometry = 0;
    int pairs = 0;
    if (!read_whole("the lamp-to-luminaire geometry of the tilt data", 1, 3, geometry) ||
        !read_whole("the number of tilt angles", 1, 1'000'000, pairs) ||
        !check_present("the tilt data", 2 * static_cast<std::size_t>(pairs))) {
      return false;
    }
    return read_tilt_table(static_cast<std::size_t>(pairs));
  }

  // Keeps the factor of tilt 0, linear between the angles: the luminaire is used as it was
  // measured.
  bool read_tilt_table(std::size_t pairs) {
    std::vector<double> angle(pairs);
    std::vector<double> factor(pairs);
    for (std::size_t i = 0; i < pairs; ++i) {
      if (!read_number("tilt angle", angle[i])) return false;
      if (!check_angle(angle[i], i > 0 ? &angle[i - 1] : nullptr, -180.0, 180.0, "tilt", here(),
                       diagnostics_)) {
        return false;
      }
    }
    for (double& value : factor) {
      if (!read_number("tilt factor", value)) return false;
      if (!(value > 0.0)) return refuse("tilt factor", value, "> 0");
    }
    if (angle.front() > 0.0 || angle.back() < 0.0) {
      return refuse("the first tilt angle", angle.front(), "angles on both sides of 0, or 0");
    }
    std::size_t i = 0;
    while (i + 1 < pairs && angle[i + 1] <= 0.0) ++i;
    tilt_factor_ = factor[i];
    if (angle[i] < 0.0) {
      tilt_factor_ = std::lerp(factor[i], factor[i + 1], -angle[i] / (angle[i + 1] - angle[i]));
    }
    diagnostics_.report(DiagnosticId::photometry_tilt_unused, at(header_.tilt_line), tilt_factor_);
    return true;
  }

  bool read_lamps() {
    double lamps = 0.0;
    double lumens = 0.0;
    if (!read_number("the number of lamps", lamps) || !read_number("the lumens per lamp", lumens))
      return false;
    if (lumens < 0.0 && lumens != -1.0) {
      return refuse("the lumens per lamp", lumens, "> 0, or -1 for absolute photometry");
    }
    if (lumens == -1.0) return true;
    if (!(lamps > 0.0)) return refuse("the number of lamps", lamps, "> 0");
    source_.rated_lamp_flux_lm = lamps * lumens;
    if (lumens == 0.0) diagnostics_.report(DiagnosticId::photometry_no_lumens, here());
    return true;
  }

  bool read_counts_and_type() {
    int type = 0;
    if (!read_number("the candela multiplier", multiplier_)) return false;
    if (!(multiplier_ > 0.0)) return refuse("the candela multiplier", multiplier_, "> 0");
    if (!read_whole("the number of vertical angles", 2, 1'000'000'000, vertical_count_) ||
        !read_whole("the number of horizontal angles", 1, 1'000'000'000, horizontal_count_) ||
        !read_whole("the photometric type", 1, 3, type)) {
      return false;
    }
    if (type == 1) return true;
    diagnostics_.report(DiagnosticId::photometry_unsupported, here(),
                        fmt::format("type {} (photometric type {})", type == 2 ? "B" : "A", type),
                        "type C (photometric type 1)");
    return false;
  }

  bool read_opening() {
    int units = 0;
    double width = 0.0;
    double length = 0.0;
    double height = 0.0;
    if (!read_whole("the units type (1 feet, 2 metres)", 1, 2, units) ||
        !read_number("the width of the opening", width) ||
        !read_number("the length of the opening", length) ||
        !read_number("the height of the opening", height)) {
      return false;
    }
    const double metres = units == 1 ? kMetresPerFoot : 1.0;
    const Lm63Opening decoded =
        decode_opening(width * metres, length * metres, height * metres, header_.version);
    opening_ = decoded.opening;
    const double largest = std::max({opening_.along_c0_m, opening_.along_c90_m, opening_.height_m});
    if (!(largest <= 1.0e4)) return refuse("the opening's size in metres", largest, "up to 10000");
    if (!decoded.simplified_from.empty()) {
      diagnostics_.report(DiagnosticId::photometry_opening_shape, here(),
                          fmt::format("{} {} {}", width, length, height), decoded.simplified_from);
    }
    if (largest > kMostLikelyLargest_m || (largest > 0.0 && largest < kMostLikelySmallest_m)) {
      diagnostics_.report(DiagnosticId::photometry_opening_size, here(), largest,
                          units == 1 ? "feet" : "metres");
    }
    return true;
  }

  bool read_factors() {
    double ballast = 0.0;
    double field12 = 0.0;
    if (!read_number("the ballast factor", ballast)) return false;
    if (!(ballast > 0.0)) return refuse("the ballast factor", ballast, "> 0");
    if (!read_number("the ballast-lamp factor or its successor", field12)) return false;
    const bool field12_scales = header_.version <= Lm63Version::v1991;
    if (field12_scales && !(field12 > 0.0))
      return refuse("the ballast-lamp photometric factor", field12, "> 0");
    // 2019: how the file was made, coded as 1.00001 to 1.1111.
    if (!field12_scales && field12 != 1.0 && header_.version != Lm63Version::v2019) {
      diagnostics_.report(DiagnosticId::photometry_field12, here(), field12, header_.tag);
    }
    factor_ = multiplier_ * ballast * tilt_factor_ * (field12_scales ? field12 : 1.0);
    source_.applied_factors = fmt::format("multiplier {} x ballast {}", multiplier_, ballast);
    if (field12_scales) source_.applied_factors += fmt::format(" x ballast-lamp {}", field12);
    if (tilt_factor_ != 1.0) source_.applied_factors += fmt::format(" x tilt {}", tilt_factor_);

    if (!read_number("the input watts", source_.input_power_w)) return false;
    if (source_.input_power_w < 0.0)
      return refuse("the input watts", source_.input_power_w, ">= 0");
    if (source_.input_power_w == 0.0)
      diagnostics_.report(DiagnosticId::photometry_no_power, here());
    return true;
  }

  bool read_angles(std::size_t count, double highest_deg, const char* what,
                   std::vector<double>& angles) {
    angles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      double deg = 0.0;
      if (!read_number(fmt::format("{} angle {} of {}", what, i + 1, count), deg)) return false;
      // A single horizontal angle means "all around" whatever its value.
      const double limit = count == 1 ? 360.0 : highest_deg;
      if (!check_angle(deg, i > 0 ? &angles.back() : nullptr, 0.0, limit, what, here(),
                       diagnostics_)) {
        return false;
      }
      angles.push_back(deg);
    }
    return true;
  }

  bool read_table() {
    const auto rows = static_cast<std::size_t>(vertical_count_);
    const auto planes = static_cast<std::size_t>(horizontal_count_);
    if (!check_present("the angles and candela values", rows + planes + rows * planes))
      return false;
    if (!read_angles(rows, 180.0, "vertical", table_.gamma_deg) ||
        !read_angles(planes, 360.0, "horizontal", table_.c_deg)) {
      return false;
    }
    table_.symmetry = symmetry_of_range(table_.c_deg);
    table_.lists_c360 = true;
    if (table_.symmetry == PlaneSymmetry::c90_c270 && header_.version != Lm63Version::v1995) {
      diagnostics_.report(DiagnosticId::photometry_range_90_270, here());
    }
    table_.where = at(line_ + 1);
    table_.intensity_cd.reserve(rows * planes);
    double lowest = 0.0;
    for (std::size_t i = 0; i < rows * planes; ++i) {
      double value = 0.0;
      if (!read_number("candela value", value)) return false;
      table_.intensity_cd.push_back(value * factor_);
      if (!std::isfinite(table_.intensity_cd.back()))
        return refuse("candela value", value, "up to 1e12 cd in all");
      if (i == 0) table_.where = here();
      if (value < lowest || i == 0) table_.most_negative_where = here();
      lowest = std::min(lowest, value);
    }
    return true;
  }

  // A comma between digits that splits numbers in two shows as numbers left over.
  bool check_rest() {
    const std::size_t left = numbers_.count_remaining();
    if (left == 0) return true;
    const NumberStream::Token first = *numbers_.next();
    const std::string_view text = header_.numbers;
    const auto digit = [&](std::size_t i) {
      return i < text.size() && text[i] >= '0' && text[i] <= '9';
    };
    bool comma_in_number = false;
    for (std::size_t i = text.find(','); i != std::string_view::npos; i = text.find(',', i + 1)) {
      comma_in_number = comma_in_number || (i > 0 && digit(i - 1) && digit(i + 1));
    }
    if (comma_in_number && parse_photometry_number(first.text)) {
      diagnostics_.report(DiagnosticId::photometry_decimal_comma, at(first.line), left);
      return false;
    }
    diagnostics_.report(DiagnosticId::photometry_trailing, at(first.line), left,
                        quotable(first.text));
    return true;
  }

  void warn_of_result(const PhotometricWeb& web) {
    const double rated = web.source().rated_lamp_flux_lm;
    if (rated > 0.0 && web.flux_lm() > kEfficiencyLimit * rated) {
      diagnostics_.report(DiagnosticId::photometry_flux_over_lamps, at(header_.tilt_line),
                          web.flux_lm(), rated);
    }
  }

  const Lm63Header& header_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  NumberStream numbers_;
  int line_ = 0;  // of the last number read
  double multiplier_ = 1.0, tilt_factor_ = 1.0, factor_ = 1.0;
  int vertical_count_ = 0, horizontal_count_ = 0;
  FileTable table_;
  LuminousOpening opening_;
  PhotometrySource source_;
};

}  // namespace

std::optional<PhotometricWeb> parse_lm63(std::string_view text, const std::string& name,
                                         Diagnostics& diagnostics) {
  const std::optional<Lm63Header> header = read_lm63_header(text);
  if (!header) {
    diagnostics.report(DiagnosticId::photometry_no_tilt_line, SourceLocation{name, 0, 0});
    return std::nullopt;
  }
  return Lm63Reader(*header, name, diagnostics).read();
}

}  // namespace calc
