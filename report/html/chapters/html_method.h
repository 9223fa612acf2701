#pragma once
// How the values were calculated and what the words mean, for readers who are no lighting
// engineers.

#include "report/html/page/html_footnotes.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A section. confidence: of intervals, (0, 1).
std::string html_method(const Texts& t, double confidence, const Footnotes& footnotes);

}  // namespace report
