#pragma once
// Chooses among the lights in a GLDF file.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/gldf_product.h"
#include "calc/photometry/read/photometry_options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct GldfLight {
  const GldfVariant* variant = nullptr;  // null: none was chosen, and it makes no difference
  const GldfEmitter* emitter = nullptr;
  const GldfFitting* fitting = nullptr;
  const GldfVariant* placing = nullptr;  // the variant that says where it is; null: none does

  std::string id() const;  // of the emitter, with its number where it has several fittings
};

// Chooses by PhotometryOptions::variant and ::emitter. Without a choice: the variant if all
// variants use the same light emitters, the emitter if there is one, its fitting if there is one
// (not counting those for emergencies only) or all of them are the same light. Otherwise an error
// lists the choices. The emitter kAllEmitters takes all of the variant that shine together, without
// those for emergencies only, with a message; several ids with blanks between them take those.
// name: the path of the GLDF file. Not empty; the lights point into `product`.
std::optional<std::vector<GldfLight>> choose_gldf_lights(const GldfProduct& product,
                                                         const PhotometryOptions& options,
                                                         const std::string& name,
                                                         Diagnostics& diagnostics);

// Returns all choices: every variant with each of its lights, and with all of them together where
// it has several; each emitter where there are no variants.
std::vector<PhotometryOptions> gldf_choices(const GldfProduct& product);

}  // namespace calc
