#include "report/cli/options.h"

#include "report/shell/exit_code.h"
#include "report/shell/option_values.h"
#include "report/text/shell_words.h"
#include "report/tools/devices/version.h"
#include "report/tools/photometry/photometry_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string_view>
#include <vector>

namespace cli {
namespace {

constexpr const char* kExitCodes =
    "Exit codes:\n"
    "  0    every requirement is met or waived, or nothing was asked: a warning says so\n"
    "  1    at least one requirement is not met\n"
    "  2    usage, input or file error, or a plane or project that could not be judged\n"
    "  3    nothing failed, but a result's interval holds its limit: undecided\n"
    "  130  interrupted; nothing was written\n"
    "The worst of all projects counts; worst first: 2, 1, 3, 0.";

const std::vector<std::pair<std::string_view, calc::Method>> kMethods = {
    {"light-pool", calc::Method::light_pool},
    {"instant-radiosity", calc::Method::instant_radiosity}};

CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& value_name,
                       const std::string& help, ValueParser parser) {
  const auto apply = [name, parser = std::move(parser)](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const std::string problem = parser(text);
      if (!problem.empty())
        throw CLI::ValidationError(name, fmt::format("'{}': {}", text, problem));
    }
  };
  return app.add_option_function<std::vector<std::string>>(name, apply, help)
      ->type_name(value_name)
      ->expected(1)
      ->allow_extra_args(false);  // a project may follow
}

void allow_repeats(CLI::Option* option) {
  option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);
}

void add_projects(CLI::App& app, Options& options) {
  app.add_option("projects", options.projects, "Project files")
      ->required()
      ->type_name("PROJECT.xml");
  allow_repeats(
      app.add_option("--rules", options.rule_files,
                     "Rule pack, or folder of rule packs, to know besides those delivered;\n"
                     "may be repeated")
          ->type_name("FILE|DIR"));
}

void add_color(CLI::App& app, Options& options) {
  add_value(
      app, "--color", "WHEN",
      "auto, always or never; auto obeys NO_COLOR, CLICOLOR_FORCE, TERM=dumb and the terminal",
      choice<ColorChoice>(options.color, {{"auto", ColorChoice::automatic},
                                          {"always", ColorChoice::always},
                                          {"never", ColorChoice::never}}));
}

void add_formats(CLI::App& app, Options& options) {
  allow_repeats(
      add_value(app, "--format", "KIND[=FILE]",
                "text, csv, points-csv, json, html, junit, sarif (problems), sarif-all (passes\n"
                "too), github, gitlab or markdown, to FILE or (one kind only) to standard output,\n"
                "where text goes unless another kind does; may be repeated; FILE's folder is made\n"
                "if needed",
                format_item(options.formats)));
  app.add_option("--output", options.output_folder,
                 "Folder for results.csv, points.csv, result.json and report.html; made if needed")
      ->type_name("FOLDER");
  app.add_flag("--html-split", options.html_split,
               "HTML files as an index with a page for each room, at most 24 planes on each, in\n"
               "a folder '<name>-rooms' beside it: for hundreds of planes");
  add_value(app, "--language", "LANG",
            "Words of html, markdown and text: en or de; default en. All other formats are\n"
            "English, and so are messages, reasons and the texts of projects and rule packs",
            choice<report::Language>(options.language, {{"en", report::Language::english},
                                                        {"de", report::Language::german}}));
  add_value(app, "--decimal", "SIGN",
            "Decimal sign of html, markdown and text: point or comma; default comma with\n"
            "--language de, else point. All other formats have points",
            choice<DecimalSign>(options.decimal,
                                {{"point", DecimalSign::point}, {"comma", DecimalSign::comma}}));
  app.add_flag("--images", options.images,
               "With --output: a PNG, an SVG and an EXR file per plane, a PNG and an EXR file per "
               "picture too");
  app.add_flag(
      "--redact", options.redact,
      "Reports without what tells of this machine: folders of files, also in the command\n"
      "and in messages, and names of graphics devices. The project's own names stay, as do\n"
      "versions and hashes. Reports say so");
}

void add_output(CLI::App& app, Options& options) {
  add_formats(app, options);
  add_value(app, "--pictures", "WHEN",
            "Rooms in false colours, in HTML and with --images: auto (where OpenGL can draw) or\n"
            "off; default auto. Their bytes depend on the machine's OpenGL",
            choice<bool>(options.pictures, {{"auto", true}, {"off", false}}));
  add_value(
      app, "--timestamp", "WHEN",
      "Put a date into reports: 'now' or seconds since 1970; default SOURCE_DATE_EPOCH if set,\n"
      "else no date, so that equal inputs give equal files",
      moment(options.timestamp));
  app.add_flag("--timing", options.timing,
               "Print times and counts of rays to standard error and put them into reports");
  app.add_flag("--explain-cost", options.explain_cost,
               "Print predicted beside true work to standard error: see 'luxgate plan'");
  add_color(app, options);
}

// What the amount of work depends on: for the calculation and for its plan.
void add_work(CLI::App& app, Options& options) {
  constexpr std::uint64_t kMostPaths = std::uint64_t{1} << 30;
  calc::RadiositySettings& settings = options.radiosity;
  add_value(app, "--replicates", "N",
            "Independent repetitions behind each interval, 4 to 64; default 16",
            whole_number(settings.replicates, 4, 64));
  add_value(app, "--max-paths", "N",
            "At most so many light paths per replicate and plane, a power of two; default 65536",
            power_of_two(settings.max_paths, 1, kMostPaths));
  add_value(app, "--jobs", "N", "Threads; default one per core. Never changes a result",
            whole_number(settings.jobs, 1, 1024));
  add_value(app, "--method", "NAME",
            "light-pool, or instant-radiosity for comparison: every point is connected to every\n"
            "light vertex; default light-pool",
            choice<calc::Method>(settings.method, kMethods));
  add_value(app, "--visibility", "NAME",
            "rays, or shadow-map:N with --method instant-radiosity: OpenGL draws what each light\n"
            "vertex sees, N texels along a cube's edge (16 to 2048, a power of two); default rays",
            visibility(settings.shadow_map_texels));
  add_value(app, "--clamp", "G",
            "With --method instant-radiosity: cut off geometry terms above G /m2; default none.\n"
            "What is cut off is lost",
            positive_number(settings.clamp_per_m2));
  allow_repeats(add_value(app, "--no-skip", "NAME",
                          "Leave nothing out for this reason, or any ('all'); may be repeated.\n"
                          "Other random numbers may then be drawn. 'luxgate plan' lists the names",
                          forbidden_skip(settings.skips)));
}

void add_calculation(CLI::App& app, Options& options) {
  calc::RadiositySettings& settings = options.radiosity;
  add_value(app, "--goal", "NAME",
            "verdict: a plane is done once each of its requirements passes or fails;\n"
            "accuracy: once every judged value is known to --tolerance; default verdict",
            choice<rules::Goal>(options.goal, {{"verdict", rules::Goal::verdict},
                                               {"accuracy", rules::Goal::accuracy}}));
  add_value(app, "--tolerance", "SHARE",
            "Relative half-width of the intervals to aim at, as 0.02 or 2%, with --goal accuracy\n"
            "and for planes without requirements; default 0.02",
            share_between(options.tolerance, 0.0, 1.0));
  add_value(app, "--confidence", "SHARE",
            "Level of the intervals, as 0.95 or 95%, over all times that a plane is looked at;\n"
            "default 0.95",
            share_between(options.confidence, 0.5, 1.0));
  app.add_flag(
      "--by-luminaire", options.by_luminaire,
      "Say in HTML and JSON what each luminaire gives to the average and at the minimum of a\n"
      "plane, reflections included: the ten largest and the rest. Takes more time and memory,\n"
      "and other random numbers are drawn");
  add_value(app, "--seed", "N", "Seed of the random numbers; default 1",
            whole_number(settings.seed, 0, UINT64_MAX));
  add_value(app, "--time-limit", "SECONDS",
            "Stop refining a project after this time; results then depend on the machine's speed",
            seconds(settings.time_limit_s));
}

// Who gathers the light.
void add_backend(CLI::App& app, Options& options) {
  add_value(app, "--backend", "NAME",
            "auto, cpu or gpu (OpenGL compute); auto takes a GPU if there is one and enough work\n"
            "for it, never software OpenGL; default auto. 'luxgate plan' says what it takes",
            choice<Backend>(
                options.backend,
                {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"gpu", Backend::gpu}}));
  add_value(app, "--gl-device", "N",
            "With --backend gpu: the OpenGL device to use; 'luxgate devices' lists them",
            whole_number(options.gl_device, 0, 1023));
  add_value(
      app, "--gpu-stages", "LIST",
      "With --backend gpu: what runs on it, of light-paths, connections and near-field, with\n"
      "commas between; default all. The CPU does the rest",
      gpu_stages(options.gpu_stages));
}

void add_photometry(CLI::App& app, Options& options) {
  PhotometryOptions& photometry = options.photometry;
  app.add_option("files", photometry.files, "Photometry files (LM-63, EULUMDAT, TM-33, GLDF)")
      ->required()
      ->type_name("FILE");
  const auto format = [&](const std::string& name, PhotometryFormat value,
                          const std::string& help) {
    return app.add_flag_callback(
        name, [&photometry, value] { photometry.format = value; }, help);
  };
  CLI::Option* json = format("--json", PhotometryFormat::json, "As JSON");
  format("--csv", PhotometryFormat::csv, "As CSV, one line per file")->excludes(json);
  app.add_option("--polar", photometry.polar_file,
                 "Draw one file's polar diagram; the kind by the name")
      ->type_name("OUT.svg|.png");
  app.add_option("--polar-dir", photometry.polar_folder,
                 "Draw every file's polar diagram: FOLDER/FILE.svg; made if needed")
      ->type_name("FOLDER");
  app.add_option("--convert", photometry.convert_file,
                 "Write one file again as LM-63-2002 or EULUMDAT, by the name; never over an input")
      ->type_name("OUT.ies|.ldt");
  app.add_flag("--compare", photometry.compare,
               "Compare two files: are they one light, and which quarter turn lies between them?");
  add_value(app, "--lamp-set", "N", "EULUMDAT: take the N-th lamp set; default the first",
            whole_number(photometry.lamp_set, 1, 1'000'000));
  add_value(app, "--variant", "ID", "GLDF: take the light of this variant",
            some_text(photometry.variant));
  add_value(app, "--emitter", "ID",
            "GLDF: this emitter, or ID#2 for its second light; TM-33: id, description or number",
            some_text(photometry.emitter));
  app.add_flag("--strict", photometry.strict, "Exit code 1 if there are warnings");
  add_color(app, options);
  app.footer(
      "Exit codes: 0 all files are readable, 1 warnings with --strict, 2 an unreadable file or\n"
      "another error. A bad file does not keep the others from being shown.");
}

void add_geometry(CLI::App& app, Options& options) {
  app.add_option("files", options.geometry_files,
                 "Mesh files (OBJ, glTF, GLB, STL, PLY), gbXML files or projects")
      ->required()
      ->type_name("FILE");
  add_value(
      app, "--units", "UNIT", "Unit of OBJ, STL and PLY files: m, cm, mm, in or ft",
      choice<std::string>(options.mesh_units,
                          {{"m", "m"}, {"cm", "cm"}, {"mm", "mm"}, {"in", "in"}, {"ft", "ft"}}));
  add_value(app, "--up", "AXIS", "Vertical axis of OBJ, STL and PLY files: z or y",
            choice<std::string>(options.mesh_up, {{"z", "z"}, {"y", "y"}}));
  app.add_flag("--json", options.geometry_as_json, "As JSON");
  app.add_flag("--strict", options.strict, "Exit with 1 if there is a warning");
  app.footer("Exit codes: 0 readable, 1 warnings with --strict, 2 at least one error.");
}

// One project and the options that a command lists by itself.
void add_listed(CLI::App& app, std::string& project, const std::vector<ValueOption>& list) {
  app.add_option("project", project, "Project file")->required()->type_name("PROJECT.xml");
  for (const ValueOption& item : list) {
    CLI::Option* option = add_value(app, item.name, item.value_name, item.help, item.parser);
    if (item.repeats) allow_repeats(option);
  }
}

void add_listed(CLI::App& app, const ListedCommand& command) {
  for (const ListedCommand::Place& place : command.places) {
    app.add_option(place.name, *place.target, place.help)
        ->required(place.is_required)
        ->type_name(place.value_name);
  }
  for (const ListedCommand::Flag& flag : command.flags) {
    app.add_flag(flag.name, *flag.target, flag.help);
  }
  for (const ValueOption& item : command.values) {
    CLI::Option* option = add_value(app, item.name, item.value_name, item.help, item.parser);
    if (item.repeats) allow_repeats(option);
  }
  app.footer(command.footer);
}

bool writes_html_file(const Options& options) {
  return !options.output_folder.empty() ||
         std::any_of(options.formats.begin(), options.formats.end(),
                     [](const OutputFormat& format) {
                       return format.kind == FormatKind::html && !format.file.empty();
                     });
}

// What can only be seen with all options together; "" = nothing is wrong.
std::string contradiction(const Options& options) {
  if (options.command == Command::photometry) return photometry_contradiction(options.photometry);
  if (options.command == Command::vpl) return vpl_contradiction(options.vpl);
  if (options.command == Command::converge) return converge_contradiction(options.converge);
  if (options.command == Command::selftest) return selftest_contradiction(options.selftest);
  if (options.command == Command::compare) return compare_contradiction(options.compare);
  if (options.command == Command::export_scene) return export_contradiction(options.export_scene);
  if (!options.vpl_file.empty() && options.projects.size() > 1) {
    return fmt::format("--vpl is for one project; found {}", options.projects.size());
  }
  const auto stdout_formats =
      std::count_if(options.formats.begin(), options.formats.end(),
                    [](const OutputFormat& format) { return format.file.empty(); });
  if (stdout_formats > 1) {
    return "--format: only one kind can go to standard output; give the others as KIND=FILE";
  }
  if (options.gl_device >= 0 && options.backend != Backend::gpu) {
    return "--gl-device needs --backend gpu";
  }
  if (options.gpu_stages && options.backend != Backend::gpu) {
    return "--gpu-stages needs --backend gpu";
  }
  const bool is_instant = options.radiosity.method == calc::Method::instant_radiosity;
  if (options.radiosity.shadow_map_texels > 0) {
    if (!is_instant) {
      return "--visibility shadow-map needs --method instant-radiosity; with light-pool only "
             "--visibility rays is allowed";
    }
    if (options.backend == Backend::cpu) {
      return "--visibility shadow-map draws with OpenGL: --backend auto and gpu are allowed with "
             "it, cpu is not";
    }
  }
  if (options.radiosity.clamp_per_m2 > 0.0 && !is_instant) {
    return "--clamp needs --method instant-radiosity";
  }
  if (options.images && options.output_folder.empty()) return "--images needs --output FOLDER";
  if (options.html_split && !writes_html_file(options)) {
    return "--html-split needs --output FOLDER or --format html=FILE";
  }
  for (std::size_t i = 0; i < options.projects.size(); ++i) {
    const auto normal = std::filesystem::path(options.projects[i]).lexically_normal();
    for (std::size_t k = 0; k < i; ++k) {
      if (std::filesystem::path(options.projects[k]).lexically_normal() != normal) continue;
      return fmt::format("project '{}' is given twice", options.projects[i]);
    }
  }
  return "";
}

ParseResult usage_error(const std::string& message, const std::string& help_command) {
  return {std::nullopt, kNotJudged, "",
          fmt::format("luxgate: error: {}\nSee '{} --help'.\n", message, help_command)};
}

// CLI11 would only say that a subcommand is required. "" = `first` is a command or an option.
std::string problem_with_command(const CLI::App& app, std::string_view first) {
  const std::vector<const CLI::App*> commands =
      app.get_subcommands(std::function<bool(const CLI::App*)>());
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  if (first.starts_with('-') || std::find(names.begin(), names.end(), first) != names.end()) {
    return "";
  }
  const std::string needed = one_of_message(first, {names.begin(), names.end()});
  return first.empty() ? "no command: " + needed : fmt::format("'{}': {}", first, needed);
}

ParseResult from_cli11(const CLI::App& app, const CLI::Error& error) {
  if (error.get_exit_code() == 0) {  // --help, --version
    std::ostringstream out, err;
    app.exit(error, out, err);
    return {std::nullopt, kAllMet, out.str(), ""};
  }
  const auto chosen = app.get_subcommands();
  return usage_error(error.what(),
                     chosen.empty() ? "luxgate" : "luxgate " + chosen.front()->get_name());
}

std::string no_skip_options(const calc::SkipSet& skips) {
  calc::SkipSet none;
  none.forbid_all();
  if (skips == none) return " --no-skip all";
  std::string text;
  for (std::size_t s = 0; s < calc::kSkips; ++s) {
    const auto skip = static_cast<calc::Skip>(s);
    if (!skips.allows(skip)) text += fmt::format(" --no-skip {}", calc::skip_name(skip));
  }
  return text;
}

}  // namespace

report::Texts report_texts(const Options& options) {
  const bool has_comma = options.decimal == DecimalSign::of_language
                             ? options.language == report::Language::german
                             : options.decimal == DecimalSign::comma;
  return {options.language, has_comma};
}

ParseResult parse_options(int argc, const char* const* argv, const std::string& source_date_epoch) {
  Options options;
  CLI::App app{"luxgate checks calculated illuminance against lighting requirements.", "luxgate"};
  app.set_version_flag("--version", "luxgate " + program_version());
  app.require_subcommand(1);
  app.footer("'luxgate COMMAND --help' explains a command.");

  CLI::App& check = *app.add_subcommand("check", "Calculate projects and judge their requirements");
  add_projects(check, options);
  add_output(check, options);
  add_calculation(check, options);
  add_work(check, options);
  add_backend(check, options);
  CLI::Option* vpl_file = add_value(
      check, "--vpl", "FILE",
      "Take the light vertices of one space from a file of 'luxgate vpl' instead of tracing them;\n"
      "seed, replicates and the most paths are the file's. Results are the same to the bit",
      some_text(options.vpl_file));
  for (const char* fixed : {"--seed", "--replicates", "--max-paths", "--by-luminaire"}) {
    vpl_file->excludes(check.get_option(fixed));
  }
  check.footer(kExitCodes);
  CLI::App& report =
      *app.add_subcommand("report", "Render a result again in other formats, without calculating");
  report.add_option("result", options.result_file, "A file that 'check --format json' wrote")
      ->required()
      ->type_name("RESULT.json");
  add_formats(report, options);
  add_color(report, options);
  report.footer("Exit codes: 0 written, whatever the verdicts are; 2 an error.");
  CLI::App& plan = *app.add_subcommand(
      "plan", "Say what 'check' would do, leave out and cost, without calculating");
  add_projects(plan, options);
  add_work(plan, options);
  add_backend(plan, options);
  add_value(plan, "--format", "KIND", "text or json; default text",
            choice<bool>(options.plan_as_json, {{"text", false}, {"json", true}}));
  plan.footer("Exit codes: 0 no error, 2 at least one error.");
  CLI::App& validate =
      *app.add_subcommand("validate", "Check projects for errors without calculating");
  add_projects(validate, options);
  validate.footer("Exit codes: 0 no error, 2 at least one error.");
  CLI::App& vpl = *app.add_subcommand(
      "vpl", "Trace the light vertices of a space and write them as a PLY file");
  add_listed(vpl, options.vpl.project, vpl_value_options(options.vpl));
  vpl.footer("Exit codes: 0 written, 2 an error.");
  CLI::App& converge = *app.add_subcommand(
      "converge", "Measure error against run time and rays, for several methods");
  add_listed(converge, options.converge.project, converge_value_options(options.converge));
  converge.footer(converge_footer());
  CLI::App& selftest =
      *app.add_subcommand("selftest", "Calculate cases whose light is known exactly, and compare");
  add_listed(selftest, selftest_command(options.selftest));
  CLI::App& compare = *app.add_subcommand(
      "compare", "Compare a result with another one, another program's or measured values");
  add_listed(compare, compare_command(options.compare));
  CLI::App& export_scene =
      *app.add_subcommand("export", "Write a project as a scene for another program (Radiance)");
  add_listed(export_scene, export_command(options.export_scene));
  CLI::App& photometry =
      *app.add_subcommand("photometry", "Show, check, convert, draw and compare photometry files");
  add_photometry(photometry, options);
  for (CLI::App* command : {&check, &report, &plan, &validate, &photometry}) {
    command->add_flag("-q,--quiet", options.quiet,
                      "Print errors and what an option asks for, nothing else");
  }
  CLI::App& geometry = *app.add_subcommand(
      "geometry", "Say what is in mesh files and projects, and whether rooms are closed");
  add_geometry(geometry, options);
  CLI::App& rule_packs =
      *app.add_subcommand("rules", "List, show, check and import rule packs (standards as data)");
  add_rules_options(rule_packs, options.rules_command, options.rule_files);
  CLI::App& explain =
      *app.add_subcommand("explain", "Say what a rule requires, or what a message means");
  add_explain_options(explain, options.rules_command, options.rule_files);
  CLI::App& schema = *app.add_subcommand("schema", "Print the XML schema of project files");
  schema.add_flag("--result", options.result_schema,
                  "Print the JSON schema of 'check --format json' instead");
  CLI::App& init = *app.add_subcommand("init", "Write a small project that runs and passes");
  init.add_option("folder", options.init_folder, "Where; made if needed. Existing files are kept")
      ->type_name("FOLDER");
  CLI::App& devices =
      *app.add_subcommand("devices", "List OpenGL devices, and why one cannot be used");
  devices.add_flag("--json", options.devices_as_json, "As JSON");
  devices.footer("Exit codes: 0 at least one device is usable, 2 none is.");
  CLI::App& version = *app.add_subcommand("version", "Print versions of the program and libraries");
  version.add_flag("--json", options.version_as_json, "As JSON");

  const std::string no_command = problem_with_command(app, argc < 2 ? "" : argv[1]);
  if (!no_command.empty()) return usage_error(no_command, "luxgate");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Error& error) {
    return from_cli11(app, error);
  }

  if (report.parsed()) options.command = Command::report;
  if (plan.parsed()) options.command = Command::plan;
  if (validate.parsed()) options.command = Command::validate;
  if (vpl.parsed()) options.command = Command::vpl;
  if (converge.parsed()) options.command = Command::converge;
  if (selftest.parsed()) options.command = Command::selftest;
  if (compare.parsed()) options.command = Command::compare;
  if (export_scene.parsed()) options.command = Command::export_scene;
  if (photometry.parsed()) options.command = Command::photometry;
  if (geometry.parsed()) options.command = Command::geometry;
  if (rule_packs.parsed()) options.command = Command::rules;
  if (explain.parsed()) options.command = Command::explain;
  if (schema.parsed()) options.command = Command::schema;
  if (init.parsed()) options.command = Command::init;
  if (devices.parsed()) options.command = Command::devices;
  if (version.parsed()) options.command = Command::version;

  if (check.parsed() && options.timestamp.empty() && !source_date_epoch.empty()) {
    const std::string problem = moment(options.timestamp)(source_date_epoch);
    if (!problem.empty() || source_date_epoch == "now") {
      return usage_error(
          fmt::format("SOURCE_DATE_EPOCH is '{}': whole seconds since 1970 are needed",
                      source_date_epoch),
          "luxgate check");
    }
  }
  const std::string problem = contradiction(options);
  if (!problem.empty()) {
    return usage_error(problem, "luxgate " + app.get_subcommands().front()->get_name());
  }
  calc::RadiositySettings& settings = options.radiosity;
  settings.first_paths = std::min(settings.first_paths, settings.max_paths);
  return {std::move(options), kAllMet, "", ""};
}

std::string reproducible_command(const Options& options) {
  const Options defaults;
  std::string command = "luxgate check";
  for (const std::string& project : options.projects)
    command += " " + report::shell_quoted(project);
  for (const std::string& file : options.rule_files)
    command += " --rules " + report::shell_quoted(file);
  const auto add = [&command](const char* name, const auto& value, const auto& default_value) {
    if (value != default_value) command += fmt::format(" {} {}", name, value);
  };
  const calc::RadiositySettings& used = options.radiosity;
  add("--seed", used.seed, defaults.radiosity.seed);
  if (options.goal != defaults.goal) {
    command += fmt::format(" --goal {}", rules::goal_name(options.goal));
  }
  add("--tolerance", options.tolerance, defaults.tolerance);
  add("--confidence", options.confidence, defaults.confidence);
  add("--replicates", used.replicates, defaults.radiosity.replicates);
  add("--max-paths", used.max_paths, defaults.radiosity.max_paths);
  add("--time-limit", used.time_limit_s, defaults.radiosity.time_limit_s);
  for (const auto& [name, method] : kMethods) {
    if (used.method == method && method != defaults.radiosity.method) {
      command += fmt::format(" --method {}", name);
    }
  }
  if (used.shadow_map_texels > 0) {
    command += fmt::format(" --visibility shadow-map:{}", used.shadow_map_texels);
  }
  add("--clamp", used.clamp_per_m2, defaults.radiosity.clamp_per_m2);
  if (options.by_luminaire) command += " --by-luminaire";
  command += no_skip_options(used.skips);
  if (options.backend == Backend::gpu) command += " --backend gpu";
  if (options.backend == Backend::gpu && options.gpu_stages.value_or(GpuStages()) != GpuStages()) {
    command +=
        fmt::format(" --gpu-stages {}", fmt::join(gpu_stage_names(*options.gpu_stages), ","));
  }
  if (options.backend == Backend::cpu) command += " --backend cpu";
  return command;
}

}  // namespace cli
