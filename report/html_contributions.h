#pragma once
// What single luminaires give to a plane.

#include "report/document.h"
#include "report/texts.h"

#include <string>

namespace report {

// A folded table of the luminaires that give the most; "" where the document has none.
std::string html_contributions(const Texts& t, const PlanePart& plane);

}  // namespace report
