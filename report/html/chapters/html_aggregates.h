#pragma once
// Aggregates and classes of rule packs as HTML.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// The reader: clients see how many checks are met instead of their ids, and find the classes of a
// street only in its own chapter.
enum class AggregatesFor { planner, client };

// Returns all aggregates of a project with their members; "" if there are none. index: of the
// project.
std::string html_aggregates(const Texts& t, const ProjectPart& project, std::size_t index,
                            AggregatesFor reader = AggregatesFor::planner);

// Returns an <li> for every aggregate of a project with this verdict that counts, for the list of
// open points.
std::vector<std::string> html_aggregate_items(const Texts& t, const ProjectPart& project,
                                              std::size_t index, rules::Verdict verdict);

}  // namespace report
