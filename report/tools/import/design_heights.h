#pragma once
// Heights that attributes of luminaires state.

#include "report/tools/import/design.h"
#include "report/tools/import/design_notes.h"

#include <optional>
#include <string>

namespace cli {

// "2800", "2,80 m": a number, in metres_per_unit where no unit stands behind it. In metres.
std::optional<double> length_of_text(const std::string& text, double metres_per_unit);

// Of the first attribute with a value whose name matches the pattern: metres, above 0 and at most
// 1000. Empty without one; what is no height is a doubt.
std::optional<double> height_of_attribute(const DesignLuminaire& luminaire,
                                          const std::string& pattern, double metres_per_unit,
                                          DesignNotes& notes);

}  // namespace cli
