#pragma once
// The options of `luxgate vpl`.

#include "calc/radiosity/settings.h"

#include <string>
#include <vector>

namespace cli {

struct ValueOption;

struct VplOptions {
  std::string project;
  std::string output;  // the vertices, "" = only the picture
  std::string view;    // a picture of them, .png or .exr; "" = none
  int gl_device = -1;  // that draws it, as of `luxgate devices`; -1 = the first that is usable
  std::string space;   // "" = the only one
  calc::RadiositySettings radiosity = first_settings();  // max_paths: what is traced

  static calc::RadiositySettings first_settings() {
    calc::RadiositySettings settings;
    settings.max_paths = 4096;
    return settings;
  }
};

std::vector<ValueOption> vpl_value_options(VplOptions& options);
bool is_exr(const std::string& file);  // by its name
// "" = nothing is wrong.
std::string vpl_contradiction(const VplOptions& options);

}  // namespace cli
