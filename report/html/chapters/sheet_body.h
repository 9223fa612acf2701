#pragma once
// The contents of the data sheet of a luminaire's photometry: figures, polar diagram, light cone,
// luminances, the table of glare ratings, intensities.

#include "calc/photometry/web.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// The light that a sheet shows, with facts that the light does not include.
struct SheetLight {
  calc::PhotometricWeb web;
  double flux_lm = 0.0;
  double power_w = 0.0;           // 0 = not stated
  std::size_t emitters = 1;       // several: the web is their sum, and its opening says nothing
  std::string file_name, sha256;  // of the photometry file
};

// Returns the luminaire name in the file, or else the file's name; not escaped.
std::string sheet_name(const SheetLight& light);

// A part of a page, well-formed. heading: the element of the heading within it ("h2"). more_facts:
// rows of fact() after those of the product. has_intensities: adds the table of intensities; of
// more than kMostSheetPlanes x kMostSheetAngles values it shows a part and says so.
struct SheetParts {
  const char* heading = "h2";
  std::string more_facts = {};
  bool has_intensities = false;
};
inline constexpr std::size_t kMostSheetPlanes = 13, kMostSheetAngles = 37;
std::string sheet_body(const Texts& t, const SheetLight& light, const SheetParts& parts = {});

// Returns the style rules for pages with such parts.
const char* sheet_style();

}  // namespace report
