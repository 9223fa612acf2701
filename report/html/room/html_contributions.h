#pragma once
// What single luminaires give to a plane.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A folded table of the luminaires that give the most; "" where the document has none.
std::string html_contributions(const Texts& t, const PlanePart& plane);

}  // namespace report
