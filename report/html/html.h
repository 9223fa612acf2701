#pragma once
// The document as one HTML file: no script, no external resource, readable in print, in the dark
// and by screen readers.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// HTML5 that is well-formed XML as well. Time of day and phase times appear only where the document
// holds them; same document, same bytes.
std::string render_html(const Document& document, const Texts& t = {});

}  // namespace report
