#pragma once
// Writes a web as an EULUMDAT file.

#include "calc/base/diagnostics.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>

namespace calc {

// Writes Isym by the symmetry that the light has exactly; intensities in cd/klm with 7 significant
// digits, conversion factor 1; one lamp set: the rated flux where one is stated, else one lamp
// written as -1 (absolute photometry) with the luminaire's own flux. Luminous length along C90,
// width along C0. Boxes and upright round cylinders have four equal heights; other bodies are
// written as the box or cylinder around them, with a warning. A web about another axis is resampled
// with a warning. The luminous size replaces the housing's, which a web does not have. Direct
// ratios are 0; CR LF. name: the new file, for messages. Empty if and only if an error was
// reported; warns of what the format cannot hold.
std::optional<std::string> write_eulumdat(const PhotometricWeb& web, const std::string& name,
                                          Diagnostics& diagnostics);

}  // namespace calc
