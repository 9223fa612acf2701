#pragma once
// The document as one HTML file: no script, no external resource, readable in print, in dark mode
// and by screen readers.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>
#include <string>

namespace report {

// Returns HTML5 that is also well-formed XML. Time of day and phase times appear only if the
// document holds them; same document, same bytes.
std::string render_html(const Document& document, const Texts& t = {});
// folder: a relative address, without a slash at its end, of the pages of html_pages.h, to which
// verdicts, summary, luminaires, calculation and provenance then link; or "" for one page with
// everything. numbers: page numbers on paper for the contents, read by each finish(), which may be
// called again; null or empty: none.
std::unique_ptr<FormatWriter> html_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const Texts& t, const std::string& folder = "",
                                          const PageStyle& style = {},
                                          const PageNumbers* numbers = nullptr);

}  // namespace report
