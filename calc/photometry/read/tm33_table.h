#pragma once
// Reads the intensity table of a TM-33 emitter.

#include "calc/base/diagnostics.h"
#include "calc/base/xml_document.h"
#include "calc/photometry/read/web_assembly.h"

#include <optional>

namespace calc {

struct Tm33Table {
  FileTable table;          // in cd, of one emitter, times the multiplier
  double multiplier = 1.0;  // > 0
  std::optional<bool> is_absolute;
  std::optional<double> stated_flux_lm;
  SourceLocation where;
};

// Reads LuminousData/LuminousIntensity with IntData h v (TM-33-18 and -23), LuminousData or
// IntensityDistribution with IntensityData horz vert (files in circulation). root: of the file;
// emitter: one of its <Emitter> elements. The points may come in any order and must fill a grid of
// horizontal by vertical angles. Empty if and only if an error was reported: other metrics
// (radiant, photon, spectral), photometry of type A or B, points missing or given twice, angles
// that do not fit the symmetry.
std::optional<Tm33Table> read_tm33_table(const XmlElement& root, const XmlElement& emitter,
                                         Diagnostics& diagnostics);

}  // namespace calc
