#pragma once
// `luxgate export ifc`: writes the results of rooms back into their IFC model.

#include "report/document/document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Prefix of all property sets that luxgate adds.
inline constexpr std::string_view kIfcSetPrefix = "Luxgate_";

struct IfcWithResults {
  std::string text;                // the new model
  std::size_t rooms = 0;           // that have results now
  std::vector<std::string> notes;  // for people, each printable() and on one line
  // True if every result of a room has its place in the model, and the model's room is the
  // calculated one by size, outline and holes.
  bool is_all = true;
};

// Returns the model, byte for byte, with new instances at the end of its last DATA section: for
// each IfcSpace whose GlobalId is in the id of a room of the result the set Luxgate_Results, and a
// set Luxgate_Plane_ID for each plane; for the IfcProject the set Luxgate_Run with facts about all
// of them. Verdicts of rooms that have another size or shape in the model say so. Values are
// bounded values in the units that they name themselves. Unchanged additions of an earlier export
// are removed first. Empty exactly if `problem` says why: not IFC 2x3 or 4, no IfcSpace, nothing to
// write, no room of the result in the model, a room with two results, sets of luxgate that cannot
// be removed, more than 4 GiB, numbers of instances beyond kLargestStepNumber.
std::optional<IfcWithResults> ifc_with_results(std::string_view model,
                                               const report::Document& result,
                                               std::string& problem);

}  // namespace cli
