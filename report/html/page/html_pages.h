#pragma once
// The report as several pages: a main page with everything that counts, and the planes room by
// room.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Some planes of one room, at most kPlanesPerPage.
struct HtmlPage {
  std::string name;  // "p1s2.html", "p1s2-3.html"
  std::size_t project = 0, space = 0;
  std::size_t first_plane = 0, planes = 0;
};
inline constexpr std::size_t kPlanesPerPage = 24;

// Returns the pages in document order; a room without planes has a page, too. index: of the
// project.
std::vector<HtmlPage> html_pages(const ProjectPart& project, std::size_t index);

// Returns a page with a link back to `index` (a relative address from the page's folder).
std::string render_html_page(const Provenance& provenance, const ProjectPart& project,
                             const HtmlPage& page, const std::string& index, const Texts& t = {},
                             const PageStyle& style = {});

// Returns a file name for a relative address: everything but letters, digits and "-._~" as %XX.
// [RFC 3986, section 2]
std::string url_name(const std::string& file_name);

}  // namespace report
