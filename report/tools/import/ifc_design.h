#pragma once
// Reads IFC files (2x3 and 4, STEP text) as designs: spaces, light fixtures and furniture.

#include "report/tools/import/design.h"
#include "report/tools/import/step_text.h"

#include <optional>
#include <string>
#include <string_view>

namespace cli {

struct IfcOptions {
  std::optional<double> metres_per_unit;  // > 0; instead of the unit that the file states
};

// Returns the design. Every room and luminaire has its GlobalId as key. A luminaire is an
// IfcLightFixture, or anything with an IfcLightFixtureType (IFC2x3); its attributes are "Tag",
// "PredefinedType" and the single values of its property sets, and then of its type's, as
// "Set.Property"; numbers as the file writes them. Things that cannot be imported are notes, by
// their reasons. Empty with a problem if the file cannot be read: see StepText::open() and
// read_ifc_units(), and a schema that is not IFC2X3 or IFC4.
std::optional<Design> read_ifc(std::string_view bytes, const std::string& name,
                               const IfcOptions& options, StepProblem& problem);

}  // namespace cli
