#pragma once
// The page of html.h as a PDF: another program prints it.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <functional>
#include <memory>
#include <string>

namespace report {

// Prints HTML, however it does that.
class PagePrinter {
 public:
  PagePrinter() = default;
  PagePrinter(const PagePrinter&) = delete;
  PagePrinter& operator=(const PagePrinter&) = delete;
  virtual ~PagePrinter() = default;

  // write_page: writes HTML. The PDF. Throws WriteFailure, and what write_page throws.
  virtual std::string print(const std::function<void(Sink&)>& write_page) = 0;
  // On which pages of a PDF that it made the targets of links are; empty if it cannot tell.
  virtual PageNumbers places_in(const std::string& pdf) = 0;
};

// Same document and same printer, same bytes. Longer ones are printed twice: the contents name
// pages that are known only then. printer: null: what it would print, as HTML.
std::unique_ptr<FormatWriter> pdf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, const PageStyle& style,
                                         PagePrinter* printer);

// With the same day for the two times at which a PDF says it was made and changed: reports tell
// times only where somebody asks for one. As long as it was, so that all offsets in it hold.
std::string with_fixed_dates(std::string pdf);

// With the elements of its structure ("node00000113") counted from 1 in the order of their numbers:
// Chromium counts everything it ever made, which is one more now and then. As long as it was.
std::string with_counted_ids(std::string pdf);

// A PDF of Chromium without what chance puts into it: both of the above.
std::string reproducible_pdf(std::string pdf);

}  // namespace report
