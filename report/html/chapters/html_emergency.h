#pragma once
// Emergency lighting in one table: the results at the end of the battery's duration.

#include "report/document/document.h"
#include "report/html/page/html_footnotes.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the table; "" if nothing of the kind is required. index: of the project. folder: see
// plane_href().
std::string html_emergency(const Texts& t, const ProjectPart& project, std::size_t index,
                           const std::string& folder, const Footnotes& footnotes);

}  // namespace report
