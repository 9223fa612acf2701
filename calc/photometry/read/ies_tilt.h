#pragma once
// Reads TILT= of LM-63 files: the lamp's loss of light when the luminaire is tilted.

#include "calc/photometry/lamp_tilt.h"
#include "calc/photometry/read/lm63_numbers.h"

#include <functional>
#include <optional>
#include <string>

namespace calc {

// Returns the bytes of the file with this plain name (no folders) in the folder of the file being
// read; empty, with a message, if there is none.
using CompanionReader = std::function<std::optional<std::string>(const std::string& file_name)>;

// Reads the lamp-to-luminaire geometry, number of pairs, angles (degrees) and factors from the
// place of `numbers` on: after TILT=INCLUDE, or the whole of a TILT file. Empty if and only if an
// error was reported.
std::optional<LampTilt> read_tilt_data(Lm63Numbers& numbers);

// Reads the data of the file in TILT=<file name>. where: of the TILT= line.
std::optional<LampTilt> read_tilt_file(const std::string& file_name, const std::string& ies_name,
                                       const SourceLocation& where,
                                       const CompanionReader& read_companion,
                                       Diagnostics& diagnostics);

}  // namespace calc
