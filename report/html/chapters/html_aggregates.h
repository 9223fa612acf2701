#pragma once
// Aggregates and classes of rule packs as HTML.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Who reads it: clients are told how many checks are met, not the ids of them, and find the classes
// of a street in its own chapter alone.
enum class AggregatesFor { planner, client };

// All of one project, with their members; "" if there is none. index: of the project.
std::string html_aggregates(const Texts& t, const ProjectPart& project, std::size_t index,
                            AggregatesFor reader = AggregatesFor::planner);

// <li> of every aggregate of one project with this verdict that counts, for the list of what needs
// attention.
std::vector<std::string> html_aggregate_items(const Texts& t, const ProjectPart& project,
                                              std::size_t index, rules::Verdict verdict);

}  // namespace report
