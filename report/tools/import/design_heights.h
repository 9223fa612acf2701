#pragma once
// Reads heights from attributes of luminaires.

#include "report/tools/import/design.h"
#include "report/tools/import/design_notes.h"

#include <optional>
#include <string>

namespace cli {

// Returns the length in metres for "2800", "2,80 m": without a unit in metres_per_unit.
std::optional<double> length_of_text(const std::string& text, double metres_per_unit);

// Returns the first attribute with a value whose name matches the pattern: metres, above 0 and at
// most 1000. Empty without such an attribute; a text that is not a height is noted as a doubt.
std::optional<double> height_of_attribute(const DesignLuminaire& luminaire,
                                          const std::string& pattern, double metres_per_unit,
                                          DesignNotes& notes);

}  // namespace cli
