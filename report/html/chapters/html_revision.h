#pragma once
// What a revision did, as HTML.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// "" without a revision. Its id is "revision".
std::string html_revision(const Texts& t, const Document& document);
// Its title: "Against main.json"; finished HTML.
std::string html_revision_title(const Texts& t, const Document& document);

}  // namespace report
