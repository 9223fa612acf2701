#pragma once
// The course of a run: intervals after every sampling round.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns the relative half widths of every requirement's interval over light paths, all planes of
// a project in one picture; "" if nothing was sampled.
std::string html_convergence(const Texts& t, const ProjectPart& project);

// Returns the sampling rounds of a plane as a folded table; "" if nothing was sampled.
std::string html_looks(const Texts& t, const SpacePart& space, const PlanePart& plane);

}  // namespace report
