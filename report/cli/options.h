#pragma once
// The command line as a value. Only options.cpp and rules_options.cpp include CLI11.

#include "calc/radiosity/settings.h"
#include "report/text/texts.h"
#include "report/tools/compare/compare_options.h"
#include "report/tools/converge/converge_options.h"
#include "report/tools/export/export_options.h"
#include "report/tools/rules/rules_options.h"
#include "report/tools/selftest/selftest_options.h"
#include "report/tools/vpl/vpl_options.h"
#include "rules/catalogue/goal.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

enum class Command {
  check,
  report,
  plan,
  validate,
  vpl,
  converge,
  selftest,
  compare,
  export_scene,
  photometry,
  geometry,
  rules,
  explain,
  schema,
  init,
  devices,
  version
};
// How results are written; see report/.
enum class FormatKind {
  text,
  csv,
  points_csv,
  json,
  html,
  junit,
  sarif,
  sarif_all,
  github,
  gitlab,
  markdown
};
enum class Backend { automatic, cpu, gpu };
// Which parts of the calculation a gpu does.
struct GpuStages {
  bool light_paths = true, connections = true, near_field = true;
  friend bool operator==(const GpuStages&, const GpuStages&) = default;
};
enum class ColorChoice { automatic, always, never };
enum class DecimalSign { of_language, point, comma };

struct OutputFormat {
  FormatKind kind = FormatKind::text;
  std::string file;  // "" = standard output; at most one format goes there
};

enum class PhotometryFormat { text, json, csv };
struct PhotometryOptions {
  std::vector<std::string> files;
  PhotometryFormat format = PhotometryFormat::text;
  std::string polar_file, polar_folder;  // "" = none; the former for one file only
  std::string convert_file;              // "" = none; for one file only
  bool compare = false;                  // exactly two files
  bool strict = false;                   // warnings give exit code 1
  int lamp_set = 0;                      // of EULUMDAT, from 1; 0 = not chosen
  std::string variant, emitter;          // of GLDF and TM-33; "" = not chosen
};

struct Options {
  Command command = Command::check;
  std::vector<std::string> projects;
  std::vector<std::string> rule_files;

  std::string result_file;  // of 'report'

  std::vector<OutputFormat> formats;
  std::string output_folder;  // "" = none
  bool images = false;
  bool html_split = false;                                // HTML as an index and a page per room
  report::Language language = report::Language::english;  // of HTML, Markdown and text
  DecimalSign decimal = DecimalSign::of_language;         // of the same formats
  bool pictures = true;   // of rooms, in HTML and with --images, where OpenGL can draw
  bool redact = false;    // see report::redact()
  std::string timestamp;  // "2024-05-01T12:00:00Z" or ""
  bool timing = false;
  bool explain_cost = false;
  bool quiet = false;
  ColorChoice color = ColorChoice::automatic;

  rules::Goal goal = rules::Goal::verdict;
  double tolerance = 0.02;   // relative half-width aimed at where nothing is decided, in (0, 1)
  double confidence = 0.95;  // in (0.5, 1)
  calc::RadiositySettings radiosity;
  Backend backend = Backend::automatic;
  int gl_device = -1;                   // as `luxgate devices` numbers them; -1 = not given
  std::optional<GpuStages> gpu_stages;  // empty: not given, all

  bool by_luminaire = false;  // light of single luminaires is kept apart and reported

  std::string vpl_file;  // light vertices to take instead of tracing; "" = none

  VplOptions vpl;
  ConvergeOptions converge;
  SelftestOptions selftest;
  CompareOptions compare;
  ExportOptions export_scene;
  bool plan_as_json = false;
  PhotometryOptions photometry;
  RulesOptions rules_command;
  std::vector<std::string> geometry_files;
  std::string mesh_units, mesh_up;  // of mesh files that do not say; "" = not given
  bool geometry_as_json = false;
  bool strict = false;         // warnings of 'geometry' count
  bool result_schema = false;  // 'schema' prints that of results
  std::string init_folder = ".";
  bool devices_as_json = false;
  bool version_as_json = false;
};

// How reports for people are worded.
report::Texts report_texts(const Options& options);

// Either options, or what to print and the exit code: 0 for --help, 2 for every usage error.
struct ParseResult {
  std::optional<Options> options;
  int exit_code = 0;
  std::string out, err;
};
// source_date_epoch: the environment variable's value, "" = not set.
ParseResult parse_options(int argc, const char* const* argv, const std::string& source_date_epoch);

// A command that makes the same numbers again: paths and every option that changes results, quoted
// for a shell. Options that do not (--jobs, --format, ...) are left out, so that reports do not
// depend on them.
std::string reproducible_command(const Options& options);

}  // namespace cli
