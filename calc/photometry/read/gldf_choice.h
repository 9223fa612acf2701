#pragma once
// Which of the lights in a GLDF file is meant.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/gldf_product.h"
#include "calc/photometry/read/photometry_options.h"

#include <optional>
#include <string>

namespace calc {

struct GldfLight {
  const GldfVariant* variant = nullptr;  // null: none was chosen, and it makes no difference
  const GldfEmitter* emitter = nullptr;
  const GldfFitting* fitting = nullptr;
};

// By PhotometryOptions::variant and ::emitter. Without a choice: the variant if all variants use
// the same light emitters, the emitter if there is one, its fitting if there is one (not counting
// those for emergencies only) or all of them are the same light. Otherwise an error that lists what
// can be chosen. Emitters of a variant that shine together are not added, because they may sit at
// different places. name: the path of the GLDF file. The result points into `product`.
std::optional<GldfLight> choose_gldf_light(const GldfProduct& product,
                                           const PhotometryOptions& options,
                                           const std::string& name, Diagnostics& diagnostics);

}  // namespace calc
