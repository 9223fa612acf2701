#pragma once
// The options of `luxgate vpl`.

#include "calc/radiosity/gather/settings.h"
#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

struct VplOptions {
  std::string project;
  std::string output;  // the vertices, "" = only the picture
  std::string view;    // a picture of them, .png or .exr; "" = none
  int gl_device = -1;  // that draws it, as of `luxgate devices`; -1 = what draws sooner
  std::string space;   // "" = the only one
  std::vector<std::string> allowed;                      // see --allow
  calc::RadiositySettings radiosity = first_settings();  // max_paths: what is traced

  static calc::RadiositySettings first_settings() {
    calc::RadiositySettings settings;
    settings.max_paths = 4096;
    return settings;
  }
};

Command vpl_syntax(VplOptions& options);
bool is_exr(const std::string& file);  // by its name

}  // namespace cli
