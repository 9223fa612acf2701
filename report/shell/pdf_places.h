#pragma once
// Where in a PDF the targets of its links are.

#include "report/html/page_style.h"

#include <string>

namespace cli {

// Of a PDF as Chromium makes it: its catalogue names the targets. Empty if it cannot be told.
report::PageNumbers places_in_pdf(const std::string& pdf);

}  // namespace cli
