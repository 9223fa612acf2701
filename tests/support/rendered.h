#pragma once
// A whole document in a format, in memory.

#include "report/formats/format.h"
#include "report/html/page/html.h"
#include "report/html/page/html_pages.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// format: after --format.
inline std::string rendered(std::string_view format, const Document& document,
                            const FormatStyle& style = {}) {
  return find_format(format)->render(document, style);
}

// The same HTML as several pages: one with everything that counts, which links to those in
// `folder`, ...
inline std::string rendered_index(const Document& document, const std::string& folder,
                                  const Texts& t = {}) {
  return render_whole(document, [&](const DocumentFrame& frame, const SpillPlace& place) {
    return html_writer(frame, place, t, folder);
  });
}
// ... and those of all rooms, which link back to `index`.
inline std::vector<HtmlPage> pages_of(const Document& document) {
  std::vector<HtmlPage> pages;
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const std::vector<HtmlPage> more = html_pages(document.projects[p], p);
    pages.insert(pages.end(), more.begin(), more.end());
  }
  return pages;
}
inline std::string rendered_page(const Document& document, const HtmlPage& page,
                                 const std::string& index, const Texts& t = {}) {
  return render_html_page(document.provenance, document.projects.at(page.project), page, index, t);
}

}  // namespace report
