#include "calc/photometry/read/gldf_choice.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/photometry/read/text_encoding.h"

#include <algorithm>
#include <cstddef>
#include <utility>

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

bool shines_in_emergencies_only(const GldfEmitter& emitter) {
  return std::all_of(emitter.fittings.begin(), emitter.fittings.end(),
                     [](const GldfFitting& fitting) { return fitting.only_emergency; });
}

class Chooser {
 public:
  Chooser(const GldfProduct& product, const PhotometryOptions& options, const std::string& name,
          Diagnostics& diagnostics)
      : product_(product), options_(options), name_(name), diagnostics_(diagnostics) {
    set_emitter(options.emitter);
    if (find_by_id(product.emitters, emitter_id_) != nullptr) return;
    takes_all_ = options.emitter == kAllEmitters;
    const std::vector<std::string_view> words = split_words(options.emitter);
    if (words.size() > 1) list_.assign(words.begin(), words.end());
  }

  std::optional<std::vector<GldfLight>> choose() {
    if (!choose_variant()) return std::nullopt;
    if (takes_all_) return choose_all();
    if (!list_.empty()) return choose_listed();
    if (!choose_emitter() || !choose_fitting()) return std::nullopt;
    if (options_.emitter.empty()) warn_of_channels();
    return std::vector{light_};
  }

 private:
  bool is_several() const { return takes_all_ || !list_.empty(); }

  // "id#n"; an id cannot hold a '#'.
  void set_emitter(const std::string& written) {
    const std::size_t mark = written.rfind('#');
    emitter_id_ = written.substr(0, mark);
    light_.emitter = nullptr;
    fitting_number_.reset();
    if (mark != std::string::npos) fitting_number_ = written.substr(mark + 1);
  }

  std::optional<std::vector<GldfLight>> choose_listed() {
    std::vector<GldfLight> lights;
    for (const std::string& word : list_) {
      set_emitter(word);
      if (!choose_emitter() || !choose_fitting(word)) return std::nullopt;
      for (const GldfLight& other : lights) {
        if (other.emitter != light_.emitter) continue;
        diagnostics_.report(
            DiagnosticId::gldf_together, place_of_choice(options_, name_),
            "'" + quotable(options_.emitter) + "'",
            fmt::format("'{}' is named twice, and its fittings are alternatives", emitter_id_),
            fmt::format("emitter=\"{}\", ...", list_.front()));
        return std::nullopt;
      }
      lights.push_back(light_);
    }
    return lights;
  }

  std::optional<std::vector<GldfLight>> choose_all() {
    if (!channels_.empty()) {
      diagnostics_.report(
          DiagnosticId::gldf_together, place_of_choice(options_, name_),
          "'" + quotable(options_.emitter) + "'",
          fmt::format("'{}' has several channels, which are not read", channels_.front()->id),
          "use a separate photometry file for that emitter");
      return std::nullopt;
    }
    std::vector<GldfLight> lights;
    for (const GldfEmitter* emitter : candidates_) {
      if (candidates_.size() > 1 && shines_in_emergencies_only(*emitter)) {
        diagnostics_.report(DiagnosticId::gldf_left_out, emitter->where, emitter->id,
                            "it shines in emergencies only");
        continue;
      }
      set_emitter(emitter->id);
      if (!choose_emitter() || !choose_fitting()) return std::nullopt;
      lights.push_back(light_);
    }
    if (!lights.empty()) return lights;
    report_none();
    return std::nullopt;
  }

  void warn_of_channels() {
    for (const GldfEmitter* emitter : channels_) {
      diagnostics_.report(DiagnosticId::gldf_left_out, emitter->where, emitter->id,
                          "it has several channels, which are not read");
    }
  }

  void report_none() {
    diagnostics_.report(DiagnosticId::photometry_missing, SourceLocation{name_ + "/product.xml"},
                        "Root", "light emitter");
  }

  bool unknown(std::string_view owner, std::string_view kind, std::string_view choice,
               const std::vector<PhotometryChoice>& allowed) {
    diagnostics_.report(DiagnosticId::photometry_choice, place_of_choice(options_, name_), owner,
                        kind, choice, list_choices(allowed));
    return false;
  }
  bool needed(std::string_view kinds, std::string_view option,
              const std::vector<PhotometryChoice>& choices, const std::string& or_else = "") {
    diagnostics_.report(DiagnosticId::photometry_choice_needed, place_of_choice(options_, name_),
                        choices.size(), kinds, option, list_choices(choices) + or_else);
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

  // Those of the candidates' variant, else of the file.
  void note_channels(const GldfVariant* variant) {
    for (const GldfEmitter& emitter : product_.emitters) {
      const bool is_here =
          variant == nullptr || std::find(variant->emitter_ids.begin(), variant->emitter_ids.end(),
                                          emitter.id) != variant->emitter_ids.end();
      if (is_here && emitter.has_channels) channels_.push_back(&emitter);
    }
  }

  void take_all_emitters() {
    for (const GldfEmitter& emitter : product_.emitters) {
      if (!emitter.fittings.empty()) candidates_.push_back(&emitter);
    }
  }

  bool choose_variant() {
    if (!options_.variant.empty()) {
      light_.variant = light_.placing = find_by_id(product_.variants, options_.variant);
      if (light_.variant == nullptr) return unknown(name_, "variant", options_.variant, variants());
      note_channels(light_.variant);
      return emitters_of(*light_.variant, candidates_);
    }
    if ((options_.emitter.empty() || is_several()) && !find_common_emitters()) return false;
    if (candidates_.empty()) take_all_emitters();
    note_channels(light_.placing);
    return true;
  }

  // The candidates, if all variants that have any agree; several emitters must be at one place.
  bool find_common_emitters() {
    for (const GldfVariant& variant : product_.variants) {
      std::vector<const GldfEmitter*> emitters;
      if (!emitters_of(variant, emitters)) return false;
      if (emitters.empty()) continue;
      if (light_.placing == nullptr) {
        candidates_ = emitters;
        light_.placing = &variant;
      }
      if (candidates_ != emitters || (is_several() && light_.placing->places != variant.places)) {
        return needed("variants", "variant", variants());
      }
    }
    if (product_.variants.size() == 1) light_.variant = &product_.variants.front();
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
        report_none();
        return false;
      }
      if (candidates_.size() > 1) {
        return needed("emitters", "emitter", choices,
                      fmt::format("; '{}' takes those that shine together", kAllEmitters));
      }
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

  bool choose_fitting() { return choose_fitting(options_.emitter); }
  bool choose_fitting(const std::string& written) {
    const std::vector<GldfFitting>& fittings = light_.emitter->fittings;
    std::vector<PhotometryChoice> choices;
    for (std::size_t i = 0; i < fittings.size(); ++i)
      choices.push_back({fmt::format("{}#{}", light_.emitter->id, i + 1), fittings[i].name});
    if (fitting_number_) {
      const std::optional<int> number = parse_integer(*fitting_number_);
      if (!number || *number < 1 || static_cast<std::size_t>(*number) > fittings.size())
        return unknown(name_, "light emitter", written, choices);
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
  bool takes_all_ = false;
  std::vector<std::string> list_;  // of several that are named
  std::vector<const GldfEmitter*> candidates_;
  std::vector<const GldfEmitter*> channels_;  // lights that are not read
  GldfLight light_;
};

}  // namespace

std::string GldfLight::id() const {
  if (emitter->fittings.size() == 1) return emitter->id;
  return fmt::format("{}#{}", emitter->id, fitting - emitter->fittings.data() + 1);
}

std::optional<std::vector<GldfLight>> choose_gldf_lights(const GldfProduct& product,
                                                         const PhotometryOptions& options,
                                                         const std::string& name,
                                                         Diagnostics& diagnostics) {
  return Chooser(product, options, name, diagnostics).choose();
}

std::vector<PhotometryOptions> gldf_choices(const GldfProduct& product) {
  std::vector<PhotometryOptions> choices;
  const auto add = [&](const std::string& variant, std::string emitter) {
    PhotometryOptions choice;
    choice.variant = variant;
    choice.emitter = std::move(emitter);
    choices.push_back(std::move(choice));
  };
  const auto add_lights = [&](const std::string& variant, const GldfEmitter& emitter) {
    for (const GldfFitting& fitting : emitter.fittings) {
      add(variant, GldfLight{nullptr, &emitter, &fitting, nullptr}.id());
    }
  };
  for (const GldfVariant& variant : product.variants) {
    std::size_t emitters = 0;
    for (const std::string& id : variant.emitter_ids) {
      const GldfEmitter* emitter = find_by_id(product.emitters, id);
      if (emitter == nullptr || emitter->fittings.empty()) continue;
      add_lights(variant.id, *emitter);
      if (!shines_in_emergencies_only(*emitter)) ++emitters;
    }
    if (emitters > 1) add(variant.id, std::string(kAllEmitters));
  }
  if (!choices.empty()) return choices;
  for (const GldfEmitter& emitter : product.emitters) add_lights("", emitter);
  return choices;
}

}  // namespace calc
