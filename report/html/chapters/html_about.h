#pragma once
// The project data for the head of the page.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns the logo and a list of names and texts; "" if there are none.
std::string html_about(const Texts& t, const calc::AboutProject& about);

}  // namespace report
