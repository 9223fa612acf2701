#pragma once
// Finds the pages of link targets in a PDF.

#include <map>
#include <string>

namespace cli {

// Returns report::PageNumbers of a PDF made by Chromium, whose catalogue names the targets; empty
// if they cannot be found.
std::map<std::string, int> places_in_pdf(const std::string& pdf);

}  // namespace cli
