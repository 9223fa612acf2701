#pragma once
// Photometry files to webs. The format is told by content, not by name.

#include "calc/diagnostics.h"
#include "calc/photometry/web.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// bytes: a whole .ies (LM-63) or .ldt (EULUMDAT) file; name: the path used in messages.
// Empty if and only if at least one error was reported.
std::optional<PhotometricWeb> parse_photometry(std::string_view bytes, const std::string& name,
                                               Diagnostics& diagnostics);

}  // namespace calc
