#pragma once
// Reads the light in product.xml of a GLDF file: files, photometries, emitters, variants.

#include "calc/base/diagnostics.h"
#include "calc/base/xml_document.h"
#include "calc/photometry/read/photometry_options.h"

#include <optional>
#include <string>
#include <vector>

namespace calc {

struct GldfFile {
  std::string id, content_type, text;  // text: a file name or an address
  bool is_url = false;
  SourceLocation where;
};

// A model of the luminaire: its files, of any detail and format. None: a simple shape.
struct GldfGeometry {
  std::string id;
  std::vector<std::string> file_ids;
};

struct GldfPhotometry {
  std::string id, file_id;
  SourceLocation where;
};

// A way in which an emitter can shine; the fittings of an emitter are alternatives.
struct GldfFitting {
  std::string name;  // may be empty
  std::string photometry_id;
  std::string equipment_id;  // empty: a fixed light source
  bool only_emergency = false;
  bool is_turned = false;  // a rotation of the light is stated, of the fitting or its photometry
  // Stated fluxes, 0 = not stated: of a fixed emitter (product.xml leaves open whether of its lamps
  // or of the luminaire); of the equipment, for all its lamps together; of the lamps alone.
  double fixed_flux_lm = 0.0, equipment_flux_lm = 0.0, lamps_flux_lm = 0.0;
  // Power with and without gear, of all light sources together; 0 = not stated.
  double equipment_power_w = 0.0, source_power_w = 0.0;
  SourceLocation where;
};

struct GldfEmitter {
  std::string id;
  std::vector<GldfFitting> fittings;  // empty: a sensor, or one of several channels
  SourceLocation where;
  bool has_channels = false;  // its colours or white tones are mixed, which is not read

  PhotometryChoice choice() const { return {id, fittings.empty() ? "" : fittings.front().name}; }
};

// The place of an emitter in a variant.
struct GldfPlace {
  std::string emitter_id;
  std::string geometry_id;  // empty: of no model
  std::string object_name;  // of the emitting object in the model; may be empty
  std::string model_type;   // "l3d", ...: names are those of that model only; may be empty
  bool operator==(const GldfPlace&) const = default;
};

struct GldfVariant {
  std::string id, name;
  std::vector<std::string> emitter_ids;  // each once, in file order
  SourceLocation where;
  std::vector<GldfPlace> places = {};
};

struct GldfProduct {
  std::string manufacturer, name;
  std::vector<GldfFile> files;
  std::vector<GldfPhotometry> photometries;
  std::vector<GldfEmitter> emitters;
  std::vector<GldfVariant> variants;
  std::vector<GldfGeometry> geometries;
};

// Reads <Root> of product.xml, `root`, in GLDF 1.0 and the earlier form with <LightEmitter>. Of
// texts in several languages it takes English if there is any, else the first. References are not
// followed here, except for lamps and equipment. Empty if and only if an error was reported.
std::optional<GldfProduct> read_gldf_product(const XmlElement& root, Diagnostics& diagnostics);

}  // namespace calc
