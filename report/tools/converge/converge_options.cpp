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
        return fmt::format("'{}' is named twice", list[i]);
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
       "Any of core (what 'check' does), gpu (what 'check --backend gpu' does), path-tracing,\n"
       "instant-radiosity, clamped-instant-radiosity and shadow-map:N (instant radiosity that\n"
       "sees by shadow maps with N texels along a cube's edge, 16 to 2048, a power of two; may\n"
       "be there with several N), with commas; gpu and shadow-map need OpenGL; default\n"
       "core,instant-radiosity",
       method_list(options.methods)},
      {"--reference", "own|FILE.csv",
       "What errors are measured against: a long run of the core with other random numbers, whose\n"
       "own error is subtracted, or a table with a line for every point: plane,column,row,lx or\n"
       "x,y,z,lx (m, lx, initial) and perhaps error_lx, its standard error; default own",
       ValueParser(some_text(options.reference), {"own"})},
      {"--reference-paths", "N",
       "Light paths of each of the 64 replicates of 'own'; default twice --max-paths",
       power_of_two(options.reference_paths, 16, calc::kMostPaths)},
      {"--part", "NAME", "total, or indirect: errors of the reflected light alone; default total",
       choice<bool>(options.is_indirect, {{"total", false}, {"indirect", true}})},
      {"--min-paths", "N", "First step of the ladder, per replicate, a power of two; default 64",
       power_of_two(options.min_paths, 16, calc::kMostPaths)},
      {"--max-paths", "N", "Last step; every step takes twice as many; default 8192",
       power_of_two(options.max_paths, 16, calc::kMostPaths)},
      {"--replicates", "N", "Replicates of a run, which is their mean, 4 to 64; default 16",
       whole_number(options.replicates, calc::kFewestReplicates, calc::kMostReplicates)},
      {"--seeds", "N", "Runs at every step, with different random numbers; default 5",
       whole_number(options.seeds, 1, 1000)},
      {"--seed", "N", "Seed of the first of them; default 1",
       whole_number(options.seed, 0, UINT64_MAX - 1000)},
      {"--clamp", "B", "Largest geometry term of clamped-instant-radiosity, 1/m2; default 1",
       positive_number(options.clamp_per_m2)},
      space_option(options.space),
      {"--plane", "ID", "Only this plane; may be repeated; default all of the space",
       one_more(options.planes), true},
      rules_option(options.rule_files),
      allow_option(options.allowed),
      jobs_option(options.jobs),
      {"--gl-device", "N",
       "OpenGL device of 'luxgate devices' for gpu and shadow-map; default the first that works,\n"
       "hardware before software",
       whole_number(options.gl_device, 0, 1000)}};
  add(command.options,
      data_format_options(options.outputs,
                          "text, csv, json or html, to FILE or (one kind only) to standard output, "
                          "where text goes\n"
                          "unless another kind does; may be repeated"));
  add(command.options, page_options(options.page, "html"));
  add(command.options, {quiet_option(options.quiet)});
  command.notes = "Times depend on the machine and on what else it does; errors do not.";
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
