#include "calc/photometry/read/ies_lm63.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/photometry/read/ies_header.h"
#include "calc/photometry/read/ies_opening.h"
#include "calc/photometry/read/ies_types_ab.h"
#include "calc/photometry/read/lm63_numbers.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/web_assembly.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr double kMostLikelyLargest_m = 6.0;  // openings beyond these are probably in another unit
constexpr double kMostLikelySmallest_m = 0.003;

class Lm63Reader {
 public:
  Lm63Reader(const Lm63Header& header, const std::string& name,
             const CompanionReader& read_companion, Diagnostics& diagnostics)
      : header_(header),
        name_(name),
        read_companion_(read_companion),
        diagnostics_(diagnostics),
        numbers_(header.numbers, header.tilt_line, name, diagnostics) {}

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
  void warn_of_header() {
    source_.format = header_.tag;
    source_.axis_rule = "H 0 is C 0; length along C 0, width along C 90";
    if (!header_.version_known) {
      diagnostics_.report(DiagnosticId::photometry_version, numbers_.at(1), quotable(header_.tag));
    }
    const std::vector<std::string_view> missing = missing_keywords(header_);
    if (!missing.empty()) {
      diagnostics_.report(DiagnosticId::photometry_keywords, numbers_.at(1),
                          fmt::format("{}", fmt::join(missing, ", ")));
    }
    source_.luminaire_name = header_.keyword("LUMINAIRE");
    if (source_.luminaire_name.empty()) source_.luminaire_name = header_.keyword("LUMCAT");
    source_.manufacturer = header_.keyword("MANUFAC");
    source_.article_number = header_.keyword("LUMCAT");
    source_.lamp = header_.keyword("LAMP");
    source_.colour_temperature = header_.keyword("CCT");
    source_.colour_rendering = header_.keyword("CRI");
  }

  bool read_tilt() {
    std::string word = header_.tilt;
    std::transform(word.begin(), word.end(), word.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    if (word == "NONE") return true;
    source_.lamp_tilt = word == "INCLUDE"
                            ? read_tilt_data(numbers_)
                            : read_tilt_file(header_.tilt, name_, numbers_.at(header_.tilt_line),
                                             read_companion_, diagnostics_);
    if (!source_.lamp_tilt) return false;
    tilt_factor_ = tilt_factor(*source_.lamp_tilt, 0.0);
    return true;
  }

  bool read_lamps() {
    double lamps = 0.0;
    double lumens = 0.0;
    if (!numbers_.read("the number of lamps", lamps) ||
        !numbers_.read("the lumens per lamp", lumens))
      return false;
    if (lumens < 0.0 && lumens != -1.0) {
      return numbers_.refuse("the lumens per lamp", lumens, "> 0, or -1 for absolute photometry");
    }
    if (lumens == -1.0) return true;
    if (!(lamps > 0.0)) return numbers_.refuse("the number of lamps", lamps, "> 0");
    source_.rated_lamp_flux_lm = lamps * lumens;
    if (lumens == 0.0) diagnostics_.report(DiagnosticId::photometry_no_lumens, numbers_.here());
    return true;
  }

  bool read_counts_and_type() {
    int type = 0;
    if (!numbers_.read("the candela multiplier", multiplier_)) return false;
    if (!(multiplier_ > 0.0)) return numbers_.refuse("the candela multiplier", multiplier_, "> 0");
    if (!numbers_.read_whole("the number of vertical angles", 2, 1'000'000'000, vertical_count_) ||
        !numbers_.read_whole("the number of horizontal angles", 1, 1'000'000'000,
                             horizontal_count_) ||
        !numbers_.read_whole("the photometric type", 1, 3, type)) {
      return false;
    }
    type_ = static_cast<Lm63Type>(type);
    return true;
  }

  bool read_opening() {
    int units = 0;
    double width = 0.0;
    double length = 0.0;
    double height = 0.0;
    if (!numbers_.read_whole("the units type (1 feet, 2 metres)", 1, 2, units) ||
        !numbers_.read("the width of the opening", width) ||
        !numbers_.read("the length of the opening", length) ||
        !numbers_.read("the height of the opening", height)) {
      return false;
    }
    const double metres = units == 1 ? kMetresPerFoot : 1.0;
    const Lm63Opening decoded =
        decode_opening(width * metres, length * metres, height * metres, header_.version);
    opening_ = decoded.opening;
    const double largest = std::max({opening_.along_c0_m, opening_.along_c90_m, opening_.height_m});
    if (!(largest <= 1.0e4))
      return numbers_.refuse("the opening's size in metres", largest, "up to 10000");
    if (!decoded.simplified_from.empty()) {
      diagnostics_.report(DiagnosticId::photometry_opening_shape, numbers_.here(),
                          fmt::format("{} {} {}", width, length, height), decoded.simplified_from);
    }
    if (largest > kMostLikelyLargest_m || (largest > 0.0 && largest < kMostLikelySmallest_m)) {
      diagnostics_.report(DiagnosticId::photometry_opening_size, numbers_.here(), largest,
                          units == 1 ? "feet" : "metres");
    }
    return true;
  }

  bool read_factors() {
    double ballast = 0.0;
    double field12 = 0.0;
    if (!numbers_.read("the ballast factor", ballast)) return false;
    if (!(ballast > 0.0)) return numbers_.refuse("the ballast factor", ballast, "> 0");
    if (!numbers_.read("the ballast-lamp factor or its successor", field12)) return false;
    const bool field12_scales = header_.version <= Lm63Version::v1991;
    if (field12_scales && !(field12 > 0.0))
      return numbers_.refuse("the ballast-lamp photometric factor", field12, "> 0");
    // 2019: how the file was made, coded as 1.00001 to 1.1111.
    if (!field12_scales && field12 != 1.0 && header_.version != Lm63Version::v2019) {
      diagnostics_.report(DiagnosticId::photometry_field12, numbers_.here(), field12, header_.tag);
    }
    factor_ = multiplier_ * ballast * tilt_factor_ * (field12_scales ? field12 : 1.0);
    source_.applied_factors = fmt::format("multiplier {} x ballast {}", multiplier_, ballast);
    if (field12_scales) source_.applied_factors += fmt::format(" x ballast-lamp {}", field12);
    if (tilt_factor_ != 1.0) source_.applied_factors += fmt::format(" x tilt {}", tilt_factor_);

    if (!numbers_.read("the input watts", source_.input_power_w)) return false;
    if (source_.input_power_w < 0.0)
      return numbers_.refuse("the input watts", source_.input_power_w, ">= 0");
    if (source_.input_power_w == 0.0)
      diagnostics_.report(DiagnosticId::photometry_no_power, numbers_.here());
    return true;
  }

  bool read_angles(std::size_t count, double lowest_deg, double highest_deg, const char* what,
                   std::vector<double>& angles) {
    angles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      double deg = 0.0;
      if (!numbers_.read(fmt::format("{} angle {} of {}", what, i + 1, count), deg)) return false;
      // A single horizontal angle means "all around" whatever its value.
      const double limit = count == 1 ? 360.0 : highest_deg;
      if (!check_angle(deg, i > 0 ? &angles.back() : nullptr, lowest_deg, limit, what,
                       numbers_.here(), diagnostics_)) {
        return false;
      }
      angles.push_back(deg);
    }
    return true;
  }

  bool read_table() {
    const auto rows = static_cast<std::size_t>(vertical_count_);
    const auto planes = static_cast<std::size_t>(horizontal_count_);
    if (!numbers_.check_present("the angles and candela values", rows + planes + rows * planes))
      return false;
    const bool is_c = type_ == Lm63Type::c;
    if (!read_angles(rows, is_c ? 0.0 : -90.0, is_c ? 180.0 : 90.0, "vertical", table_.gamma_deg) ||
        !read_angles(planes, is_c ? 0.0 : -90.0, is_c ? 360.0 : 90.0, "horizontal", table_.c_deg)) {
      return false;
    }
    table_.symmetry = is_c ? symmetry_of_range(table_.c_deg) : PlaneSymmetry::none;
    table_.lists_c360 = true;
    if (table_.symmetry == PlaneSymmetry::c90_c270 && header_.version != Lm63Version::v1995) {
      diagnostics_.report(DiagnosticId::photometry_range_90_270, numbers_.here());
    }
    table_.where = numbers_.at(numbers_.line() + 1);
    table_.intensity_cd.reserve(rows * planes);
    double lowest = 0.0;
    for (std::size_t i = 0; i < rows * planes; ++i) {
      double value = 0.0;
      if (!numbers_.read("candela value", value)) return false;
      table_.intensity_cd.push_back(value * factor_);
      if (!std::isfinite(table_.intensity_cd.back()))
        return numbers_.refuse("candela value", value, "up to 1e12 cd in all");
      if (i == 0) table_.where = numbers_.here();
      if (value < lowest || i == 0) table_.most_negative_where = numbers_.here();
      lowest = std::min(lowest, value);
    }
    return is_c || turn_to_full_circle();
  }

  // Types A and B.
  bool turn_to_full_circle() {
    std::string problem;
    FileTable full = table_of_type_ab({type_, std::move(table_.gamma_deg), std::move(table_.c_deg),
                                       std::move(table_.intensity_cd)},
                                      problem);
    if (!problem.empty()) {
      diagnostics_.report(DiagnosticId::photometry_type_ab, table_.where,
                          type_ == Lm63Type::b ? "B" : "A", problem);
      return false;
    }
    if (horizontal_count_ == 1) {
      diagnostics_.report(DiagnosticId::photometry_assumed, table_.where,
                          "the light beside the single horizontal angle of photometric type B",
                          "the same light all round straight down");
    }
    source_.axis_rule = type_ == Lm63Type::b
                            ? "type B, planes about the C 90 line: nadir is H 0 V 0, C 270 is H 90"
                            : "type A: C 0 is H 0, C 270 is H 90, gamma is V + 90";
    full.where = table_.where;
    full.most_negative_where = table_.most_negative_where;
    table_ = std::move(full);
    return true;
  }

  // A comma between digits that splits numbers in two shows as numbers left over.
  bool check_rest() {
    const std::size_t left = numbers_.count_remaining();
    if (left == 0) return true;
    const NumberStream::Token first = *numbers_.next_token();
    const std::string_view text = header_.numbers;
    const auto digit = [&](std::size_t i) {
      return i < text.size() && text[i] >= '0' && text[i] <= '9';
    };
    bool comma_in_number = false;
    for (std::size_t i = text.find(','); i != std::string_view::npos; i = text.find(',', i + 1)) {
      comma_in_number = comma_in_number || (i > 0 && digit(i - 1) && digit(i + 1));
    }
    if (comma_in_number && parse_photometry_number(first.text)) {
      diagnostics_.report(DiagnosticId::photometry_decimal_comma, numbers_.at(first.line), left);
      return false;
    }
    diagnostics_.report(DiagnosticId::photometry_trailing, numbers_.at(first.line), left,
                        quotable(first.text));
    return true;
  }

  void warn_of_result(const PhotometricWeb& web) {
    const double rated = web.source().rated_lamp_flux_lm;
    if (rated > 0.0 && web.flux_lm() > kEfficiencyLimit * rated) {
      diagnostics_.report(DiagnosticId::photometry_flux_over_lamps, numbers_.at(header_.tilt_line),
                          web.flux_lm(), rated);
    }
    warn_of_low_flux(web.flux_lm(), rated, numbers_.at(header_.tilt_line), diagnostics_);
  }

  const Lm63Header& header_;
  const std::string& name_;
  const CompanionReader& read_companion_;
  Diagnostics& diagnostics_;
  Lm63Numbers numbers_;
  Lm63Type type_ = Lm63Type::c;
  double multiplier_ = 1.0, tilt_factor_ = 1.0, factor_ = 1.0;
  int vertical_count_ = 0, horizontal_count_ = 0;
  FileTable table_;
  LuminousOpening opening_;
  PhotometrySource source_;
};

}  // namespace

std::optional<PhotometricWeb> parse_lm63(std::string_view text, const std::string& name,
                                         Diagnostics& diagnostics,
                                         const CompanionReader& read_companion) {
  const std::optional<Lm63Header> header = read_lm63_header(text);
  if (!header) {
    diagnostics.report(DiagnosticId::photometry_no_tilt_line, SourceLocation{name, 0, 0});
    return std::nullopt;
  }
  return Lm63Reader(*header, name, read_companion, diagnostics).read();
}

}  // namespace calc
