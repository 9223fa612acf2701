#pragma once
// Pieces that all parts of the HTML report use. Text from files goes through escape_html, always.

#include "report/document/document.h"
#include "report/text/text_numbers.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace report {

// Returns our own numbers with a typographic minus sign.
std::string with_minus(std::string text);

// Returns symbol and word, coloured. counts: false for advice and waived findings, which must not
// look as if they decided.
std::string badge(const Texts& t, rules::Verdict verdict, bool counts = true);

// Returns the badge of a requirement; advice that is not followed is grey, with its own words.
std::string badge_of(const Texts& t, const rules::Requirement& requirement, rules::Verdict verdict,
                     bool counts = true);

// Returns the badge of a room's gravest verdict, or plain words if there is none.
std::string outcome_badge(const Texts& t, rules::Outcome outcome);

// The link target of a plane: by position, because ids may contain anything.
struct PlaneIndex {
  std::size_t project = 0, space = 0, plane = 0;
};
std::string plane_anchor(PlaneIndex index);

std::string space_anchor(std::size_t project, std::size_t space);

// Returns the address of a plane: in this page, or in its page of html_pages.h. folder: of those
// pages; "" = everything is in this page.
std::string plane_href(PlaneIndex index, std::string_view folder);
std::string page_name(PlaneIndex index);

// Calls visit(index, project, space, plane) for every plane in document order.
template <class Visit>
void for_each_plane(const Document& document, Visit visit) {
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const ProjectPart& project = document.projects[p];
    for (std::size_t s = 0; s < project.spaces.size(); ++s) {
      const SpacePart& space = project.spaces[s];
      for (std::size_t k = 0; k < space.planes.size(); ++k) {
        visit(PlaneIndex{p, s, k}, project, space, space.planes[k]);
      }
    }
  }
}

// Returns a table that can be scrolled sideways on narrow screens; label: escaped words for screen
// readers.
std::string scroll_box(std::string_view label, std::string_view table);
std::string scroll_box_start(std::string_view label);
inline constexpr const char* kScrollBoxEnd = "</div>\n";

// Returns "<tr><th scope="row">...</th><td class="num">...</td></tr>" from finished HTML.
std::string fact(std::string_view name, std::string_view value);

}  // namespace report
