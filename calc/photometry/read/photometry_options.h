#pragma once
// Options that choose among the lights of a photometry file.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/ies_tilt.h"

#include <string>
#include <string_view>
#include <vector>

namespace calc {

// The value of PhotometryOptions::emitter for all emitters of a GLDF variant that shine together,
// unless an emitter has this id.
inline constexpr std::string_view kAllEmitters = "all";

struct PhotometryOptions {
  int lamp_set = 0;       // EULUMDAT: 1-based; 0 = the first, with a warning if there are others
  std::string variant{};  // GLDF: id; empty = not chosen
  std::string emitter{};  // GLDF: id, or id#n for the n-th of its fittings, several of them with
                          // blanks between, or kAllEmitters; TM-33: id, description or 1-based
                          // number; empty = not chosen
  SourceLocation
      where{};  // where the choice was written; empty = mistakes are reported at the file
  CompanionReader read_companion{};  // LM-63: for TILT=<file>, which is refused without it
};

// A choice among several: its text in an option, and a description.
struct PhotometryChoice {
  std::string id;
  std::string label;  // may be empty
};

// Returns "a (words), b (words)": at most ten, then "...".
std::string list_choices(const std::vector<PhotometryChoice>& choices);

// Returns where to report a mistake in the options for the photometry file `name`.
SourceLocation place_of_choice(const PhotometryOptions& options, const std::string& name);

// The options that a format has.
struct KnownOptions {
  bool lamp_set = false, variant = false, emitter = false;
};

// Returns false, with an error for each, if options are given that the format does not have.
// format: in words, "an LM-63 file".
bool check_options(const PhotometryOptions& options, const KnownOptions& known,
                   std::string_view format, const std::string& name, Diagnostics& diagnostics);

}  // namespace calc
