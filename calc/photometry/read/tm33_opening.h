#pragma once
// Reads the luminous opening of a TM-33 luminaire.

#include "calc/base/diagnostics.h"
#include "calc/base/xml_document.h"
#include "calc/photometry/web.h"

#include <optional>
#include <vector>

namespace calc {

// Takes the EmissionAreas of the used emitters, else Luminaire/LuminousOpening, else the outer
// Luminaire/Dimensions with a warning; millimetres. Length is along C90-C270 and width along
// C0-C180: the schema gives its C0 and C180 faces a length and its C90 and C270 faces a width
// (luminaires of either type, CIE C and IES C). Several areas and luminous sides become their
// bounding size, with a warning. Empty if and only if an error was reported.
std::optional<LuminousOpening> read_tm33_opening(const XmlElement& root,
                                                 const std::vector<const XmlElement*>& emitters,
                                                 Diagnostics& diagnostics);

}  // namespace calc
