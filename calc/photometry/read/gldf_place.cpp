#include "calc/photometry/read/gldf_place.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/photometry/read/l3d_model.h"
#include "calc/photometry/read/text_encoding.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace calc {
namespace {

using ModelPlaces = std::map<std::string, EmitterPlace>;

class PlaceReader {
 public:
  PlaceReader(const GldfProduct& product, ZipArchive& archive)
      : product_(product), archive_(archive) {}

  // Names of emitting objects in models that are read.
  std::vector<const GldfPlace*> places_in_models(const GldfLight& light) const {
    std::vector<const GldfPlace*> found;
    const GldfVariant* variant = light.placing;
    if (variant == nullptr) return found;
    std::set<std::pair<std::string, std::string>> known;
    for (const GldfPlace& place : variant->places) {
      const bool is_l3d = place.model_type.empty() || place.model_type == "l3d";
      if (place.emitter_id != light.emitter->id || !is_l3d) continue;
      if (geometry(place.geometry_id) == nullptr) continue;
      if (known.emplace(place.geometry_id, place.object_name).second) found.push_back(&place);
    }
    return found;
  }

  // Empty, with a reason, if it is not known.
  std::optional<EmitterPlace> place(const GldfLight& light, std::string& reason) {
    const std::vector<const GldfPlace*> places = places_in_models(light);
    if (places.empty()) {
      reason = "product.xml names no model of the luminaire for them";
      return std::nullopt;
    }
    const ModelPlaces* model = read_model(places.front()->geometry_id, reason);
    if (model == nullptr) return std::nullopt;
    const auto found = model->find(places.front()->object_name);
    if (found != model->end()) return found->second;
    reason =
        fmt::format("the model has no emitting object '{}'", quotable(places.front()->object_name));
    return std::nullopt;
  }

 private:
  const GldfGeometry* geometry(const std::string& id) const {
    const auto found = std::find_if(product_.geometries.begin(), product_.geometries.end(),
                                    [&](const GldfGeometry& each) { return each.id == id; });
    return found == product_.geometries.end() ? nullptr : &*found;
  }

  // The L3D file of a model; levels of detail have the same emitting objects.
  const GldfFile* l3d_file(const GldfGeometry& model) const {
    for (const std::string& id : model.file_ids) {
      for (const GldfFile& file : product_.files) {
        if (file.id == id && file.content_type == "geo/l3d") return &file;
      }
    }
    return nullptr;
  }

  // Null, with a reason, if it cannot be read.
  const ModelPlaces* read_model(const std::string& geometry_id, std::string& reason) {
    if (const auto known = models_.find(geometry_id); known != models_.end()) return &known->second;
    const GldfFile* file = l3d_file(*geometry(geometry_id));
    if (file == nullptr) {
      reason = "the luminaire's model is not an L3D file";
      return nullptr;
    }
    std::string entry = "geo/" + file->text;
    if (!archive_.has(entry) && archive_.has(file->text)) entry = file->text;
    if (file->is_url || !archive_.has(entry)) {
      reason = "the luminaire's model is not in the GLDF file";
      return nullptr;
    }
    const std::optional<std::string> bytes = archive_.read(entry);
    std::string problem;
    std::optional<ModelPlaces> places = bytes ? read_l3d_places(*bytes, problem) : std::nullopt;
    if (!places) {
      reason = fmt::format("the luminaire's model cannot be read ({})", problem);
      return nullptr;
    }
    return &(models_[geometry_id] = std::move(*places));
  }

  const GldfProduct& product_;
  ZipArchive& archive_;
  std::map<std::string, ModelPlaces> models_;
};

std::string object_names(const std::vector<const GldfPlace*>& places) {
  std::string names;
  for (const GldfPlace* place : places) {
    names += (names.empty() ? "" : ", ") + quotable(place->object_name);
  }
  return names;
}

// False after an error.
bool is_at_one_place(const GldfLight& light, const std::vector<GldfLight>& lights,
                     const PlaceReader& reader, Diagnostics& diagnostics) {
  const std::vector<const GldfPlace*> places = reader.places_in_models(light);
  if (places.size() < 2) return true;
  if (lights.size() == 1) {
    diagnostics.report(DiagnosticId::gldf_many_places, light.emitter->where, light.id(),
                       places.size(), object_names(places));
    return true;
  }
  diagnostics.report(
      DiagnosticId::gldf_together, light.emitter->where, ids_of(lights),
      fmt::format("'{}' is at {} places ({}), and product.xml does not say whether each place or "
                  "all places together give its light",
                  light.id(), places.size(), object_names(places)),
      as_single_luminaires(lights));
  return false;
}

void move_to_the_middle(std::vector<EmitterPlace>& places) {
  glm::dvec3 low = places.front().position_m, high = low;
  for (const EmitterPlace& place : places) {
    low = glm::min(low, place.position_m);
    high = glm::max(high, place.position_m);
  }
  for (EmitterPlace& place : places) place.position_m -= 0.5 * (low + high);
}

}  // namespace

std::optional<std::vector<EmitterPlace>> places_of(const std::vector<GldfLight>& lights,
                                                   const GldfProduct& product, ZipArchive& archive,
                                                   Diagnostics& diagnostics) {
  PlaceReader reader(product, archive);
  for (const GldfLight& light : lights) {
    if (!is_at_one_place(light, lights, reader, diagnostics)) return std::nullopt;
  }
  std::vector<EmitterPlace> places(lights.size());
  if (lights.size() == 1) return places;
  std::string reason;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::optional<EmitterPlace> place = reader.place(lights[i], reason);
    if (place) {
      places[i] = *place;
      continue;
    }
    diagnostics.report(DiagnosticId::gldf_places, lights.front().fitting->where, ids_of(lights),
                       reason);
    return std::vector<EmitterPlace>(lights.size());
  }
  move_to_the_middle(places);
  return places;
}

std::string ids_of(const std::vector<GldfLight>& lights) {
  std::string ids;
  for (const GldfLight& light : lights) ids += (ids.empty() ? "'" : ", '") + light.id() + "'";
  return ids;
}

std::string as_single_luminaires(const std::vector<GldfLight>& lights) {
  std::string text;
  for (const GldfLight& light : lights) {
    text += fmt::format("{}emitter=\"{}\"", text.empty() ? "" : ", ", light.id());
  }
  return text;
}

}  // namespace calc
