#pragma once
// Writes a web as an LM-63-2002 file.

#include "calc/base/diagnostics.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>

namespace calc {

// Writes type C, TILT=NONE, metres, all factors 1, absolute candela with 7 significant digits, one
// lamp with the rated flux or -1 where none is stated; CR LF. Horizontal angles are reduced to one,
// 0 to 90 or 0 to 180 where the light has that symmetry exactly; light symmetric to C90-C270 only
// is written in full, since 2002 does not list 90 to 270. Opening: length along C0, width along
// C90, codes of 2002 for all shapes. A web about another axis is resampled with a warning.
// Keywords: manufacturer, name, and the origin of the file, because a web holds no others. name:
// the new file, for messages. Empty if and only if an error was reported; warns of what the format
// cannot hold.
std::optional<std::string> write_lm63(const PhotometricWeb& web, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace calc
