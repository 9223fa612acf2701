#include "calc/photometry/read/gldf.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/utf8.h"
#include "calc/photometry/read/gldf_choice.h"
#include "calc/photometry/read/gldf_place.h"
#include "calc/photometry/read/gldf_product.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/read/text_encoding.h"
#include "calc/photometry/read/xml_query.h"
#include "calc/photometry/read/zip_archive.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr double kSameValue = 0.01;   // relative
constexpr double kFullOutput = 0.02;  // of the light output ratio around 1
constexpr const char* kProduct = "product.xml";

bool same_value(double a, double b) { return std::abs(a - b) <= kSameValue * std::max(a, b); }

PhotometricWeb scaled(const PhotometricWeb& web, double factor, PhotometrySource source) {
  std::vector<double> intensity_cd;
  for (std::size_t c = 0; c < web.c_rad().size(); ++c) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g)
      intensity_cd.push_back(factor * web.table_cd(c, g));
  }
  return PhotometricWeb::make(web.c_rad(), web.gamma_rad(), std::move(intensity_cd), web.opening(),
                              std::move(source), web.axis());
}

class GldfReader {
 public:
  GldfReader(ZipArchive& archive, const std::string& name, const PhotometryOptions& options,
             Diagnostics& diagnostics)
      : archive_(archive), name_(name), options_(options), diagnostics_(diagnostics) {}

  std::optional<LuminaireLight> read() {
    const std::optional<GldfProduct> product = read_product();
    if (!product) return std::nullopt;
    const std::optional<std::vector<GldfLight>> lights =
        choose_gldf_lights(*product, options_, name_, diagnostics_);
    if (!lights || !can_be_together(*lights)) return std::nullopt;
    LuminaireLight luminaire;
    for (const GldfLight& light : *lights) {
      std::optional<PhotometricWeb> web = read_light(*product, light);
      if (!web) return std::nullopt;
      luminaire.emitters.push_back({std::move(*web), light.id(), {}});
    }
    const std::optional<std::vector<EmitterPlace>> places =
        places_of(*lights, *product, archive_, diagnostics_);
    if (!places) return std::nullopt;
    for (std::size_t i = 0; i < places->size(); ++i) luminaire.emitters[i].place = (*places)[i];
    return luminaire;
  }

  std::vector<PhotometryOptions> choices() {
    const std::optional<GldfProduct> product = read_product();
    return product ? gldf_choices(*product) : std::vector<PhotometryOptions>{};
  }

 private:
  // False, with an error, if nothing says how.
  bool can_be_together(const std::vector<GldfLight>& lights) {
    if (lights.size() < 2) return true;
    std::set<std::string> equipment;
    for (const GldfLight& light : lights) {
      const GldfFitting& fitting = *light.fitting;
      std::string problem;
      if (fitting.is_turned) {
        problem = fmt::format("'{}' is turned in product.xml, which is not applied", light.id());
      } else if (fitting.equipment_flux_lm + fitting.equipment_power_w > 0.0 &&
                 !equipment.insert(fitting.equipment_id).second) {
        problem = fmt::format(
            "'{}' shares its equipment '{}' with another emitter, and product.xml does not say "
            "whether flux and power are those of one emitter or of all",
            light.id(), quotable(fitting.equipment_id));
      }
      if (problem.empty()) continue;
      diagnostics_.report(DiagnosticId::gldf_together, fitting.where, ids_of(lights), problem,
                          as_single_luminaires(lights));
      return false;
    }
    return true;
  }

  std::optional<PhotometricWeb> read_light(const GldfProduct& product, const GldfLight& light) {
    const GldfFile* file = file_of(product, *light.fitting);
    if (file == nullptr) return std::nullopt;
    std::optional<PhotometricWeb> web = read_photometry(*file);
    if (!web) return std::nullopt;
    if (light.fitting->is_turned) {
      diagnostics_.report(DiagnosticId::photometry_not_applied, light.fitting->where,
                          "the emitter's rotation", "aim the luminaire in the project");
    }
    return with_product_values(*web, product, light);
  }

  std::optional<GldfProduct> read_product() {
    std::optional<std::string> bytes = archive_.read(kProduct);
    if (!bytes) return std::nullopt;
    const std::optional<XmlElement> root =
        parse_xml(std::move(*bytes), name_ + "/" + kProduct, diagnostics_, XmlText::keep);
    if (!root) return std::nullopt;
    if (local_name(root->name) != "Root") {
      diagnostics_.report(DiagnosticId::photometry_xml_root, root->where, quotable(root->name),
                          "Root, in product.xml of a GLDF file");
      return std::nullopt;
    }
    return read_gldf_product(*root, diagnostics_);
  }

  template <class Item>
  const Item* find(const std::vector<Item>& items, std::string_view kind, const std::string& id,
                   const SourceLocation& where) {
    std::vector<PhotometryChoice> known;
    for (const Item& item : items) {
      if (item.id == id) return &item;
      known.push_back({item.id, ""});
    }
    diagnostics_.report(DiagnosticId::gldf_reference, where, kind, quotable(id),
                        list_choices(known));
    return nullptr;
  }

  // Null, with an error, if the photometry is no file in the archive that can be read.
  const GldfFile* file_of(const GldfProduct& product, const GldfFitting& fitting) {
    const GldfPhotometry* photometry =
        find(product.photometries, "photometry", fitting.photometry_id, fitting.where);
    if (photometry == nullptr) return nullptr;
    const GldfFile* file = find(product.files, "file", photometry->file_id, photometry->where);
    if (file == nullptr) return nullptr;
    const std::string& type = file->content_type;
    if (type != "ldc/eulumdat" && type != "ldc/ies" && type != "ldc/iesxml") {
      diagnostics_.report(DiagnosticId::gldf_content_type, file->where, quotable(file->text),
                          quotable(type));
      return nullptr;
    }
    if (file->is_url) {
      diagnostics_.report(DiagnosticId::gldf_url, file->where, quotable(file->id),
                          shorten_utf8(file->text, 200));
      return nullptr;
    }
    if (const std::string_view reason = unsafe_name_reason(file->text); !reason.empty()) {
      diagnostics_.report(DiagnosticId::archive_name, file->where, quotable(file->text), reason);
      return nullptr;
    }
    return file;
  }

  std::optional<PhotometricWeb> read_photometry(const GldfFile& file) {
    // The folder is the first part of the content type; some writers state it in the name.
    std::string entry = "ldc/" + file.text;
    if (!archive_.has(entry) && archive_.has(file.text)) entry = file.text;
    const std::optional<std::string> bytes = archive_.read(entry);
    if (!bytes) return std::nullopt;
    PhotometryOptions options;
    options.lamp_set = options_.lamp_set;
    options.where = options_.where;
    return parse_text_photometry(*bytes, name_ + "/" + entry, diagnostics_, options);
  }

  // What product.xml says goes before what the photometry file says.
  PhotometricWeb with_product_values(const PhotometricWeb& web, const GldfProduct& product,
                                     const GldfLight& light) {
    PhotometrySource source = web.source();
    source.format = fmt::format("GLDF ({})", source.format);
    if (!product.manufacturer.empty()) source.manufacturer = product.manufacturer;
    if (!product.name.empty()) source.luminaire_name = product.name;
    if (light.variant != nullptr && !light.variant->name.empty() &&
        light.variant->name != product.name) {
      source.luminaire_name += (source.luminaire_name.empty() ? "" : ", ") + light.variant->name;
    }
    const double factor = flux_factor(web, *light.fitting, source);
    choose_power(*light.fitting, !same_value(factor, 1.0), source);
    source.stated_flux_lm *= factor;
    return scaled(web, factor, std::move(source));
  }

  void choose_power(const GldfFitting& fitting, bool is_other_light, PhotometrySource& source) {
    const double file_w = source.input_power_w;
    const double gear_w = fitting.equipment_power_w, lamps_w = fitting.source_power_w;
    if (gear_w == 0.0 && lamps_w == 0.0) {
      if (!is_other_light || file_w == 0.0) return;
      diagnostics_.report(DiagnosticId::gldf_power_unknown, fitting.where, file_w);
      source.input_power_w = 0.0;
      source.power_rule.clear();
      return;
    }
    const bool is_products = gear_w > 0.0 || is_other_light || lamps_w > file_w;
    const double stated_w = gear_w > 0.0 ? gear_w : lamps_w;
    if (file_w > 0.0 && !same_value(stated_w, file_w)) {
      diagnostics_.report(
          DiagnosticId::gldf_value, fitting.where, "the power (W)", stated_w, file_w,
          is_products ? "product.xml counts"
                      : "the value of product.xml is the power of the light sources alone. The "
                        "higher one, of the photometry file, was kept; set it by "
                        "'power-w'");
    }
    if (!is_products) return;
    source.input_power_w = stated_w;
    source.power_rule = gear_w > 0.0 ? "product.xml, equipment with its gear"
                                     : "product.xml, light sources (their gear may come on top)";
  }

  // By how much the light is scaled; notes it in `source`.
  double flux_factor(const PhotometricWeb& web, const GldfFitting& fitting,
                     PhotometrySource& source) {
    const double lamps_lm = source.rated_lamp_flux_lm;
    const bool is_absolute = lamps_lm == 0.0;
    const double file_lm = is_absolute ? web.flux_lm() : lamps_lm;
    double stated = fitting.lamps_flux_lm;
    std::string_view doubt = "the flux of single lamps without the effect of their gear";
    if (fitting.fixed_flux_lm > 0.0) {
      stated = fitting.fixed_flux_lm;
      const bool is_full = std::abs(web.flux_lm() - file_lm) <= kFullOutput * file_lm;
      if (!is_full && same_value(stated, web.flux_lm())) return 1.0;
      doubt = is_full ? "" : "the flux of the lamps or of the luminaire (not known which)";
    } else if (fitting.equipment_flux_lm > 0.0) {
      stated = fitting.equipment_flux_lm;
      doubt = is_absolute ? "the flux of the lamps, which the photometry file does not state" : "";
    }
    if (stated == 0.0 || same_value(stated, file_lm)) return 1.0;
    diagnostics_.report(
        DiagnosticId::gldf_value, fitting.where, "the luminous flux (lm)", stated, file_lm,
        doubt.empty() ? "the light was scaled to product.xml"
                      : fmt::format("the value of product.xml is {}. The light of the photometry "
                                    "file was kept; set it by 'flux-lm'",
                                    doubt));
    if (!doubt.empty()) return 1.0;
    source.applied_factors += fmt::format(" x GLDF {} lm / {:.6g} lm", stated, file_lm);
    if (!is_absolute) source.rated_lamp_flux_lm = stated;
    return stated / file_lm;
  }

  ZipArchive& archive_;
  const std::string& name_;
  const PhotometryOptions& options_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<LuminaireLight> parse_gldf_luminaire(std::string_view bytes, const std::string& name,
                                                   const PhotometryOptions& options,
                                                   Diagnostics& diagnostics) {
  std::optional<ZipArchive> archive = ZipArchive::open(bytes, name, diagnostics);
  if (!archive) return std::nullopt;
  return GldfReader(*archive, name, options, diagnostics).read();
}

std::vector<PhotometryOptions> choices_of_gldf(std::string_view bytes) {
  Diagnostics own;
  std::optional<ZipArchive> archive = ZipArchive::open(bytes, "", own);
  if (!archive) return {};
  const PhotometryOptions none;
  const std::string name;
  return GldfReader(*archive, name, none, own).choices();
}

std::optional<PhotometricWeb> parse_gldf(std::string_view bytes, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics) {
  std::optional<LuminaireLight> light = parse_gldf_luminaire(bytes, name, options, diagnostics);
  if (!light) return std::nullopt;
  return only_light(std::move(*light), name, options, diagnostics);
}

}  // namespace calc
