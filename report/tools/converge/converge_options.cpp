#include "report/tools/converge/converge_options.h"

#include "calc/radiosity/gather/settings.h"
#include "report/shell/command/option_values.h"
#include "report/tools/converge/converge_estimators.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace cli {
namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

ValueParser method_list(std::vector<std::string>& target) {
  const auto parse = [&target](const std::string& text) -> std::string {
    std::vector<std::string> list = split(text);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (std::string problem = estimator_problem(list[i]); !problem.empty()) return problem;
      if (std::find(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(i), list[i]) !=
          list.begin() + static_cast<std::ptrdiff_t>(i)) {
        return fmt::format("'{}' is given twice", list[i]);
      }
    }
    target = std::move(list);
    return "";
  };
  const std::vector<std::string_view> names = estimator_names();
  return {parse, {names.begin(), names.end()}};
}

// "" = nothing is wrong.
std::string converge_contradiction(const ConvergeOptions& options) {
  if (options.max_paths < options.min_paths) {
    return fmt::format("--max-paths {} is less than --min-paths {}", options.max_paths,
                       options.min_paths);
  }
  if (options.gl_device >= 0 &&
      std::none_of(options.methods.begin(), options.methods.end(), needs_opengl)) {
    return "--gl-device is for the methods gpu and shadow-map:N";
  }
  if (options.reference != "own" && options.reference_paths > 0) {
    return "--reference-paths is for --reference own";
  }
  return data_output_problem(options.outputs);
}

}  // namespace

Command converge_syntax(ConvergeOptions& options) {
  Command command{"converge", "Measure error against run time and rays, for several methods"};
  command.places = {project_place(options.project)};
  command.options = {
      {"--methods", "LIST",
       "Choose the methods to measure, a list with commas; default core,instant-radiosity. core is "
       "what 'check' does, gpu what 'check --backend gpu' does. Others are path-tracing, "
       "instant-radiosity, clamped-instant-radiosity and shadow-map:N. shadow-map:N is instant "
       "radiosity with shadow maps of N texels along an edge of the cube, a power of two from 16 "
       "to 2048; it may be listed with several N. gpu and shadow-map need OpenGL",
       method_list(options.methods)},
      {"--reference", "own|FILE.csv",
       "Choose what errors are measured against: own or a table; default own. own is a long run of "
       "the core with other random numbers; its own error is subtracted. A table has a line for "
       "every point: plane,column,row,lx or x,y,z,lx (m, lx, initial), and perhaps error_lx, its "
       "standard error",
       ValueParser(some_text(options.reference), {"own"})},
      {"--reference-paths", "N",
       "Use N light paths in each of the 64 replicates of 'own', a power of two; default twice "
       "--max-paths",
       power_of_two(options.reference_paths, 16, calc::kMostPaths)},
      {"--part", "NAME",
       "Choose which light is measured: total or indirect; default total. indirect is the "
       "reflected light alone",
       choice<bool>(options.is_indirect, {{"total", false}, {"indirect", true}})},
      {"--min-paths", "N", "Begin with N light paths per replicate, a power of two; default 64",
       power_of_two(options.min_paths, 16, calc::kMostPaths)},
      {"--max-paths", "N",
       "End with N light paths per replicate, a power of two; default 8192. Every step takes twice "
       "as many",
       power_of_two(options.max_paths, 16, calc::kMostPaths)},
      {"--replicates", "N", "Take the mean of N replicates for each run, 4 to 64; default 16",
       whole_number(options.replicates, calc::kFewestReplicates, calc::kMostReplicates)},
      {"--seeds", "N",
       "Run N times at every step, with different random numbers, 1 to 1000; default 5",
       whole_number(options.seeds, 1, 1000)},
      {"--seed", "N", "Set the seed of the first run; default 1",
       whole_number(options.seed, 0, UINT64_MAX - 1000)},
      {"--clamp", "B",
       "Set the largest geometry term of clamped-instant-radiosity, in 1/m2; default 1",
       positive_number(options.clamp_per_m2)},
      space_option(options.space),
      {"--plane", "ID", "Measure only this plane; repeatable; default all planes of the space",
       one_more(options.planes), true},
      rules_option(options.rule_files),
      allow_option(options.allowed),
      jobs_option(options.jobs),
      {"--gl-device", "N",
       "Choose the OpenGL device for gpu and shadow-map; default the first that works. Hardware "
       "comes before software. 'luxgate devices' lists them",
       whole_number(options.gl_device, 0, 1000)}};
  add(command.options,
      data_format_options(options.outputs,
                          "text, csv, json or html; default text. It is repeatable. Without FILE, "
                          "or with '-', it goes to standard output, which takes one kind only"));
  add(command.options, page_options(options.page, "html"));
  add(command.options, {quiet_option(options.quiet)});
  command.notes = "Times depend on the machine and its load. Errors do not.";
  command.examples = {
      {"luxgate converge shadow.xml --reference reference-shadow.csv --replicates 4 "
       "--methods core,instant-radiosity,shadow-map:16,shadow-map:64,shadow-map:256 "
       "--min-paths 16 --max-paths 4096 --seeds 3 --format html=shadow-maps.html",
       "In examples/08-error-against-time: error against the number of light vertices and the size "
       "of shadow maps, with the core in the same plots, and the time of each phase"}};
  command.exit_codes = {
      {kAllMet, "measured"}, {kNotJudged, "an error"}, {kInterrupted, "interrupted"}};
  command.most_used = {"--methods", "--reference", "--max-paths", "--seeds", "--space",
                       "--plane",   "--jobs",      "--format",    "--json"};
  command.complete = [&options](const Environment&) { return converge_contradiction(options); };
  return command;
}

}  // namespace cli
