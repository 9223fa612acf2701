#pragma once
// How a run got to its numbers: intervals after every look.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Relative half widths of every requirement's interval over light paths, all planes of a project in
// one picture; "" where nothing was sampled.
std::string html_convergence(const Texts& t, const ProjectPart& project);

// One plane's looks as a folded table; "" where nothing was sampled.
std::string html_looks(const Texts& t, const SpacePart& space, const PlanePart& plane);

}  // namespace report
