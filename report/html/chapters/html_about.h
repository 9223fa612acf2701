#pragma once
// What a project says of itself, for the head of the page.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Logo and a list of names and texts; "" where nothing is said.
std::string html_about(const Texts& t, const calc::AboutProject& about);

}  // namespace report
