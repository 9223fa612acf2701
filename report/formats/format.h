#pragma once
// All formats of a document. A new format is a row here and a pair of files that renders it.

#include "report/document/document.h"
#include "report/formats/console.h"
#include "report/formats/pdf.h"
#include "report/html/page/page_style.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace report {

// The style that formats for people need besides the document.
struct FormatStyle {
  TextOptions terminal;            // of `text`
  Texts texts = {};                // of `text`, `html` and `markdown`
  PageStyle page = {};             // of `html` and `pdf`
  PagePrinter* printer = nullptr;  // of `pdf`; see pdf_writer()
};

struct Format {
  std::string_view name;       // after --format
  std::string_view remark;     // what the help says of it; "" = nothing
  std::string_view file_name;  // in the folder of --output; "" = not there
  std::unique_ptr<FormatWriter> (*writer)(const DocumentFrame&, const SpillPlace&,
                                          const FormatStyle&);
  bool is_html = false;     // has pictures of rooms, and may be an index with pages
  bool is_printed = false;  // is HTML as one page, which needs a printer

  // Renders a whole document.
  std::string render(const Document& document, const FormatStyle& style) const;
};

// Returns the formats in the order of the help; `text` is the first.
std::span<const Format> formats();
// Returns the format of this name; null if there is none.
const Format* find_format(std::string_view name);

}  // namespace report
