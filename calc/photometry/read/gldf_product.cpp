#include "calc/photometry/read/gldf_product.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/photometry/read/xml_query.h"

#include <algorithm>
#include <map>
#include <utility>

namespace calc {
namespace {

std::string text_in_one_language(const XmlElement* element) {
  if (element == nullptr) return "";
  const std::vector<const XmlElement*> locales = children_of(*element, "Locale");
  for (const XmlElement* locale : locales) {
    if (attribute_of(*locale, "language").starts_with("en")) return text_of(locale);
  }
  return locales.empty() ? text_of(element) : text_of(locales.front());
}

struct LightSource {
  double flux_lm = 0.0, power_w = 0.0;
};

struct Equipment {
  double flux_lm = 0.0, power_w = 0.0;
  LightSource lamps;
};

class ProductReader {
 public:
  ProductReader(const XmlElement& root, Diagnostics& diagnostics)
      : root_(root), diagnostics_(diagnostics) {}

  std::optional<GldfProduct> read() {
    const std::size_t errors = diagnostics_.error_count();
    product_.manufacturer = text_of(descend(root_, {"Header", "Manufacturer"}));
    product_.name =
        text_in_one_language(descend(root_, {"ProductDefinitions", "ProductMetaData", "Name"}));
    definitions_ = child_of(root_, "GeneralDefinitions");
    if (definitions_ == nullptr) {
      diagnostics_.report(DiagnosticId::photometry_missing, root_.where, "Root",
                          "<GeneralDefinitions>");
      return std::nullopt;
    }
    read_files();
    read_photometries();
    read_light_sources();
    read_equipment();
    read_emitters();
    read_variants();
    read_geometries();
    if (diagnostics_.error_count() != errors) return std::nullopt;
    return std::move(product_);
  }

 private:
  std::vector<const XmlElement*> list(std::string_view group, std::string_view item) const {
    const XmlElement* parent = child_of(*definitions_, group);
    return parent == nullptr ? std::vector<const XmlElement*>{} : children_of(*parent, item);
  }

  double number_of(const XmlElement& parent, std::string_view name) {
    const XmlElement* element = child_of(parent, name);
    const double value = number_in(element, diagnostics_).value_or(0.0);
    return check(fmt::format("<{}>", name), value, element);
  }

  // A flux, power or number of lamps; 0 after an error.
  double check(const std::string& what, double value, const XmlElement* element) {
    constexpr double kMost = 1.0e12;
    if (value >= 0.0 && value <= kMost) return value;
    diagnostics_.report(DiagnosticId::photometry_value, element->where, what,
                        fmt::format("{}", value), fmt::format("0 to {:g}", kMost));
    return 0.0;
  }

  void read_files() {
    for (const XmlElement* file : list("Files", "File")) {
      product_.files.push_back({attribute_of(*file, "id"), attribute_of(*file, "contentType"),
                                text_of(file), attribute_of(*file, "type") == "url", file->where});
    }
  }

  void read_photometries() {
    for (const XmlElement* photometry : list("Photometries", "Photometry")) {
      const XmlElement* reference = child_of(*photometry, "PhotometryFileReference");
      const std::string id = attribute_of(*photometry, "id");
      product_.photometries.push_back(
          {id, reference == nullptr ? "" : attribute_of(*reference, "fileId"), photometry->where});
      if (number_of_turn(child_of(*photometry, "Rotation-G0"))) turned_photometries_.push_back(id);
    }
  }

  bool number_of_turn(const XmlElement* element) {
    return number_in(element, diagnostics_).value_or(0.0) != 0.0;
  }

  void read_light_sources() {
    const XmlElement* group = child_of(*definitions_, "LightSources");
    if (group == nullptr) return;
    for (const XmlElement& element : group->children) {
      const XmlElement* old_form = child_of(element, "Changeable");
      const XmlElement& values = old_form == nullptr ? element : *old_form;
      light_sources_[attribute_of(element, "id")] = {number_of(values, "RatedLuminousFlux"),
                                                     number_of(values, "RatedInputPower")};
    }
  }

  // Flux and power of all the lamps that a <LightSourceReference> in `parent` stands for.
  LightSource lamps_of(const XmlElement& parent) {
    const XmlElement* reference = child_of(parent, "LightSourceReference");
    if (reference == nullptr) return {};
    std::string id;
    for (const char* name : {"changeableLightSourceId", "fixedLightSourceId", "lightSourceId"}) {
      if (id.empty()) id = attribute_of(*reference, name);
    }
    const auto found = light_sources_.find(id);
    if (found == light_sources_.end()) return {};
    const std::string count = attribute_of(*reference, "lightSourceCount");
    XmlElement as_element{"lightSourceCount", {}, {}, reference->where, count};
    const double lamps = count.empty()
                             ? 1.0
                             : check("lightSourceCount",
                                     number_in(&as_element, diagnostics_).value_or(1.0), reference);
    return {check("the flux of all lamps (lm)", lamps * found->second.flux_lm, reference),
            check("the power of all lamps (W)", lamps * found->second.power_w, reference)};
  }

  void read_equipment() {
    for (const XmlElement* element : list("Equipments", "Equipment")) {
      equipment_[attribute_of(*element, "id")] = {number_of(*element, "RatedLuminousFlux"),
                                                  number_of(*element, "RatedInputPower"),
                                                  lamps_of(*element)};
    }
  }

  GldfFitting read_fitting(const XmlElement& element, bool is_fixed) {
    GldfFitting fitting;
    fitting.where = element.where;
    fitting.name = text_in_one_language(child_of(element, "Name"));
    fitting.only_emergency = attribute_of(element, "emergencyBehaviour") == "EmergencyOnly";
    const XmlElement* reference = child_of(element, "PhotometryReference");
    fitting.photometry_id =
        attribute_of(reference == nullptr ? element : *reference, "photometryId");
    if (const XmlElement* rotation = child_of(element, "Rotation")) {
      for (const XmlElement& angle : rotation->children)
        fitting.is_turned = number_of_turn(&angle) || fitting.is_turned;
    }
    fitting.is_turned =
        fitting.is_turned || std::find(turned_photometries_.begin(), turned_photometries_.end(),
                                       fitting.photometry_id) != turned_photometries_.end();
    if (is_fixed) {
      fitting.fixed_flux_lm = number_of(element, "RatedLuminousFlux");
      fitting.source_power_w = lamps_of(element).power_w;
      return fitting;
    }
    const XmlElement* gear = child_of(element, "EquipmentReference");
    const auto found =
        equipment_.find(attribute_of(gear == nullptr ? element : *gear, "equipmentId"));
    if (found != equipment_.end()) {
      fitting.equipment_flux_lm = found->second.flux_lm;
      fitting.equipment_power_w = found->second.power_w;
      fitting.lamps_flux_lm = found->second.lamps.flux_lm;
      fitting.source_power_w = found->second.lamps.power_w;
      fitting.equipment_id = found->first;
    }
    return fitting;
  }

  void read_emitters() {
    for (const XmlElement* element : list("Emitters", "Emitter")) {
      GldfEmitter emitter{attribute_of(*element, "id"), {}, element->where};
      for (const XmlElement& child : element->children) {
        const std::string_view name = local_name(child.name);
        if (name == "ChangeableLightEmitter" || name == "LightEmitter")
          emitter.fittings.push_back(read_fitting(child, false));
        if (name == "FixedLightEmitter") emitter.fittings.push_back(read_fitting(child, true));
        emitter.has_channels = emitter.has_channels || name == "MultiChannelLightEmitter";
      }
      product_.emitters.push_back(std::move(emitter));
    }
  }

  // Emitters may be named directly in the variant, in its <Geometry>, or deeper at its models.
  void collect_places(const XmlElement& element, const std::string& outer_geometry_id,
                      GldfVariant& variant) {
    std::string geometry_id = attribute_of(element, "geometryId");
    if (geometry_id.empty()) geometry_id = outer_geometry_id;
    GldfPlace place{attribute_of(element, "emitterId"), geometry_id,
                    text_of(child_of(element, "EmitterObjectExternalName")),
                    attribute_of(element, "targetModelType")};
    if (!place.emitter_id.empty()) {
      std::vector<std::string>& ids = variant.emitter_ids;
      if (std::find(ids.begin(), ids.end(), place.emitter_id) == ids.end()) {
        ids.push_back(place.emitter_id);
      }
      variant.places.push_back(std::move(place));
    }
    for (const XmlElement& child : element.children) collect_places(child, geometry_id, variant);
  }

  void read_geometries() {
    for (const XmlElement* element : list("Geometries", "ModelGeometry")) {
      GldfGeometry geometry{attribute_of(*element, "id"), {}};
      for (const XmlElement* file : children_of(*element, "GeometryFileReference")) {
        geometry.file_ids.push_back(attribute_of(*file, "fileId"));
      }
      product_.geometries.push_back(std::move(geometry));
    }
  }

  void read_variants() {
    const XmlElement* group = descend(root_, {"ProductDefinitions", "Variants"});
    if (group == nullptr) return;
    for (const XmlElement* element : children_of(*group, "Variant")) {
      GldfVariant variant{attribute_of(*element, "id"),
                          text_in_one_language(child_of(*element, "Name")),
                          {},
                          element->where};
      collect_places(*element, "", variant);
      product_.variants.push_back(std::move(variant));
    }
  }

  const XmlElement& root_;
  Diagnostics& diagnostics_;
  const XmlElement* definitions_ = nullptr;
  std::vector<std::string> turned_photometries_;
  std::map<std::string, LightSource> light_sources_;
  std::map<std::string, Equipment> equipment_;
  GldfProduct product_;
};

}  // namespace

std::optional<GldfProduct> read_gldf_product(const XmlElement& root, Diagnostics& diagnostics) {
  return ProductReader(root, diagnostics).read();
}

}  // namespace calc
