#pragma once
// `luxgate export ifc`: the results of rooms back into the IFC model that they are from.

#include "report/document/document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Before the names of all property sets that luxgate adds.
inline constexpr std::string_view kIfcSetPrefix = "Luxgate_";

struct IfcWithResults {
  std::string text;                // the new model
  std::size_t rooms = 0;           // that have results now
  std::vector<std::string> notes;  // for people, each printable() and on one line
  // Every result of a room has its place in the model, and that is the room that was calculated, as
  // far as its size, outline and holes tell.
  bool is_all = true;
};

// The model as it is, byte for byte, with new instances at the end of its last DATA section: for
// each IfcSpace whose GlobalId stands in the id of a room of the result the set Luxgate_Results,
// and a set Luxgate_Plane_ID for each plane; for the IfcProject the set Luxgate_Run with what holds
// for all of them. Verdicts of rooms that the model has in another size or shape say so. Values are
// bounded values in the units that they name themselves. What an earlier export has added is taken
// out before, where nobody has changed it. Empty if and only if `problem` says why: no IFC 2x3 or
// 4, no IfcSpace, nothing to write, no room of the result in the model, a room with two results,
// sets of luxgate that cannot be taken out, more than 4 GiB, numbers of instances beyond
// kLargestStepNumber.
std::optional<IfcWithResults> ifc_with_results(std::string_view model,
                                               const report::Document& result,
                                               std::string& problem);

}  // namespace cli
