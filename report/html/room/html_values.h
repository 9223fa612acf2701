#pragma once
// A plane's values as tables: on the screen beside the plane, on paper in an annex.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns a table that can be unfolded on the screen; a list of points is printed, too.
std::string html_values(const Texts& t, const SpacePart& space, const PlanePart& plane);

struct AnnexPlane {
  const SpacePart* space = nullptr;
  const PlanePart* plane = nullptr;

  bool has_table() const;  // lists of points have none: they are printed with the plane
};

// Returns a section for print only, or only words if its tables would be too long and were not
// requested; "" if there are no such values. id: of its heading.
std::string html_annex(const Texts& t, const std::vector<AnnexPlane>& planes, Annex annex,
                       std::string_view id);

}  // namespace report
