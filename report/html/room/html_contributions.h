#pragma once
// The light of single luminaires on a plane.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns a folded table of the luminaires that give the most; "" if the document has none.
std::string html_contributions(const Texts& t, const PlanePart& plane);

}  // namespace report
