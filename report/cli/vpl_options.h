#pragma once
// The options of `luxgate vpl`.

#include "calc/radiosity/settings.h"

#include <string>
#include <vector>

namespace cli {

struct ValueOption;

struct VplOptions {
  std::string project, output;
  std::string space;                                     // "" = the only one
  calc::RadiositySettings radiosity = first_settings();  // max_paths: what is traced

  static calc::RadiositySettings first_settings() {
    calc::RadiositySettings settings;
    settings.max_paths = 4096;
    return settings;
  }
};

std::vector<ValueOption> vpl_value_options(VplOptions& options);
// "" = nothing is wrong.
std::string vpl_contradiction(const VplOptions& options);

}  // namespace cli
