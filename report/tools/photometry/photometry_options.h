#pragma once
// The options of `luxgate photometry`.

#include "report/shell/command/command.h"
#include "report/shell/output/page_options.h"

#include <string>
#include <vector>

namespace cli {

enum class PhotometryFormat { text, json, csv };
struct PhotometryOptions {
  std::vector<std::string> files;
  PhotometryFormat format = PhotometryFormat::text;
  std::string polar_file, polar_folder;  // "" = none; the former for one file only
  std::string convert_file;              // "" = none; for one file only
  std::string sheet_file;                // "" = none; for one file only
  PageChoice page;                       // of the sheet
  bool compare = false;                  // exactly two files
  bool strict = false;                   // warnings give exit code 1
  int lamp_set = 0;                      // of EULUMDAT, from 1; 0 = not chosen
  std::string variant, emitter;          // of GLDF and TM-33; "" = not chosen
  bool quiet = false;
  ColorChoice color = ColorChoice::automatic;
};

Command photometry_syntax(PhotometryOptions& options);

}  // namespace cli
