#pragma once
// Reads TM-33 files (.xml): TM-33-18 with its twins ATLA S001 and UNI 11733, and TM-33-23.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Reads `text`, UTF-8 XML with the root IESTM33, IESTM33-18, IESTM33-22 or LuminaireOpticalData.
// Intensity = value x Multiplier x Quantity of the emitter. Several emitters shine together:
// without a choice (PhotometryOptions::emitter) their tables are added if they share all angles;
// otherwise that is an error. Frame and opening: tm33_opening.h. Empty if and only if at least one
// error was reported. name: the path for messages.
std::optional<PhotometricWeb> parse_tm33(std::string_view text, const std::string& name,
                                         const PhotometryOptions& options,
                                         Diagnostics& diagnostics);

}  // namespace calc
