#pragma once
// The frame of pages without a script: those of tools, data sheets, and documents for clients.

#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <string>

namespace report {

struct ToolPage {
  std::string title;    // escaped; of the window and of h1
  std::string eyebrow;  // what kind of page it is, plain text
  std::string style;    // of this kind of page alone, behind the style sheet that all share
  std::string foot;     // what runs along at the foot of every page on paper, plain text
  Paper paper = Paper::a4;
  std::string head = {};   // what runs along at the head, plain text; "" = program and eyebrow
  bool has_cover = false;  // the header begins with a <div class="cover">, which it has to close
};

// Returns the start up to the heading in the open <header>; the next part closes that and begins
// <main id="main">.
std::string tool_page_start(const Texts& t, const ToolPage& page);
// Returns the end from the end of <main>; footer: finished HTML.
std::string tool_page_end(const std::string& footer);

}  // namespace report
