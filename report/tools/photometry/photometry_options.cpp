#include "report/tools/photometry/photometry_options.h"

#include "calc/base/text.h"
#include "calc/photometry/read/photometry_file.h"
#include "report/shell/command/option_values.h"
#include "report/shell/output/output_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace cli {
namespace {

bool ends_with_one_of(std::string text, const std::vector<std::string_view>& endings) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return std::string_view(text).ends_with(ending);
  });
}

// "" = nothing is wrong.
std::string photometry_contradiction(const PhotometryOptions& photometry) {
  const std::size_t files = photometry.files.size();
  const auto one_file = [&](const char* name, const std::string& value,
                            const std::vector<std::string_view>& endings) -> std::string {
    if (value.empty()) return "";
    if (files != 1) return fmt::format("{} is for one FILE; found {}", name, files);
    if (ends_with_one_of(value, endings)) return "";
    return fmt::format("{}: '{}' must end with {}", name, value, calc::join_choices(endings));
  };
  std::string problem = one_file("--polar", photometry.polar_file, {".svg", ".png"});
  if (problem.empty()) problem = one_file("--convert", photometry.convert_file, {".ies", ".ldt"});
  if (problem.empty()) problem = one_file("--sheet", photometry.sheet_file, {".html", ".pdf"});
  if (!problem.empty()) return problem;
  if (!photometry.compare) return "";
  if (files != 2) return fmt::format("--compare needs two FILEs; found {}", files);
  return photometry.format == PhotometryFormat::csv ? "--compare has no CSV form; use --json" : "";
}

ValueParser chosen(PhotometryFormat& target, PhotometryFormat format) {
  return [&target, format](const std::string&) {
    target = format;
    return std::string();
  };
}

}  // namespace

Command photometry_syntax(PhotometryOptions& options) {
  std::string formats;
  for (const calc::PhotometryFormatInfo& format : calc::photometry_formats()) {
    formats += (formats.empty() ? "" : ", ") + std::string(format.name);
  }
  Command command{"photometry",
                  "Show, check, convert, draw and compare photometry files; data sheets"};
  command.places = {
      {"files", "FILE", fmt::format("Photometry files ({})", formats), &options.files}};
  command.options = {
      {"--format", "KIND", "Choose the output: text, csv (one line per file) or json; default text",
       choice<PhotometryFormat>(options.format, {{"text", PhotometryFormat::text},
                                                 {"csv", PhotometryFormat::csv},
                                                 {"json", PhotometryFormat::json}})},
      {"--json", "", "Print JSON: the same as --format json",
       chosen(options.format, PhotometryFormat::json)},
      {"--csv",
       "",
       "Print CSV: the same as --format csv",
       chosen(options.format, PhotometryFormat::csv),
       false,
       {"--json"}},
      {"--polar", "OUT.svg|.png", "Draw the polar diagram of one file, as SVG or PNG",
       any_text(options.polar_file)},
      {"--polar-dir", "FOLDER",
       "Draw the polar diagram of every file into this folder, as FILE.svg; made if needed",
       any_text(options.polar_folder)},
      {"--convert", "OUT.ies|.ldt",
       "Convert one file to LM-63-2002 (.ies) or EULUMDAT (.ldt). It is never written over an "
       "input",
       any_text(options.convert_file)},
      {"--sheet", "OUT.html|.pdf",
       "Write a data sheet of one file, as HTML or PDF. It has figures, a polar diagram, a light "
       "cone, luminances and a UGR table. Chromium prints the PDF",
       any_text(options.sheet_file)},
  };
  add(command.options, page_options(options.page, "the data sheet"));
  add(command.options,
      {{"--compare", "",
        "Compare two files. The output says whether the light is the same, and after which quarter "
        "turn",
        &options.compare},
       {"--lamp-set", "N", "Use the N-th lamp set of an EULUMDAT file; default the first",
        whole_number(options.lamp_set, 1, 1'000'000)},
       {"--variant", "ID", "Use the light of this variant of a GLDF file",
        some_text(options.variant)},
       {"--emitter", "ID",
        "Use this emitter of a GLDF or TM-33 file. GLDF: ID, ID#2 for its second light, or all for "
        "those that shine together. TM-33: id, description or number",
        some_text(options.emitter)},
       {"--strict", "", "End with exit code 1 if there is a warning", &options.strict},
       color_option(options.color),
       quiet_option(options.quiet)});
  command.notes = "Other files are shown even if one cannot be read.";
  command.examples = {
      {"luxgate photometry panel.ies --sheet panel.html", "A data sheet"},
      {"luxgate photometry old.ldt new.ies --compare", "Whether two files are the same light"},
      {"luxgate photometry panel.ies --convert panel.ldt", "As EULUMDAT"}};
  command.exit_codes = {{0, "all files are readable"},
                        {1, "there are warnings, with --strict"},
                        {2, "an unreadable file or another error"}};
  command.most_used = {"--json",  "--csv",     "--polar",  "--convert", "--sheet",
                       "--paper", "--compare", "--strict", "--color",   "--quiet"};
  command.complete = [&options](const Environment&) { return photometry_contradiction(options); };
  return command;
}

}  // namespace cli
