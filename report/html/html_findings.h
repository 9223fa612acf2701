#pragma once
// Requirements and verdicts as HTML: the verdict at the top, what needs attention, the summary, and
// one plane's table.

#include "report/document/document.h"
#include "report/html/html_markup.h"

#include <string>

namespace report {

std::string html_verdict_banner(const Texts& t, const Document& document);
// Everything that does not pass, gravest first; "" when all is well.
// folder: of the planes' pages, see plane_href().
std::string html_attention(const Texts& t, const Document& document, const std::string& folder);
// Building, room, plane; sorted and filtered by the page's script.
std::string html_summary(const Texts& t, const Document& document, const std::string& folder);
// The requirements of one plane; "" when it has none.
std::string html_plane_findings(const Texts& t, const PlanePart& plane);

}  // namespace report
