#include "calc/photometry/read/gldf_choice.h"

#include "calc/base/text.h"
#include "calc/photometry/read/text_encoding.h"

#include <algorithm>
#include <vector>

namespace calc {
namespace {

template <class Item>
const Item* find_by_id(const std::vector<Item>& items, std::string_view id) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.id == id; });
  return found == items.end() ? nullptr : &*found;
}

bool same_light(const GldfFitting& a, const GldfFitting& b) {
  return a.photometry_id == b.photometry_id && a.fixed_flux_lm == b.fixed_flux_lm &&
         a.equipment_flux_lm == b.equipment_flux_lm && a.lamps_flux_lm == b.lamps_flux_lm &&
         a.equipment_power_w == b.equipment_power_w && a.source_power_w == b.source_power_w;
}

class Chooser {
 public:
  Chooser(const GldfProduct& product, const PhotometryOptions& options, const std::string& name,
          Diagnostics& diagnostics)
      : product_(product), options_(options), name_(name), diagnostics_(diagnostics) {
    // "id#n"; an id cannot hold a '#'.
    const std::size_t mark = options.emitter.rfind('#');
    emitter_id_ = options.emitter.substr(0, mark);
    if (mark != std::string::npos) fitting_number_ = options.emitter.substr(mark + 1);
  }

  std::optional<GldfLight> choose() {
    if (!choose_variant() || !choose_emitter() || !choose_fitting()) return std::nullopt;
    return light_;
  }

 private:
  bool unknown(std::string_view owner, std::string_view kind, std::string_view choice,
               const std::vector<PhotometryChoice>& allowed) {
    diagnostics_.report(DiagnosticId::photometry_choice, place_of_choice(options_, name_), owner,
                        kind, choice, list_choices(allowed));
    return false;
  }
  bool needed(std::string_view kinds, std::string_view option,
              const std::vector<PhotometryChoice>& choices) {
    diagnostics_.report(DiagnosticId::photometry_choice_needed, place_of_choice(options_, name_),
                        choices.size(), kinds, option, list_choices(choices));
    return false;
  }

  // The light emitters of a variant; reports ids that are not defined.
  bool emitters_of(const GldfVariant& variant, std::vector<const GldfEmitter*>& emitters) {
    for (const std::string& id : variant.emitter_ids) {
      const GldfEmitter* emitter = find_by_id(product_.emitters, id);
      if (emitter == nullptr) {
        std::vector<PhotometryChoice> known;
        for (const GldfEmitter& each : product_.emitters) known.push_back(each.choice());
        diagnostics_.report(DiagnosticId::gldf_reference, variant.where, "emitter", quotable(id),
                            list_choices(known));
        return false;
      }
      if (!emitter->fittings.empty()) emitters.push_back(emitter);
    }
    return true;
  }

  void take_all_emitters() {
    for (const GldfEmitter& emitter : product_.emitters) {
      if (!emitter.fittings.empty()) candidates_.push_back(&emitter);
    }
  }

  bool choose_variant() {
    if (!options_.variant.empty()) {
      light_.variant = find_by_id(product_.variants, options_.variant);
      if (light_.variant != nullptr) return emitters_of(*light_.variant, candidates_);
      return unknown(name_, "variant", options_.variant, variants());
    }
    if (options_.emitter.empty()) {
      bool is_first = true;
      for (const GldfVariant& variant : product_.variants) {
        std::vector<const GldfEmitter*> emitters;
        if (!emitters_of(variant, emitters)) return false;
        if (emitters.empty()) continue;
        if (is_first) candidates_ = emitters;
        if (candidates_ != emitters) return needed("variants", "variant", variants());
        is_first = false;
      }
      if (product_.variants.size() == 1) light_.variant = &product_.variants.front();
    }
    if (candidates_.empty()) take_all_emitters();
    return true;
  }

  std::vector<PhotometryChoice> variants() const {
    std::vector<PhotometryChoice> list;
    for (const GldfVariant& variant : product_.variants) list.push_back({variant.id, variant.name});
    return list;
  }

  bool choose_emitter() {
    std::vector<PhotometryChoice> choices;
    for (const GldfEmitter* emitter : candidates_) choices.push_back(emitter->choice());
    if (emitter_id_.empty()) {
      if (candidates_.empty()) {
        diagnostics_.report(DiagnosticId::photometry_missing,
                            SourceLocation{name_ + "/product.xml"}, "Root", "light emitter");
        return false;
      }
      if (candidates_.size() > 1) return needed("emitters", "emitter", choices);
      light_.emitter = candidates_.front();
      return true;
    }
    for (const GldfEmitter* emitter : candidates_) {
      if (emitter->id == emitter_id_) light_.emitter = emitter;
    }
    if (light_.emitter != nullptr) return true;
    const std::string owner =
        light_.variant == nullptr ? name_ : fmt::format("variant '{}'", light_.variant->id);
    return unknown(owner, "light emitter", emitter_id_, choices);
  }

  bool choose_fitting() {
    const std::vector<GldfFitting>& fittings = light_.emitter->fittings;
    std::vector<PhotometryChoice> choices;
    for (std::size_t i = 0; i < fittings.size(); ++i)
      choices.push_back({fmt::format("{}#{}", light_.emitter->id, i + 1), fittings[i].name});
    if (fitting_number_) {
      const std::optional<int> number = parse_integer(*fitting_number_);
      if (!number || *number < 1 || static_cast<std::size_t>(*number) > fittings.size())
        return unknown(name_, "light emitter", options_.emitter, choices);
      light_.fitting = &fittings[static_cast<std::size_t>(*number) - 1];
      return true;
    }
    std::vector<const GldfFitting*> usual;
    for (const GldfFitting& fitting : fittings) {
      if (!fitting.only_emergency) usual.push_back(&fitting);
    }
    if (usual.empty()) {
      for (const GldfFitting& fitting : fittings) usual.push_back(&fitting);
    }
    for (const GldfFitting* fitting : usual) {
      if (!same_light(*fitting, *usual.front()))
        return needed("fittings of the emitter", "emitter", choices);
    }
    light_.fitting = usual.front();
    return true;
  }

  const GldfProduct& product_;
  const PhotometryOptions& options_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  std::string emitter_id_;
  std::optional<std::string> fitting_number_;
  std::vector<const GldfEmitter*> candidates_;
  GldfLight light_;
};

}  // namespace

std::optional<GldfLight> choose_gldf_light(const GldfProduct& product,
                                           const PhotometryOptions& options,
                                           const std::string& name, Diagnostics& diagnostics) {
  return Chooser(product, options, name, diagnostics).choose();
}

}  // namespace calc
