#include "calc/photometry/read/tm33_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/tm33_opening.h"
#include "calc/photometry/read/tm33_table.h"
#include "calc/photometry/read/web_assembly.h"
#include "calc/photometry/read/xml_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace calc {
namespace {

constexpr std::array<std::string_view, 4> kRoots{"IESTM33", "IESTM33-18", "IESTM33-22",
                                                 "LuminaireOpticalData"};
constexpr double kFluxTolerance = 0.05;  // relative, stated flux

struct Emitter {
  const XmlElement* element;
  std::string id, description;

  bool is_called(std::string_view choice, std::size_t index) const {
    return choice == id || choice == description || choice == fmt::format("{}", index + 1);
  }
};

class Tm33Reader {
 public:
  Tm33Reader(const XmlElement& root, const std::string& name, const PhotometryOptions& options,
             Diagnostics& diagnostics)
      : root_(root), name_(name), options_(options), diagnostics_(diagnostics) {}

  std::optional<PhotometricWeb> read() {
    list_emitters();
    if (!choose_emitters()) return std::nullopt;
    read_header();
    for (const Emitter& emitter : used_) {
      if (!add_emitter(*emitter.element)) return std::nullopt;
    }
    std::vector<const XmlElement*> elements;
    for (const Emitter& emitter : used_) elements.push_back(emitter.element);
    const std::optional<LuminousOpening> opening = read_tm33_opening(root_, elements, diagnostics_);
    if (!opening) return std::nullopt;
    if (source_.input_power_w == 0.0)
      diagnostics_.report(DiagnosticId::photometry_no_power, used_.front().element->where);
    if (!all_rated_) source_.rated_lamp_flux_lm = 0.0;
    if (all_stated_) source_.stated_flux_lm = stated_lm_;
    std::optional<PhotometricWeb> web =
        make_checked_web(std::move(sum_), *opening, std::move(source_), diagnostics_);
    if (web) warn_of_flux(*web);
    return web;
  }

 private:
  void list_emitters() {
    for (const XmlElement* element : children_of(root_, "Emitter")) {
      all_.push_back({element, text_of(child_of(*element, {"ID", "Id"})),
                      text_of(child_of(*element, "Description"))});
    }
  }

  std::string choices() const {
    std::vector<PhotometryChoice> list;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const bool has_id = !all_[i].id.empty();
      list.push_back({has_id ? all_[i].id : fmt::format("{}", i + 1), all_[i].description});
    }
    return list_choices(list);
  }

  bool choose_emitters() {
    if (all_.empty()) {
      diagnostics_.report(DiagnosticId::photometry_missing, root_.where, local_name(root_.name),
                          "<Emitter>");
      return false;
    }
    if (options_.emitter.empty()) {
      used_ = all_;
      return true;
    }
    std::vector<Emitter> by_id;  // ids go before other names
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (all_[i].is_called(options_.emitter, i)) used_.push_back(all_[i]);
      if (all_[i].id == options_.emitter) by_id.push_back(all_[i]);
    }
    if (!by_id.empty()) used_ = by_id;
    if (used_.size() == 1) return true;
    const SourceLocation where = place_of_choice(options_, name_);
    if (used_.empty()) {
      diagnostics_.report(DiagnosticId::photometry_choice, where, name_, "emitter",
                          options_.emitter, choices());
    } else {
      diagnostics_.report(DiagnosticId::photometry_choice, where, name_, "single emitter",
                          options_.emitter, fmt::format("a number from 1 to {}", all_.size()));
    }
    return false;
  }

  void read_header() {
    source_.format = fmt::format("TM-33 ({})", local_name(root_.name));
    source_.axis_rule = "C as written; length along C 90, width along C 0";
    const XmlElement* header = child_of(root_, "Header");
    if (header == nullptr) return;
    source_.manufacturer = text_of(child_of(*header, "Manufacturer"));
    source_.luminaire_name = text_of(child_of(*header, {"Description", "CatalogNumber"}));
    source_.article_number = text_of(child_of(*header, "CatalogNumber"));
  }

  // 1 if it is not stated; empty if it is not allowed.
  std::optional<double> quantity_of(const XmlElement& emitter) {
    const XmlElement* element = child_of(emitter, "Quantity");
    if (element == nullptr) return 1.0;
    const std::optional<double> quantity = number_in(element, diagnostics_);
    if (!quantity) return std::nullopt;
    if (!(*quantity >= 1.0 && *quantity <= 1.0e6 && *quantity == std::floor(*quantity))) {
      diagnostics_.report(DiagnosticId::photometry_value, element->where, "the quantity",
                          fmt::format("{}", *quantity), "a whole number from 1 to 1000000");
      return std::nullopt;
    }
    if (*quantity > 1.0)
      diagnostics_.report(DiagnosticId::photometry_quantity, element->where, *quantity);
    return quantity;
  }

  // A stated amount >= 0; 0 if it is not stated.
  double amount_in(const XmlElement* element) {
    const double amount = number_in(element, diagnostics_).value_or(0.0);
    if (amount >= 0.0) return amount;
    diagnostics_.report(DiagnosticId::photometry_value, element->where,
                        fmt::format("<{}>", local_name(element->name)), fmt::format("{}", amount),
                        ">= 0");
    return 0.0;
  }

  bool add_emitter(const XmlElement& emitter) {
    const std::size_t errors = diagnostics_.error_count();
    const std::optional<double> quantity = quantity_of(emitter);
    const std::optional<Tm33Table> read = read_tm33_table(root_, emitter, diagnostics_);
    const double rated_lm = amount_in(child_of(emitter, "RatedLumens"));
    const double power_w = amount_in(child_of(emitter, {"InputWattage", "InputWatts"}));
    has_all_powers_ = has_all_powers_ && power_w > 0.0;
    emitters_power_w_ += quantity.value_or(1.0) * power_w;
    // A sum without one of them would be too little.
    source_.input_power_w = has_all_powers_ ? emitters_power_w_ : 0.0;
    warn_of_unused(emitter);
    if (!quantity || !read || diagnostics_.error_count() != errors) return false;

    all_rated_ = all_rated_ && rated_lm > 0.0 && !read->is_absolute.value_or(false);
    source_.rated_lamp_flux_lm += *quantity * rated_lm;
    rated_in_any_case_lm_ += *quantity * rated_lm;
    all_stated_ = all_stated_ && read->stated_flux_lm.has_value();
    stated_lm_ += *quantity * read->stated_flux_lm.value_or(0.0);
    if (!source_.applied_factors.empty()) source_.applied_factors += " + ";
    source_.applied_factors +=
        fmt::format("TM-33 multiplier {} x quantity {}", read->multiplier, *quantity);
    return add_table(read->table, *quantity);
  }

  bool add_table(const FileTable& table, double quantity) {
    if (sum_.intensity_cd.empty()) {
      sum_ = table;
      for (double& cd : sum_.intensity_cd) cd *= quantity;
      return true;
    }
    if (table.c_deg != sum_.c_deg || table.gamma_deg != sum_.gamma_deg ||
        table.symmetry != sum_.symmetry) {
      diagnostics_.report(DiagnosticId::photometry_emitters_differ, table.where, used_.size(),
                          choices());
      return false;
    }
    for (std::size_t i = 0; i < sum_.intensity_cd.size(); ++i)
      sum_.intensity_cd[i] += quantity * table.intensity_cd[i];
    return true;
  }

  void warn_of_unused(const XmlElement& emitter) {
    const XmlElement* ballast = child_of(emitter, "BallastFactor");
    if (ballast != nullptr && parse_number(trim(ballast->text)) != 1.0) {
      diagnostics_.report(DiagnosticId::photometry_not_applied, ballast->where,
                          fmt::format("the ballast factor {}", text_of(ballast)),
                          "the intensities count as measured with the ballast");
    }
    if (const XmlElement* tilt = child_of(emitter, "TiltAngles")) {
      diagnostics_.report(DiagnosticId::photometry_not_applied, tilt->where, "the table of tilts",
                          "the luminaire is taken as installed as it was measured");
    }
  }

  void warn_of_flux(const PhotometricWeb& web) {
    const SourceLocation file{name_, 0, 0};
    if (all_stated_ && stated_lm_ > 0.0 &&
        std::abs(web.flux_lm() - stated_lm_) > kFluxTolerance * stated_lm_) {
      diagnostics_.report(DiagnosticId::photometry_stated_flux, file, stated_lm_, web.flux_lm());
    }
    const double rated = web.source().rated_lamp_flux_lm;
    if (rated > 0.0 && web.flux_lm() > kEfficiencyLimit * rated) {
      diagnostics_.report(DiagnosticId::photometry_flux_over_lamps, file, web.flux_lm(), rated);
    }
    warn_of_low_flux(web.flux_lm(), rated_in_any_case_lm_, file, diagnostics_);
  }

  const XmlElement& root_;
  const std::string& name_;
  const PhotometryOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<Emitter> all_, used_;
  FileTable sum_;
  PhotometrySource source_;
  bool all_rated_ = true, all_stated_ = true, has_all_powers_ = true;
  double emitters_power_w_ = 0.0;
  double rated_in_any_case_lm_ = 0.0, stated_lm_ = 0.0;
};

}  // namespace

std::optional<PhotometricWeb> parse_tm33(std::string_view text, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics) {
  const std::optional<XmlElement> root =
      parse_xml(std::string(text), name, diagnostics, XmlText::keep);
  if (!root) return std::nullopt;
  const auto known = std::find(kRoots.begin(), kRoots.end(), local_name(root->name));
  if (known == kRoots.end()) {
    diagnostics.report(DiagnosticId::photometry_xml_root, root->where, quotable(root->name),
                       join_choices({kRoots.begin(), kRoots.end()}));
    return std::nullopt;
  }
  return Tm33Reader(*root, name, options, diagnostics).read();
}

}  // namespace calc
