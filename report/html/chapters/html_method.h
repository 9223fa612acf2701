#pragma once
// Explains how values are calculated and what the words mean, for readers who are not lighting
// engineers.

#include "report/document/document.h"
#include "report/html/page/html_footnotes.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Explanations that the rooms leave to this section.
struct ClientMethod {
  bool has_pictures = false;
  bool has_rendered = false;  // rendered views among them
};

// A section, with what is said once of numbers of one public source. client: of the document for
// clients, else null.
std::string html_method(const Texts& t, const DocumentEnd& end, const Footnotes& footnotes,
                        const ClientMethod* client = nullptr);

}  // namespace report
