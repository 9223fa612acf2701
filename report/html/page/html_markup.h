#pragma once
// Pieces every part of the HTML report is made of. Text from files goes through escape_html,
// always.

#include "report/document/document.h"
#include "report/text/text_numbers.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace report {

// Our own numbers with a typographic minus sign.
std::string with_minus(std::string text);

// Symbol and word, coloured.
// counts: false of advice and of what is waived, which must not look as if it decided.
std::string badge(const Texts& t, rules::Verdict verdict, bool counts = true);

// That of a requirement; of advice that is not kept to it is grey, with words of its own.
std::string badge_of(const Texts& t, const rules::Requirement& requirement, rules::Verdict verdict,
                     bool counts = true);

// What a room came to: the badge of its gravest verdict, or plain words where there is none.
std::string outcome_badge(const Texts& t, rules::Outcome outcome);

// Link target of a plane: by position, since ids may hold anything.
struct PlaneIndex {
  std::size_t project = 0, space = 0, plane = 0;
};
std::string plane_anchor(PlaneIndex index);

std::string space_anchor(std::size_t project, std::size_t space);

// Address of a plane: in this page, or in the page of html_pages.h that holds it. folder: of those
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

// A table that can be scrolled sideways on narrow screens; label: escaped words for screen readers.
std::string scroll_box(std::string_view label, std::string_view table);
std::string scroll_box_start(std::string_view label);
inline constexpr const char* kScrollBoxEnd = "</div>\n";

// "<tr><th scope="row">...</th><td class="num">...</td></tr>" of finished HTML.
std::string fact(std::string_view name, std::string_view value);

}  // namespace report
