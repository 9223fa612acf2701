#include "calc/photometry/read/tm33_table.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/xml_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr std::string_view kSupported = "luminous intensity (cd), photometry of type C";

struct TablePoint {
  double horizontal_deg, vertical_deg, cd;
  const XmlElement* element;
};

bool same(double a_deg, double b_deg) { return std::abs(a_deg - b_deg) < 1.0e-6; }

// One number from an attribute that goes by several names.
std::optional<double> angle_in(const XmlElement& element, std::array<std::string_view, 3> names,
                               Diagnostics& diagnostics) {
  for (const std::string_view name : names) {
    const std::string text = attribute_of(element, name);
    if (text.empty()) continue;
    const std::optional<double> angle = parse_number(text);
    if (!angle) {
      diagnostics.report(DiagnosticId::photometry_number, element.where, name, quotable(text));
    }
    return angle;
  }
  diagnostics.report(DiagnosticId::photometry_missing, element.where, local_name(element.name),
                     fmt::format("angle '{}'", names[0]));
  return std::nullopt;
}

class TableReader {
 public:
  TableReader(const XmlElement& root, const XmlElement& emitter, Diagnostics& diagnostics)
      : root_(root), emitter_(emitter), diagnostics_(diagnostics) {}

  std::optional<Tm33Table> read() {
    if (!find_distribution() || !check_metric() || !check_type() || !read_factors() ||
        !read_points() || !choose_symmetry() || !fill_grid()) {
      return std::nullopt;
    }
    compare_counts();
    return std::move(result_);
  }

 private:
  bool unsupported(const XmlElement& at, std::string_view what) {
    diagnostics_.report(DiagnosticId::photometry_unsupported, at.where, what, kSupported);
    return false;
  }

  bool find_distribution() {
    luminous_data_ = child_of(emitter_, "LuminousData");
    distribution_ = luminous_data_ != nullptr ? child_of(*luminous_data_, "LuminousIntensity")
                                              : child_of(emitter_, "IntensityDistribution");
    if (distribution_ == nullptr) distribution_ = luminous_data_;
    if (distribution_ != nullptr) {
      result_.where = distribution_->where;
      return true;
    }
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kOthers{
        {{"RadiantData", "radiant intensity"},
         {"PhotonData", "photon intensity"},
         {"SpectralData", "spectral intensity"},
         {"AngularSpectral", "spectral intensity"},
         {"IllumData", "illuminance instead of intensity"}}};
    for (const auto& [name, words] : kOthers) {
      const XmlElement* other = child_of(emitter_, name);
      if (other != nullptr) return unsupported(*other, fmt::format("{} (<{}>)", words, name));
    }
    diagnostics_.report(DiagnosticId::photometry_missing, emitter_.where, "Emitter",
                        "luminous intensities (<LuminousData>)");
    return false;
  }

  bool check_metric() {
    const XmlElement* units = child_of(*distribution_, "Units");
    const std::string unit = letters_of(text_of(units));
    if (!unit.empty() && unit != "cd" && unit != "candela")
      return unsupported(*units, fmt::format("the unit '{}'", quotable(text_of(units))));
    const XmlElement* metric = child_of(*distribution_, "Metric");
    const std::string word = letters_of(text_of(metric));
    if (word.empty() && luminous_data_ == nullptr && unit.empty()) {
      diagnostics_.report(DiagnosticId::photometry_assumed, distribution_->where, "the metric",
                          "luminous intensity (cd)");
    }
    if (word.empty() || word == "luminous") return true;
    return unsupported(*metric, fmt::format("the metric '{}'", quotable(text_of(metric))));
  }

  bool check_type() {
    const XmlElement* type = child_of(*distribution_, "PhotometryType");
    if (type == nullptr) type = descend(root_, {"Equipment", "Gonioradiometer", "Type"});
    if (type == nullptr) type = descend(root_, {"Equipment", "Goniometer", "Type"});
    if (type == nullptr) type = descend(root_, {"Equipment", "Goniometer", "GoniometerType"});
    const std::string word = letters_of(text_of(type));
    if (word == "c" || word == "ciec" || word == "iesc" || word == "typec") return true;
    if (word.empty()) {
      diagnostics_.report(DiagnosticId::photometry_assumed, distribution_->where,
                          "the photometry type", "type C");
      return true;
    }
    return unsupported(*type, fmt::format("photometry of type '{}'", quotable(text_of(type))));
  }

  bool read_factors() {
    const std::size_t errors = diagnostics_.error_count();
    const XmlElement* multiplier = child_of(*distribution_, "Multiplier");
    result_.multiplier = number_in(multiplier, diagnostics_).value_or(1.0);
    if (!(result_.multiplier > 0.0)) {
      diagnostics_.report(DiagnosticId::photometry_value, multiplier->where, "the multiplier",
                          fmt::format("{}", result_.multiplier), "> 0");
    }
    result_.is_absolute = flag_in(child_of(*distribution_, "AbsolutePhotometry"));
    if (luminous_data_ != nullptr) {
      result_.stated_flux_lm = number_in(child_of(*luminous_data_, "LuminousFlux"), diagnostics_);
    }
    return diagnostics_.error_count() == errors;
  }

  bool read_points() {
    for (const XmlElement& child : distribution_->children) {
      const std::string_view name = local_name(child.name);
      if (name != "IntensityData" && name != "IntData") continue;
      const auto horizontal = angle_in(child, {"horz", "h", "horizontal"}, diagnostics_);
      const auto vertical = angle_in(child, {"vert", "v", "vertical"}, diagnostics_);
      const auto value = number_in(&child, diagnostics_);
      if (!horizontal || !vertical || !value) return false;
      if (!check_angle(*horizontal, nullptr, 0.0, 360.0, "horizontal", child.where, diagnostics_) ||
          !check_angle(*vertical, nullptr, 0.0, 180.0, "vertical", child.where, diagnostics_)) {
        return false;
      }
      points_.push_back({*horizontal, *vertical, *value * result_.multiplier, &child});
    }
    if (!points_.empty()) return true;
    diagnostics_.report(DiagnosticId::photometry_missing, distribution_->where,
                        local_name(distribution_->name), "points (<IntensityData> or <IntData>)");
    return false;
  }

  // Turns horizontal angles of the form 0 to 90 with 270 to 360 to -90 to 90.
  void turn_around_zero() {
    bool has_left = false;
    for (const TablePoint& point : points_) {
      const double h = point.horizontal_deg;
      if (h > 90.0 && h < 270.0) return;
      has_left = has_left || h < 90.0;
    }
    if (!has_left) return;
    for (TablePoint& point : points_) {
      if (point.horizontal_deg >= 270.0) point.horizontal_deg -= 360.0;
    }
  }

  std::vector<double> horizontal_angles() const {
    std::vector<double> angles;
    for (const TablePoint& point : points_) angles.push_back(point.horizontal_deg);
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
  }

  // The symmetry as stated; a table that goes further around than it needs to is taken as it is.
  bool choose_symmetry() {
    const XmlElement* stated = child_of(*distribution_, {"SymmType", "Symm"});
    std::string word = letters_of(text_of(stated));
    if (word.starts_with("symm")) word.erase(0, 4);
    if (word == "bi90") turn_around_zero();
    std::vector<double>& c = result_.table.c_deg;
    c = horizontal_angles();
    const double first = c.front();
    const double last = c.back();
    PlaneSymmetry& symmetry = result_.table.symmetry;
    symmetry = symmetry_of_range(c);
    std::string_view needed;
    if (word == "none" || word == "arbitrary") {
      if (symmetry != PlaneSymmetry::axial) symmetry = PlaneSymmetry::none;
    } else if (word == "bi0") {
      if (!same(first, 0.0) || last < 180.0 - 1.0e-6) needed = "from 0 to 180";
    } else if (word == "bi90") {
      if (same(first, -90.0) && same(last, 90.0))
        symmetry = PlaneSymmetry::c90_c270;
      else if (symmetry != PlaneSymmetry::c90_c270 && (!same(first, 0.0) || last <= 270.0))
        needed = "from 90 to 270, or from 270 over 0 to 90";
    } else if (word == "quad") {
      if (!same(first, 0.0) || last < 90.0 - 1.0e-6) needed = "from 0 to 90";
    } else if (!word.empty() && word != "full") {
      return unsupported(*stated, fmt::format("the symmetry '{}'", quotable(text_of(stated))));
    }
    if (!needed.empty()) {
      diagnostics_.report(DiagnosticId::photometry_symmetry_range, stated->where,
                          quotable(text_of(stated)), needed, c.size(), first, last);
      return false;
    }
    return true;
  }

  // Sorts the points and checks that they are a full grid, before anything is allocated for it.
  bool fill_grid() {
    std::sort(points_.begin(), points_.end(), [](const TablePoint& a, const TablePoint& b) {
      return std::tie(a.horizontal_deg, a.vertical_deg, a.element->where.line) <
             std::tie(b.horizontal_deg, b.vertical_deg, b.element->where.line);
    });
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const TablePoint& before = points_[i - 1];
      const TablePoint& point = points_[i];
      if (before.horizontal_deg != point.horizontal_deg ||
          before.vertical_deg != point.vertical_deg)
        continue;
      diagnostics_.report(DiagnosticId::photometry_point_twice, point.element->where,
                          point.horizontal_deg, point.vertical_deg, before.element->where.line);
      return false;
    }
    std::vector<double>& gamma = result_.table.gamma_deg;
    for (const TablePoint& point : points_) gamma.push_back(point.vertical_deg);
    std::sort(gamma.begin(), gamma.end());
    gamma.erase(std::unique(gamma.begin(), gamma.end()), gamma.end());
    if (!check_grid() || !check_steps(result_.table.c_deg, "horizontal") ||
        !check_steps(gamma, "vertical")) {
      return false;
    }
    FileTable& table = result_.table;
    table.where = distribution_->where;
    const TablePoint* lowest = &points_.front();
    for (const TablePoint& point : points_) {
      table.intensity_cd.push_back(point.cd);
      if (point.cd < lowest->cd) lowest = &point;
    }
    table.most_negative_where = lowest->element->where;
    if (table.symmetry == PlaneSymmetry::axial) table.c_deg = {0.0};
    return true;
  }

  bool check_grid() {
    const std::vector<double>& c = result_.table.c_deg;
    const std::vector<double>& gamma = result_.table.gamma_deg;
    if (gamma.size() < 2) {
      diagnostics_.report(DiagnosticId::photometry_value, distribution_->where,
                          "the number of vertical angles", gamma.size(), "at least 2");
      return false;
    }
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (std::size_t k = 0; k < gamma.size(); ++k) {
        const std::size_t at = i * gamma.size() + k;
        if (at < points_.size() && points_[at].horizontal_deg == c[i] &&
            points_[at].vertical_deg == gamma[k]) {
          continue;
        }
        diagnostics_.report(DiagnosticId::photometry_point_missing, distribution_->where, c[i],
                            gamma[k], c.size(), gamma.size(), points_.size());
        return false;  // at the latest one past the last point
      }
    }
    return true;
  }

  bool check_steps(const std::vector<double>& angles, const char* what) {
    for (std::size_t i = 1; i < angles.size(); ++i) {
      if (!check_angle(angles[i], &angles[i - 1], -90.0, 360.0, what, distribution_->where,
                       diagnostics_)) {
        return false;
      }
    }
    return true;
  }

  // NumberHorz and so on: the points themselves count, but a difference may be a cut file.
  void compare_counts() {
    const std::array<std::pair<std::string_view, std::size_t>, 3> counts{
        {{"NumberHorz", points_.size() / result_.table.gamma_deg.size()},
         {"NumberVert", result_.table.gamma_deg.size()},
         {"NumberMeasured", points_.size()}}};
    for (const auto& [name, count] : counts) {
      const XmlElement* stated = child_of(*distribution_, name);
      if (stated == nullptr || parse_number(trim(stated->text)) == static_cast<double>(count))
        continue;
      diagnostics_.report(DiagnosticId::photometry_counts_differ, stated->where, name,
                          quotable(text_of(stated)), count);
    }
  }

  const XmlElement& root_;
  const XmlElement& emitter_;
  Diagnostics& diagnostics_;
  const XmlElement* luminous_data_ = nullptr;
  const XmlElement* distribution_ = nullptr;
  std::vector<TablePoint> points_;
  Tm33Table result_;
};

}  // namespace

std::optional<Tm33Table> read_tm33_table(const XmlElement& root, const XmlElement& emitter,
                                         Diagnostics& diagnostics) {
  return TableReader(root, emitter, diagnostics).read();
}

}  // namespace calc
