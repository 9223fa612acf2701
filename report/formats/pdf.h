#pragma once
// Writes the page of html.h as a PDF: another program prints it.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <functional>
#include <memory>
#include <string>

namespace report {

// Prints HTML by any means.
class PagePrinter {
 public:
  PagePrinter() = default;
  PagePrinter(const PagePrinter&) = delete;
  PagePrinter& operator=(const PagePrinter&) = delete;
  virtual ~PagePrinter() = default;

  // Returns the PDF. write_page: writes HTML. Throws WriteFailure, and what write_page throws.
  virtual std::string print(const std::function<void(Sink&)>& write_page) = 0;
  // Returns the pages of link targets in a PDF that it made; empty if it cannot tell.
  virtual PageNumbers places_in(const std::string& pdf) = 0;
};

// Same document and same printer, same bytes. Longer documents are printed twice, because their
// contents name pages that are known only then. printer: null: writes the HTML to be printed.
std::unique_ptr<FormatWriter> pdf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, const PageStyle& style,
                                         PagePrinter* printer);

// Sets the two times at which a PDF was made and changed to the same day: reports show times only
// on request. The length stays, so that all offsets remain valid.
std::string with_fixed_dates(std::string pdf);

// Renumbers the elements of its structure ("node00000113") from 1 in the order of their numbers,
// because Chromium's counter sometimes includes more elements. The length stays.
std::string with_counted_ids(std::string pdf);

// Returns a PDF of Chromium without random parts: applies both functions above.
std::string reproducible_pdf(std::string pdf);

}  // namespace report
