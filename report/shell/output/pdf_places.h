#pragma once
// Where in a PDF the targets of its links are.

#include <map>
#include <string>

namespace cli {

// Of a PDF as Chromium makes it: its catalogue names the targets. As report::PageNumbers has them;
// empty if it cannot be told.
std::map<std::string, int> places_in_pdf(const std::string& pdf);

}  // namespace cli
