#include "calc/photometry/read/eulumdat.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/photometry/read/eulumdat_lines.h"
#include "calc/photometry/read/ies_opening.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/web_assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr double kRatioTolerance = 0.05;  // relative, light output ratio
constexpr double kShareTolerance = 5.0;   // points, downward flux fraction

class EulumdatReader {
 public:
  EulumdatReader(std::string_view text, const std::string& name, const PhotometryOptions& options,
                 Diagnostics& diagnostics)
      : name_(name),
        options_(options),
        diagnostics_(diagnostics),
        lines_(text, name, diagnostics) {}

  std::optional<PhotometricWeb> read() {
    if (!read_head() || !read_opening() || !read_ratios() || !read_lamps() || !read_angles() ||
        !select_stored_planes() || !read_table()) {
      return std::nullopt;
    }
    std::optional<PhotometricWeb> web =
        make_checked_web(std::move(table_), opening_, std::move(source_), diagnostics_);
    if (web) warn_of_ratios(*web);
    return web;
  }

 private:
  bool check_line_count(std::size_t needed) {
    const std::size_t present = lines_.count_remaining();
    if (needed == present) return true;
    diagnostics_.report(DiagnosticId::photometry_lines, lines_.here(), needed, present);
    return false;
  }

  bool read_head() {
    source_.format = "EULUMDAT";
    source_.axis_rule = "C as written; length along C 90, width along C 0";
    const std::optional<std::string_view> company = lines_.text_line("the company");
    if (!company) return false;
    source_.manufacturer = utf8_from_file_text(trim(*company));
    int type = 0;
    double step = 0.0;  // both steps follow from the angles
    if (!lines_.read_whole("the luminaire type (Ityp)", 0, 3, type) ||
        !lines_.read_whole("the symmetry (Isym)", 0, 4, isym_) ||
        !lines_.read_whole("the number of C-planes (Mc)", 1, 1'000'000'000, plane_count_) ||
        !lines_.read_number_or_blank("the step of the C-planes (Dc)", step) ||
        !lines_.read_whole("the number of gamma angles (Ng)", 2, 1'000'000'000, gamma_count_) ||
        !lines_.read_number_or_blank("the step of the gamma angles (Dg)", step) ||
        !lines_.skip(1, "the report number")) {
      return false;
    }
    const std::optional<std::string_view> luminaire = lines_.text_line("the luminaire's name");
    if (!luminaire) return false;
    source_.luminaire_name = utf8_from_file_text(trim(*luminaire));
    return read_words("the luminaire number", source_.article_number) &&
           lines_.skip(2, "file name, date");
  }

  bool read_words(std::string_view what, std::string& words) {
    const std::optional<std::string_view> line = lines_.text_line(what);
    if (line) words = utf8_from_file_text(trim(*line));
    return line.has_value();
  }

  bool read_opening() {
    std::array<double, 9> mm{};
    constexpr std::array<std::string_view, 9> kNames{
        "the luminaire's length (mm)",     "the luminaire's width (mm)",
        "the luminaire's height (mm)",     "the luminous length (mm)",
        "the luminous width (mm)",         "the luminous height at C0 (mm)",
        "the luminous height at C90 (mm)", "the luminous height at C180 (mm)",
        "the luminous height at C270 (mm)"};
    for (std::size_t i = 0; i < mm.size(); ++i) {
      if (!lines_.read_number_or_blank(kNames[i], mm[i])) return false;
      // Heights are signed in practice; the opening's plane keeps no position along the axis.
      if (i < 5 && !(mm[i] >= 0.0 && mm[i] <= 1.0e7))
        return lines_.refuse(kNames[i], mm[i], "0 to 1e7");
    }
    if (mm[0] > 0.0 && mm[2] > 0.0) {
      source_.body_is_round = mm[1] == 0.0;
      source_.body_m =
          glm::dvec3(source_.body_is_round ? mm[0] : mm[1], mm[0], mm[2]) * kMetresPerMillimetre;
    }
    const double length = mm[3] * kMetresPerMillimetre;
    const double width = mm[4] * kMetresPerMillimetre;
    opening_.height_m =
        std::max(0.0, *std::max_element(mm.begin() + 5, mm.end())) * kMetresPerMillimetre;
    opening_.along_c0_m = width == 0.0 ? length : width;
    opening_.along_c90_m = length;
    if (length == 0.0 && width == 0.0) {
      diagnostics_.report(DiagnosticId::photometry_no_area, lines_.here());
    } else {
      opening_.shape = width == 0.0 ? OpeningShape::disk : OpeningShape::rectangle;
      // Sides that shine all round alike; with some only, the flat opening is the lesser mistake.
      const bool is_even =
          std::all_of(mm.begin() + 5, mm.end(), [&](double side_mm) { return side_mm == mm[5]; });
      if (is_even &&
          !is_flat_enough(opening_.along_c0_m, opening_.along_c90_m, opening_.height_m)) {
        opening_.shape = width == 0.0 ? OpeningShape::cylinder : OpeningShape::box;
      }
    }
    return true;
  }

  bool read_ratios() {
    double tilt = 0.0;
    if (!lines_.read_number_or_blank("the downward flux fraction (DFF)", downward_percent_) ||
        !lines_.read_number_or_blank("the light output ratio (LORL)", output_ratio_percent_) ||
        !lines_.read_number("the conversion factor for intensities", conversion_)) {
      return false;
    }
    if (!(conversion_ > 0.0))
      return lines_.refuse("the conversion factor for intensities", conversion_, "> 0");
    if (!lines_.read_number_or_blank("the tilt during measurement", tilt)) return false;
    if (tilt != 0.0)
      diagnostics_.report(DiagnosticId::photometry_measured_tilt, lines_.here(), tilt);
    return true;
  }

  // What the sets are called, without moving on: "1 (LED110, 1000 lm)".
  std::vector<PhotometryChoice> lamp_set_choices(int sets) const {
    std::vector<PhotometryChoice> choices;
    LineCursor ahead = lines_.cursor();
    for (int set = 1; set <= sets; ++set) {
      std::array<std::string, 6> line;
      for (std::string& text : line) {
        const std::optional<std::string_view> next = ahead.next();
        if (!next) return choices;
        text = trim(*next);
      }
      choices.push_back({fmt::format("{}", set), fmt::format("{}, {} lm", line[1], line[2])});
    }
    return choices;
  }

  // Sets are alternatives. The number, from 1, of the one to use; empty if there is no such set.
  std::optional<int> choose_lamp_set(int sets) {
    const int chosen = options_.lamp_set == 0 ? 1 : options_.lamp_set;
    if (chosen < 1 || chosen > sets) {
      diagnostics_.report(DiagnosticId::photometry_choice, place_of_choice(options_, name_), name_,
                          "lamp set", chosen, list_choices(lamp_set_choices(sets)));
      return std::nullopt;
    }
    if (sets > 1 && options_.lamp_set == 0) {
      diagnostics_.report(DiagnosticId::photometry_lamp_sets, lines_.here(), sets,
                          list_choices(lamp_set_choices(sets)));
    }
    return chosen;
  }

  bool read_lamp_set() {
    double lamps = 0.0;  // only its sign matters
    double flux_lm = 0.0;
    if (!lines_.read_number_or_blank("the number of lamps", lamps) ||
        !read_words("the lamp type", source_.lamp) ||
        !lines_.read_number("the flux of the lamp set (lm)", flux_lm)) {
      return false;
    }
    if (!(flux_lm > 0.0)) {
      return lines_.refuse("the flux of the lamp set (lm)", flux_lm,
                           "> 0 (intensities are per 1000 lm)");
    }
    if (!read_words("the lamp's colour temperature", source_.colour_temperature) ||
        !read_words("the lamp's colour rendering", source_.colour_rendering) ||
        !lines_.read_number_or_blank("the watts of the lamp set", source_.input_power_w)) {
      return false;
    }
    // A number for a field that its writer did not know.
    for (std::string* words : {&source_.colour_temperature, &source_.colour_rendering})
      if (*words == "0") words->clear();
    if (source_.input_power_w < 0.0)
      return lines_.refuse("the watts of the lamp set", source_.input_power_w, ">= 0");
    if (source_.input_power_w == 0.0)
      diagnostics_.report(DiagnosticId::photometry_no_power, lines_.here());
    set_flux_lm_ = flux_lm;
    source_.rated_lamp_flux_lm = lamps < 0.0 ? 0.0 : flux_lm;
    source_.stated_flux_lm =
        lamps < 0.0 ? flux_lm : std::max(0.0, 0.01 * output_ratio_percent_ * flux_lm);
    source_.applied_factors = fmt::format("LDT conversion {} x {} lm / 1000", conversion_, flux_lm);
    return true;
  }

  // A set before the chosen one: where it is none, the lines are in another order, and the chosen
  // one would be read wrong, without a word.
  bool pass_lamp_set() {
    double number = 0.0;
    std::string words;
    return lines_.read_number_or_blank("the number of lamps", number) &&
           read_words("the lamp type", words) &&
           lines_.read_number("the flux of the lamp set (lm)", number) &&
           read_words("the lamp's colour temperature", words) &&
           read_words("the lamp's colour rendering", words) &&
           lines_.read_number_or_blank("the watts of the lamp set", number);
  }

  bool read_lamps() {
    int sets = 0;
    if (!lines_.read_whole("the number of lamp sets", 1, 1'000'000, sets)) return false;
    const std::optional<int> chosen = choose_lamp_set(sets);
    if (!chosen) return false;
    for (int set = 1; set < *chosen; ++set) {
      if (!pass_lamp_set()) return false;
    }
    if (!read_lamp_set()) return false;
    if (sets > 1) source_.applied_factors += fmt::format(" (lamp set {} of {})", *chosen, sets);
    return lines_.skip(6 * (sets - *chosen), "the other lamp sets") &&
           lines_.skip(10, "the direct ratios");
  }

  bool read_angle_list(int count, double highest_deg, const char* what,
                       std::vector<double>& angles) {
    for (int i = 0; i < count; ++i) {
      double deg = 0.0;
      if (!lines_.read_number(fmt::format("{} angle {} of {}", what, i + 1, count), deg))
        return false;
      if (!check_angle(deg, i > 0 ? &angles.back() : nullptr, 0.0, highest_deg, what, lines_.here(),
                       diagnostics_)) {
        return false;
      }
      angles.push_back(deg);
    }
    return true;
  }

  bool read_angles() {
    const auto angles =
        static_cast<std::size_t>(plane_count_) + static_cast<std::size_t>(gamma_count_);
    if (const std::size_t present = lines_.count_remaining(); angles > present) {
      diagnostics_.report(DiagnosticId::photometry_count, lines_.here(), "the C and gamma angles",
                          angles, present);
      return false;
    }
    return read_angle_list(plane_count_, 360.0, "C", all_c_deg_) &&
           read_angle_list(gamma_count_, 180.0, "gamma", table_.gamma_deg);
  }

  // Index of a C-plane that the symmetry needs; reports when the file has none.
  std::optional<std::size_t> plane_at(double c_deg) {
    for (std::size_t i = 0; i < all_c_deg_.size(); ++i) {
      if (std::abs(all_c_deg_[i] - c_deg) < 1.0e-6) return i;
    }
    diagnostics_.report(DiagnosticId::photometry_symmetry_plane, lines_.here(), isym_, c_deg);
    return std::nullopt;
  }

  // Which planes the file stores, in their order: for Isym 3 from C270 over C0 to C90.
  bool select_stored_planes() {
    const std::vector<double>& c = all_c_deg_;
    if (isym_ == 0) {
      table_.symmetry = plane_count_ == 1 ? PlaneSymmetry::axial : PlaneSymmetry::none;
      table_.c_deg = c;
    } else if (isym_ == 1) {
      table_.symmetry = PlaneSymmetry::axial;
      table_.c_deg = {0.0};
    } else if (isym_ == 2 || isym_ == 4) {
      const std::optional<std::size_t> last = plane_at(isym_ == 2 ? 180.0 : 90.0);
      if (!last || !plane_at(0.0)) return false;
      table_.symmetry = isym_ == 2 ? PlaneSymmetry::c0_c180 : PlaneSymmetry::quadrant;
      table_.c_deg.assign(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(*last) + 1);
    } else {
      const std::optional<std::size_t> first = plane_at(270.0);
      const std::optional<std::size_t> last = plane_at(90.0);
      if (!first || !last) return false;
      table_.symmetry = PlaneSymmetry::c90_c270;
      for (std::size_t i = *first; i < c.size() && c[i] < 359.999999; ++i)
        table_.c_deg.push_back(c[i] - 360.0);
      table_.c_deg.insert(table_.c_deg.end(), c.begin(),
                          c.begin() + static_cast<std::ptrdiff_t>(*last) + 1);
    }
    return true;
  }

  bool read_table() {
    const std::size_t count = table_.c_deg.size() * table_.gamma_deg.size();
    if (!check_line_count(count)) return false;
    table_.where = lines_.here();
    ++table_.where.line;
    table_.intensity_cd.reserve(count);
    double lowest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      double cd_per_klm = 0.0;
      if (!lines_.read_number("intensity (cd/klm)", cd_per_klm)) return false;
      table_.intensity_cd.push_back(cd_per_klm * conversion_ * set_flux_lm_ / 1000.0);
      if (!std::isfinite(table_.intensity_cd.back())) {
        return lines_.refuse("intensity (cd/klm)", cd_per_klm, "up to 1e12 cd in all");
      }
      if (cd_per_klm < lowest || i == 0) table_.most_negative_where = lines_.here();
      lowest = std::min(lowest, cd_per_klm);
    }
    return true;
  }

  void warn_of_ratios(const PhotometricWeb& web) {
    const SourceLocation file{name_, 0, 0};
    const double ratio = 100.0 * web.flux_lm() / set_flux_lm_;
    if (std::abs(ratio - output_ratio_percent_) >
        kRatioTolerance * std::max(ratio, output_ratio_percent_)) {
      diagnostics_.report(DiagnosticId::photometry_output_ratio, file, output_ratio_percent_,
                          ratio);
    }
    const double downward = 100.0 * web.zonal_flux_lm(0.0, 0.5 * kPi) / web.flux_lm();
    if (std::abs(downward - downward_percent_) > kShareTolerance) {
      diagnostics_.report(DiagnosticId::photometry_downward_share, file, downward_percent_,
                          downward);
    }
    const double rated = web.source().rated_lamp_flux_lm;
    if (rated > 0.0 && web.flux_lm() > kEfficiencyLimit * rated) {
      diagnostics_.report(DiagnosticId::photometry_flux_over_lamps, file, web.flux_lm(), rated);
    }
  }

  const std::string& name_;
  const PhotometryOptions& options_;
  Diagnostics& diagnostics_;
  EulumdatLines lines_;
  int isym_ = 0, plane_count_ = 0, gamma_count_ = 0;
  double conversion_ = 1.0, set_flux_lm_ = 0.0;
  double downward_percent_ = 0.0, output_ratio_percent_ = 0.0;
  std::vector<double> all_c_deg_;
  FileTable table_;
  LuminousOpening opening_;
  PhotometrySource source_;
};

}  // namespace

std::optional<PhotometricWeb> parse_eulumdat(std::string_view text, const std::string& name,
                                             const PhotometryOptions& options,
                                             Diagnostics& diagnostics) {
  return EulumdatReader(text, name, options, diagnostics).read();
}

}  // namespace calc
