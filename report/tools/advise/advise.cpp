#include "report/tools/advise/advise.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/project_xml.h"
#include "calc/store/memory_store.h"
#include "report/advice/find_advice.h"
#include "report/advice/level_solver.h"
#include "report/advice/written_levels.h"
#include "report/formats/write.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/output/data_output.h"
#include "report/shell/output/outputs.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/text/words.h"
#include "report/tools/advise/find_packages.h"
#include "report/tools/advise/find_places.h"
#include "report/tools/advise/written_rooms.h"
#include "report/tools/check/advice_checks.h"
#include "report/tools/check/check_options.h"
#include "report/tools/check/check_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kMostStoreBytes = std::size_t{1} << 30;

constexpr const char* kAdviseNotes =
    "Light is linear in the levels of dimming groups. After one calculation the levels of\n"
    "least power follow without new rays, for each scene and for full output. The search uses\n"
    "averages, smallest and largest values, values at points, Uo and Ud. Other quantities\n"
    "(glare, shares, gradients ...) take no part in it. The levels are then checked with\n"
    "other random numbers (--seed plus one), and the result of this check is printed with\n"
    "every requirement. Power is taken as proportional to the level. Luminaires without a\n"
    "group count as one more group.\n\n"
    "If no levels meet all requirements, the output names the requirements that exclude each\n"
    "other. It also says how much more light would meet them, if any does.\n\n"
    "--packages finds the lamp packages of least installed power that are sufficient, among\n"
    "all packages of the luminaire types of the project.\n\n"
    "--places, --turns and --surfaces follow light backwards from the points that lack it.\n"
    "Every free place of a ceiling grid, every turn of a luminaire and every surface is then\n"
    "known without a new calculation. The best three places and turns, as many together as\n"
    "needed, and each surface are checked in the same way.";

struct AdviseOptions {
  CheckOptions check;  // of one project
  std::string project;
  std::string scene, write_file;
  bool has_scene = false, packages = false, places = false, surfaces = false, turns = false;
  int steps = 100;
  CostUnit least = CostUnit::watt;
  std::vector<DataOutput> outputs;
};

// What counts, does not pass and hangs on no levels, such as the power by area of a room.
std::vector<std::string> not_met_besides(const Advice& advice, const report::ProjectPart& part) {
  std::set<const rules::Finding*> advised;
  for (const SceneAdvice& scene : advice.scenes) {
    for (const AdvisedRequirement& one : scene.requirements) {
      advised.insert(&finding_at(part, one.where));
    }
  }
  std::vector<std::string> words;
  for (const FindingPlace& where : counted_findings(part)) {
    const rules::Finding& finding = finding_at(part, where);
    if (advised.contains(&finding) || finding.verdict == rules::Verdict::pass) continue;
    words.push_back(
        fmt::format("{} ({})", finding_words(part, where), calc::name_of(finding.verdict)));
  }
  return words;
}

// "" or of which room with luminaires the energy of a year is not known.
std::string energy_problem(const report::ProjectPart& part) {
  for (const report::SpacePart& space : part.spaces) {
    if (space.luminaires.empty() || (space.energy && space.energy->problem.empty())) continue;
    return fmt::format(
        "the energy of a year is not known for '{}': {}", report::title_of(space.name, space.id),
        space.energy ? space.energy->problem.english() : "its use is not stated (<energy>)");
  }
  return "";
}

ExitCode exit_code_of_advice(const Advice& advice) {
  if (advice.packages && advice.packages->is_all_met) return kAllMet;
  bool is_met = advice.not_met_besides.empty();
  for (const SceneAdvice& scene : advice.scenes) {
    is_met = is_met && scene.outcome == AdviceOutcome::levels && scene.is_all_met();
  }
  return is_met ? kAllMet : kNotMet;
}

// "" or why the file cannot be the changed project.
std::string write_problem(const AdviseOptions& options) {
  namespace fs = std::filesystem;
  if (options.write_file.empty()) return "";
  std::error_code failure;
  // A relative name that does not exist yet would stay relative.
  const auto folder_of = [&](const std::string& file) {
    return fs::weakly_canonical(fs::absolute(file, failure), failure).parent_path();
  };
  const fs::path own = folder_of(options.project), its = folder_of(options.write_file);
  if (fs::path(options.write_file).filename() == "luxgate.toml") {
    return "--write: luxgate.toml has settings, and is not overwritten";
  }
  if (own != its) {
    return fmt::format(
        "--write: '{}' must be in the folder of the project, because its file names are relative "
        "to that folder",
        options.write_file);
  }
  if (path_identity(options.project) == path_identity(options.write_file)) {
    return fmt::format("--write: '{}' is the project itself, and is not overwritten",
                       options.write_file);
  }
  const std::string problem = writability(options.write_file);
  return problem.empty() ? "" : "--write: " + problem;
}

// "" or which output is a file that was read: the project's own ones, rule packs ...
std::string overwritten_input(const AdviseOptions& options, const RecordingReader& files) {
  std::set<std::string> read;
  for (const std::string& file : files.paths()) read.insert(path_identity(file));
  std::vector<std::string> outputs{options.write_file};
  for (const DataOutput& output : options.outputs) outputs.push_back(output.file);
  for (const std::string& file : outputs) {
    if (!file.empty() && read.contains(path_identity(file))) {
      return fmt::format("'{}' is not written: it is an input", file);
    }
  }
  return "";
}

void print_error(const std::string& words) {
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::output_not_possible, {}, words);
  print_diagnostics(diagnostics.all(), true);
}

// False after an error, which has been printed: then nothing is written. The advice holds all the
// same.
bool write_changed(const AdviseOptions& options, Advice& advice, const report::ProjectPart& part,
                   const std::string& bytes, const std::optional<RoomsText>& rooms,
                   const CheckText& check) {
  const auto has_levels = [](const SceneAdvice& scene) {
    return scene.outcome == AdviceOutcome::levels;
  };
  const auto scenes = std::count_if(advice.scenes.begin(), advice.scenes.end(), has_levels);
  const auto refused = [&](const std::string& why) {
    print_error(fmt::format("--write: '{}' is not written: {}", options.write_file, why));
    return false;
  };
  const auto written = [&](const std::string& text, WrittenAdvice told) {
    const std::string why = report::write_file_atomically(options.write_file, text);
    if (!why.empty()) {
      print_error(fmt::format("cannot write '{}': {}", options.write_file, why));
      return false;
    }
    told.file = options.write_file;
    advice.written = std::move(told);
    return true;
  };
  if (advice.packages) {
    if (!advice.packages->problem.empty()) return refused(advice.packages->problem);
    if (advice.packages->is_as_now()) return refused("its packages already need the least");
    const PackageAdvice& found = *advice.packages;
    return written(found.text, {"", "packages", found.passing, found.asked, found.not_met});
  }
  if (rooms) {
    return rooms->text ? written(*rooms->text, rooms->told) : refused(rooms->problem);
  }
  if (scenes == 0) return refused("no scene has levels");
  const LevelsText changed = with_levels(bytes, options.project, advice.scenes, part);
  if (!changed.text) return refused(changed.problem);
  std::string reason;
  const auto after = check(*changed.text, reason);
  if (!after) return refused(reason);
  if (const std::string lost = lost_by_writing(advice.scenes, part, *after); !lost.empty()) {
    return refused(fmt::format("as a whole it would not pass: {}", lost));
  }
  const PassCount count = count_all(*after);
  return written(*changed.text,
                 {"", "levels", count.passing, count.asked, not_met_findings(*after)});
}

bool is_readable_or_print(const calc::FileContent& content, const std::string& project) {
  if (content.ok()) return true;
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::file_not_readable, {project, 0, 0}, project,
                     content.error);
  print_diagnostics(diagnostics.all(), true);
  return false;
}

ExitCode run_advise(const AdviseOptions& asked, const RunContext& context) {
  watch_for_interrupt();
  AdviseOptions options = asked;
  CheckOptions& check = options.check;
  const ProjectReader disk(check.input);
  const RecordingReader files(disk);
  std::set<std::string> inputs{options.project};
  if (!options.write_file.empty()) inputs.insert(options.write_file);
  calc::Diagnostics outputs;
  check_data_outputs(options.outputs, inputs, outputs);
  print_diagnostics(outputs.all(), true);
  if (outputs.has_errors()) return kNotJudged;
  for (const std::string& problem : {solver_problem(), write_problem(options)}) {
    if (problem.empty()) continue;
    print_error(problem);
    return kNotJudged;
  }
  const calc::FileContent project = files.read(options.project);
  if (!is_readable_or_print(project, options.project)) return kNotJudged;
  const std::optional<check::Run> opened = open_run_or_print(check, context, files);
  if (!opened) return kNotJudged;
  // Whatever happens to the file from now on, all is about these bytes.
  const check::Run run = opened->with_light_in(std::make_shared<calc::MemoryStore>(kMostStoreBytes))
                             .with_text(options.project, project.bytes);
  Progress progress(progress_style(check.output, context.environment),
                    context.environment.stderr_columns, "checks");
  KeptLight light;
  LightKeeper keeper(progress, options.project, light);
  const report::ProjectPart part = run.check(options.project, keeper);
  progress.clear();
  if (interrupted()) return kInterrupted;
  print_diagnostics(part.diagnostics, check.output.quiet);
  if (!part.is_judged) return kNotJudged;
  if (const std::string problem = overwritten_input(options, files); !problem.empty()) {
    print_error(problem);
    return kNotJudged;
  }

  const CheckText check_text = check_by_other_numbers(options.project, run, progress);
  Advice advice{options.project, {}, {}, {}, {}};
  const AdviceSettings advised{options.steps, check.settings.confidence,
                               options.scene, options.has_scene,
                               interrupted,   options.least};
  if (const std::string problem = energy_problem(part);
      options.least == CostUnit::kilowatt_hour && !problem.empty()) {
    print_error("--least energy: " + problem);
    return kNotJudged;
  }
  advice.scenes = find_advice(part, light.planes(), advised,
                              levels_check(project.bytes, options.project, part, check_text));
  if (interrupted()) return kInterrupted;
  if (advice.scenes.empty()) {
    print_error(
        options.has_scene
            ? fmt::format("scene '{}' has no requirement that depends on its levels", options.scene)
            : "the project has no requirement that depends on the levels of luminaires");
    return kNotJudged;
  }
  if (!options.has_scene) advice.not_met_besides = not_met_besides(advice, part);
  std::optional<RoomsText> rooms;  // that are to be written
  if (options.packages || options.places || options.surfaces || options.turns) {
    calc::Diagnostics again;
    const std::optional<calc::Project> loaded =
        calc::load_project(run.files(), options.project, again);
    if (!loaded) {
      print_diagnostics(again.all(), true);
      return kNotJudged;
    }
    calc::ImportanceSettings importance;
    importance.seed = check.settings.radiosity.seed;
    importance.jobs = check.settings.radiosity.jobs;
    importance.goes_on = [] { return !interrupted(); };
    const auto light_apart = [&] {
      check::Settings settings = run.settings();
      settings.by_luminaire = true;
      KeptLight kept;
      LightKeeper apart(progress, options.project, kept);
      run.with_settings(settings).check(options.project, apart);
      progress.clear();
      return kept.planes();
    };
    const RoomQuestions questions{options.project,
                                  project.bytes,
                                  *loaded,
                                  part,
                                  light.planes(),
                                  advice.scenes,
                                  check.settings.confidence,
                                  importance,
                                  check_text,
                                  light_apart};
    if (options.packages) advice.packages = find_packages(questions, advised);
    if (options.places) {
      advice.rooms.places = find_places(questions);
      advice.rooms.spare = find_spare(questions);
      if (!options.write_file.empty() && !advice.rooms.places->empty()) {
        rooms = with_places(questions, *advice.rooms.places);
      }
    }
    if (options.turns) {
      advice.rooms.turns = find_turns(questions);
      if (!options.write_file.empty() && !advice.rooms.turns->empty()) {
        rooms = with_turns(questions, *advice.rooms.turns);
      }
    }
    if (options.surfaces) advice.rooms.surfaces = find_surfaces(questions);
    if (interrupted()) return kInterrupted;
  }
  const bool is_written = options.write_file.empty() ||
                          write_changed(options, advice, part, project.bytes, rooms, check_text);
  if (interrupted()) return kInterrupted;
  calc::Diagnostics written;
  const std::string text = write_data_outputs(
      options.outputs,
      [&](DataFormat kind) {
        switch (kind) {
          case DataFormat::json:
            return render_advice_json(advice);
          case DataFormat::html:
            return render_advice_html(advice);
          case DataFormat::markdown:
            return render_advice_markdown(advice);
          default:
            return render_advice_text(advice);
        }
      },
      check.output.quiet, written);
  print_diagnostics(written.all(), true);
  const bool is_printed = print_result(text);
  return is_printed && is_written && !written.has_errors() ? exit_code_of_advice(advice)
                                                           : kNotJudged;
}

std::string complete_advise(AdviseOptions& options) {
  CheckOptions& check = options.check;
  check.input.projects = {options.project};
  for (const DataOutput& output : options.outputs) {
    if (output.kind == DataFormat::csv) return "--format: text, json, html or markdown";
  }
  if (options.packages && options.has_scene) {
    return "--packages is about all scenes: leave out --scene";
  }
  const int written =
      (options.packages ? 1 : 0) + (options.places ? 1 : 0) + (options.turns ? 1 : 0);
  if (written > 1 && !options.write_file.empty()) {
    return "--write: packages, places or turns, one after the other";
  }
  if (std::string problem = data_output_problem(options.outputs); !problem.empty()) return problem;
  return complete_work(check.settings.radiosity, check.backend);
}

}  // namespace

Command advise_command() {
  const auto options = std::make_shared<AdviseOptions>();
  CheckOptions& check = options->check;
  check.pictures = false;
  check.settings.goal = rules::Goal::accuracy;
  Command command{"advise", "Find the dimming levels that pass with the least power"};
  command.places = {project_place(options->project)};
  command.options = {
      rules_option(check.input.rule_files),
      allow_option(check.input.allowed),
      {"--scene", "ID",
       "Find levels only for this scene. 'full-output' means the requirements without a scene",
       [options](const std::string& text) -> std::string {
         if (text.empty()) return "the id of a scene, or full-output";
         options->scene = text == "full-output" ? "" : text;
         options->has_scene = true;
         return "";
       }},
      {"--least", "WHAT",
       "Choose what the levels minimise: power or energy; default power. energy is that of a year, "
       "by the use that rooms state",
       choice<CostUnit>(options->least,
                        {{"power", CostUnit::watt}, {"energy", CostUnit::kilowatt_hour}})},
      {"--steps", "N", "Use levels that are multiples of 1/N, N from 1 to 1000; default 100",
       whole_number(options->steps, 1, 1000)},
      {"--write", "FILE",
       "Write the project with the levels that were found. With --packages, --places or --turns it "
       "has those instead. The file must be in the folder of the project. It can be used with "
       "--against or compare. What is required at full output is then required in a new scene",
       some_text(options->write_file)},
      {"--packages", "",
       "Find lamp packages of the luminaire types (<package>) that are sufficient. --write then "
       "writes them",
       &options->packages},
      {"--places", "",
       "Find where one more luminaire helps most, and which ones can be removed. The first is for "
       "rooms where no levels meet all limits, the second for rooms where all are met. --write "
       "then writes the added ones, if there are any",
       &options->places},
      {"--turns", "",
       "Find which luminaires to turn or tilt, in rooms where no levels meet all limits. --write "
       "then writes turns that are sufficient",
       &options->turns},
      {"--surfaces", "", "Find what a lighter floor, ceiling or walls add in each room",
       &options->surfaces}};
  add(command.options,
      data_format_options(
          options->outputs,
          "text, json, html (with maps of ceilings) or markdown; default text. It is repeatable. "
          "Without FILE, or with '-', it goes to standard output, which takes one kind only",
          true));
  for (Option& option : accuracy_options(check.settings)) {
    if (option.names != "--goal" && option.names != "--by-luminaire") {
      command.options.push_back(std::move(option));
    }
  }
  add(command.options, work_options(check.settings.radiosity));
  add(command.options, backend_options(check.backend));
  add(command.options, {quiet_option(check.output.quiet)});
  command.notes = kAdviseNotes;
  command.examples = {{"luxgate advise office.xml --write dimmed.xml",
                       "Levels for every scene, and a project that has them"},
                      {"luxgate advise office.xml --places --surfaces",
                       "Also where more luminaires help, and what lighter surfaces add"}};
  command.exit_codes = {
      {kAllMet, "levels or packages were found, and all requirements pass with them"},
      {kNotMet,
       "a scene has no such levels, or a requirement that does not depend on them is not met"},
      {kNotJudged, "usage, input or file error, or the project could not be judged"},
      {kInterrupted, "interrupted"}};
  command.most_used = {"--scene",    "--write",     "--packages", "--places",
                       "--surfaces", "--tolerance", "--rules",    "--json"};
  command.complete = [options](const Environment&) { return complete_advise(*options); };
  command.run = [options](const RunContext& context) { return run_advise(*options, context); };
  return command;
}

}  // namespace cli
