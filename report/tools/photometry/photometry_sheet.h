#pragma once
// The data sheet of a luminaire's photometry, one page: figures, polar diagram, light cone,
// luminances and the table of glare ratings.

#include "report/html/page/print_pages.h"
#include "report/text/texts.h"
#include "report/tools/photometry/photometry.h"

#include <string>

namespace cli {

// Returns a page without a script, in the style of the other pages. file: readable. sha256: of the
// photometry file.
std::string render_photometry_sheet(const report::Texts& t, const PhotometryFile& file,
                                    const std::string& sha256, report::Paper paper);

}  // namespace cli
