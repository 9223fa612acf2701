#pragma once
// The changes of a revision as HTML.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns the section with the id "revision"; "" without a revision.
std::string html_revision(const Texts& t, const Document& document);
// Returns its title: "Against main.json"; finished HTML.
std::string html_revision_title(const Texts& t, const Document& document);

}  // namespace report
