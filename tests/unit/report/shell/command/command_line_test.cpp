#include "report/shell/command/command_line.h"

#include "calc/base/diagnostic_ids.h"
#include "report/shell/command/config_file.h"
#include "report/tools/check/check_options.h"
#include "report/tools/geometry/geometry.h"
#include "report/tools/photometry/photometry_options.h"
#include "report/tools/plan/plan.h"
#include "report/tools/report/report.h"
#include "tests/support/command_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace command_line_test {
namespace {

using ::testing::HasSubstr;
using Words = std::vector<const char*>;

template <class Options>
Options parsed_by(cli::Command (*syntax)(Options&), const Words& words,
                  const std::string& source_date_epoch = "") {
  Options options;
  const cli::TestLine line = cli::parse_words(syntax, options, words, source_date_epoch);
  EXPECT_TRUE(line.is_good) << line.err;
  return options;
}

cli::CheckOptions parsed(const Words& words) { return parsed_by(cli::check_syntax, words); }

void expect_usage_error(const Words& words, const std::string& part) {
  const cli::TestLine line = cli::parse_words(words);
  EXPECT_FALSE(line.is_good);
  EXPECT_EQ(line.exit_code, 2);
  EXPECT_EQ(line.out, "");
  EXPECT_THAT(line.err, HasSubstr("luxgate: error: "));
  EXPECT_THAT(line.err, HasSubstr(part));
}

TEST(Options, HasTheDocumentedDefaults) {
  const cli::CheckOptions options = parsed({"check", "a.xml", "b/c.xml"});
  EXPECT_THAT(options.input.projects, ::testing::ElementsAre("a.xml", "b/c.xml"));
  EXPECT_TRUE(options.output.formats.empty());
  EXPECT_EQ(options.settings.goal, rules::Goal::verdict);
  EXPECT_DOUBLE_EQ(options.settings.tolerance, 0.02);
  EXPECT_DOUBLE_EQ(options.settings.confidence, 0.95);
  EXPECT_EQ(options.settings.radiosity.seed, 1u);
  EXPECT_EQ(options.settings.radiosity.replicates, 16);
  EXPECT_EQ(options.settings.radiosity.max_paths, 65536u);
  EXPECT_EQ(options.backend.backend, check::Backend::automatic);
  EXPECT_EQ(options.backend.gl_device, -1);
  EXPECT_EQ(options.timestamp, "");
}

TEST(Options, WhatFollowsACommandIsNoneWhateverItIsCalled) {
  EXPECT_THAT(parsed({"check", "plan", "check", "-q", "help"}).input.projects,
              ::testing::ElementsAre("plan", "check", "help"));
  for (const Words& words :
       {Words{"help", "check"}, Words{"help", "rules", "show"}, Words{"man", "check"},
        Words{"explain", "init"}, Words{"rules", "show", "list"},
        Words{"check", "plan", "check", "-q", "help"}}) {
    const cli::TestLine line = cli::parse_words(words);
    EXPECT_TRUE(line.is_good) << words.front() << ": " << line.err;
  }
}

// A setting that is no option would be taken without a word, and change nothing.
TEST(Options, EverySettingOfAFileIsOneOfCheck) {
  cli::CheckOptions options;
  const cli::Command command = cli::check_syntax(options);
  for (const std::string_view name : cli::setting_names()) {
    EXPECT_TRUE(std::any_of(
        command.options.begin(), command.options.end(),
        [&](const cli::Option& option) { return option.names == "--" + std::string(name); }))
        << name;
  }
}

TEST(Options, StrictTakesIdsBehindAnEqualsSignOnly) {
  EXPECT_FALSE(parsed({"check", "a.xml"}).strict.has(calc::DiagnosticId::light_leaves_room));
  const cli::CheckOptions all = parsed({"check", "--strict", "a.xml"});
  EXPECT_THAT(all.input.projects, ::testing::ElementsAre("a.xml"));
  EXPECT_TRUE(all.strict.all);
  const cli::CheckOptions some =
      parsed({"check", "a.xml", "--strict=light-leaves-room,luminaires-coincide"});
  EXPECT_TRUE(some.strict.has(calc::DiagnosticId::light_leaves_room));
  EXPECT_TRUE(some.strict.has(calc::DiagnosticId::luminaires_coincide));
  EXPECT_FALSE(some.strict.has(calc::DiagnosticId::plane_faces_away));
  const cli::CheckOptions twice =
      parsed({"check", "a.xml", "--strict=light-leaves-room", "--strict=plane-faces-away"});
  EXPECT_TRUE(twice.strict.has(calc::DiagnosticId::light_leaves_room));
  EXPECT_TRUE(twice.strict.has(calc::DiagnosticId::plane_faces_away));
}

TEST(Options, StrictRefusesWhatIsNoWarning) {
  expect_usage_error({"check", "a.xml", "--strict=light-leave-room"},
                     "no warning has the id 'light-leave-room'; did you mean 'light-leaves-room'?");
  expect_usage_error({"check", "a.xml", "--strict=all-of-them"}, "there are messages-left-out, ");
  expect_usage_error({"check", "a.xml", "--strict", "light-leaves-room"},
                     "write --strict=light-leaves-room");
  expect_usage_error({"check", "a.xml", "--strict=unknown-attribute"}, "is an error");
  expect_usage_error({"check", "a.xml", "--strict=light-leaves-room,"}, "no warning has the id ''");
}

TEST(Options, ReadsEveryCalculationSetting) {
  const cli::CheckOptions options =
      parsed({"check", "a.xml", "--goal", "accuracy", "--tolerance", "5%", "--confidence=0.99",
              "--seed", "18446744073709551615", "--replicates", "32", "--max-paths", "1024",
              "--time-limit", "2.5", "--jobs", "3", "--backend", "gpu"});
  EXPECT_EQ(options.settings.goal, rules::Goal::accuracy);
  EXPECT_DOUBLE_EQ(options.settings.tolerance, 0.05);
  EXPECT_DOUBLE_EQ(options.settings.confidence, 0.99);
  EXPECT_EQ(options.settings.radiosity.seed, 18446744073709551615u);
  EXPECT_EQ(options.settings.radiosity.replicates, 32);
  EXPECT_EQ(options.settings.radiosity.max_paths, 1024u);
  EXPECT_DOUBLE_EQ(options.settings.radiosity.time_limit_s, 2.5);
  EXPECT_EQ(options.settings.radiosity.jobs, 3);
  EXPECT_EQ(options.backend.backend, check::Backend::gpu);
}

TEST(Options, GpuStagesBelongToResults) {
  const auto stages = [](const char* list) {
    return parsed({"check", "a.xml", "--backend", "gpu", "--gpu-stages", list});
  };
  const cli::CheckOptions two = stages("near-field,light-paths");
  EXPECT_EQ(two.backend.stages, (check::GpuStages{false, true, false, true}));
  EXPECT_EQ(cli::reproducible_command(two),
            "luxgate check a.xml --backend gpu --gpu-stages light-paths,near-field");
  EXPECT_EQ(cli::reproducible_command(stages("connections,near-field,direct-light,light-paths")),
            "luxgate check a.xml --backend gpu");
  for (const char* wrong : {"", "near", "near-field,", "all"}) {
    expect_usage_error({"check", "a.xml", "--backend", "gpu", "--gpu-stages", wrong},
                       "direct-light, light-paths, connections or near-field");
  }
  expect_usage_error({"check", "a.xml", "--backend", "gpu", "--gpu-stages", "Near-Field"},
                     "did you mean 'near-field'?");
  expect_usage_error(
      {"check", "a.xml", "--backend", "gpu", "--gpu-stages", "near-field,near-field"},
      "near-field is named twice");
  expect_usage_error({"check", "a.xml", "--gpu-stages", "near-field"},
                     "--gpu-stages needs --backend gpu");
}

TEST(Options, BackendsBelongToResults) {
  const cli::CheckOptions gpu = parsed({"check", "a.xml", "--backend", "gpu", "--gl-device", "2"});
  EXPECT_EQ(gpu.backend.gl_device, 2);
  EXPECT_EQ(cli::reproducible_command(gpu), "luxgate check a.xml --backend gpu");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml", "--backend", "cpu"})),
            "luxgate check a.xml --backend cpu");
  const auto plan =
      parsed_by(cli::plan_syntax, {"plan", "a.xml", "--backend", "gpu", "--gl-device", "2"});
  EXPECT_EQ(plan.backend.backend, check::Backend::gpu);
  EXPECT_EQ(plan.backend.gl_device, 2);
  expect_usage_error({"check", "a.xml", "--backend", "auto", "--gl-device", "0"},
                     "--gl-device needs --backend gpu");
  expect_usage_error({"check", "a.xml", "--gl-device", "-1"}, "a whole number from 0 to 1023");
}

TEST(Options, LowersTheFirstLookToTheMostPaths) {
  const cli::CheckOptions options = parsed({"check", "a.xml", "--max-paths", "64"});
  EXPECT_EQ(options.settings.radiosity.first_paths, 64u);
  EXPECT_EQ(calc::validate(options.settings.radiosity), "");
}

// Whatever the command line takes, the check takes.
TEST(Options, EndsOfRangesAreSettingsOfACheck) {
  for (const Words& ends :
       {Words{"check", "a.xml", "--max-paths", "1", "--replicates", "4", "--jobs", "1"},
        Words{"check", "a.xml", "--max-paths", "1073741824", "--replicates", "64", "--jobs",
              "1024"},
        Words{"check", "a.xml", "--max-paths", "2", "--method", "instant-radiosity", "--visibility",
              "shadow-map:16", "--clamp", "1e-300"},
        Words{"check", "a.xml", "--tolerance", "1e-300", "--confidence", "0.5000001",
              "--time-limit", "1e-300"}}) {
    EXPECT_EQ(check::problem_with(parsed(ends).settings), "") << ends[3];
  }
}

TEST(Options, FormatsRepeatWithoutSwallowingProjects) {
  const cli::CheckOptions options =
      parsed({"check", "--format", "json=out.json", "a.xml", "--format", "csv", "b.xml", "--rules",
              "own.xml", "c.xml"});
  ASSERT_EQ(options.output.formats.size(), 2u);
  EXPECT_EQ(options.output.formats[0].format->name, "json");
  EXPECT_EQ(options.output.formats[0].file, "out.json");
  EXPECT_EQ(options.output.formats[1].format->name, "csv");
  EXPECT_EQ(options.output.formats[1].file, "");
  EXPECT_THAT(options.input.projects, ::testing::ElementsAre("a.xml", "b.xml", "c.xml"));
  EXPECT_THAT(options.input.rule_files, ::testing::ElementsAre("own.xml"));
}

TEST(Options, RefusesNumbersThatCannotBeMeant) {
  expect_usage_error({"check", "a.xml", "--tolerance", "0"}, "between 0 and 1");
  expect_usage_error({"check", "a.xml", "--tolerance", "2"}, "between 0 and 1");
  expect_usage_error({"check", "a.xml", "--tolerance", "nan"}, "between 0 and 1");
  expect_usage_error({"check", "a.xml", "--confidence", "0.5"}, "between 0.5 and 1");
  expect_usage_error({"check", "a.xml", "--seed", "18446744073709551616"}, "--seed: '18446744");
  expect_usage_error({"check", "a.xml", "--seed=-1"}, "whole number");
  expect_usage_error({"check", "a.xml", "--max-paths", "1000"}, "power of two");
  expect_usage_error({"check", "a.xml", "--replicates", "2"}, "from 4 to 64");
  expect_usage_error({"check", "a.xml", "--time-limit", "0"}, "above 0");
  expect_usage_error({"check", "a.xml", "--time-limit", "inf"}, "above 0");
  expect_usage_error({"check", "a.xml", "--time-limit", "nan"}, "above 0");
  expect_usage_error({"check", "a.xml", "--jobs", "0"}, "from 1 to");
}

TEST(Options, GeometryTakesFilesUnitsAndAxis) {
  const auto options = parsed_by(cli::geometry_syntax, {"geometry", "a.obj", "b.glb", "--units",
                                                        "mm", "--up", "y", "--strict", "--json"});
  EXPECT_EQ(options.files, (std::vector<std::string>{"a.obj", "b.glb"}));
  EXPECT_EQ(options.mesh_units, "mm");
  EXPECT_EQ(options.mesh_up, "y");
  EXPECT_TRUE(options.strict && options.as_json);
  expect_usage_error({"geometry"}, "missing argument FILE");
  expect_usage_error({"geometry", "a.obj", "--units", "yd"}, "yd");
}

TEST(Options, ErrorsOfCli11BecomeExitCodeTwo) {
  expect_usage_error({}, "luxgate: error: no command given\ntry 'luxgate --help'\n");
  expect_usage_error({"check"}, "no project: PROJECT.xml or --files-from is needed");
  expect_usage_error({"chek", "a.xml"}, "unknown command 'chek'; did you mean 'check'?\n");
  expect_usage_error({"check", "a.xml", "--frmat", "csv"}, "--frmat");
  expect_usage_error({"check", "a.xml", "--seed"}, "option '--seed' needs a value N\n");
}

TEST(Options, UnknownWordsGetTheChoicesAndASuggestion) {
  expect_usage_error({"check", "a.xml", "--format", "jsn"}, "did you mean 'json'?");
  expect_usage_error({"check", "a.xml", "--backend", "cuda"}, "auto, cpu or gpu");
  expect_usage_error({"check", "a.xml", "--goal", "accurcy"}, "did you mean 'accuracy'?");
  expect_usage_error({"check", "a.xml", "--color", "blue"}, "auto, always or never");
}

TEST(Options, LanguageBringsItsDecimalSignUnlessOneIsGiven) {
  const auto words = [](const cli::OutputOptions& options) {
    const report::Texts t = cli::report_texts(options);
    return std::string(t.language_tag()) + " " + t.number("0.5");
  };
  const auto shown = [&](const Words& line) { return words(parsed(line).output); };
  EXPECT_EQ(shown({"check", "a.xml"}), "en 0.5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "en"}), "en 0.5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "de"}), "de 0,5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "fr"}), "fr 0,5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "de", "--decimal", "point"}), "de 0.5");
  EXPECT_EQ(shown({"check", "a.xml", "--decimal", "comma"}), "en 0,5");
  EXPECT_EQ(words(parsed_by(cli::report_syntax, {"report", "a.json", "--language=de"}).output),
            "de 0,5");
  expect_usage_error({"check", "a.xml", "--language", "xx"}, "--language: 'xx'");
  expect_usage_error({"check", "a.xml", "--decimal", ","}, "--decimal: ','");
  expect_usage_error({"plan", "a.xml", "--language", "de"}, "--language");
}

TEST(Options, LanguageIsNotPartOfTheCommandThatMakesTheSameNumbers) {
  const cli::CheckOptions options =
      parsed({"check", "a.xml", "--language", "de", "--decimal", "point"});
  EXPECT_EQ(cli::reproducible_command(options), "luxgate check a.xml");
}

TEST(Options, OnlyOneFormatGoesToStandardOutput) {
  expect_usage_error({"check", "a.xml", "--format", "csv", "--format", "json"}, "only one kind");
}

TEST(Options, RefusesAProjectGivenTwice) {
  expect_usage_error({"check", "a/b.xml", "a/./b.xml"}, "given twice");
}

TEST(Options, ImagesNeedAFolder) { expect_usage_error({"check", "a.xml", "--images"}, "--output"); }

TEST(Options, AProjectMayFollowAnyOption) {
  for (const std::vector<const char*>& option : {std::vector<const char*>{"--seed", "3"},
                                                 {"--tolerance", "5%"},
                                                 {"--goal", "accuracy"},
                                                 {"--jobs", "2"},
                                                 {"--method", "light-pool"},
                                                 {"--no-skip", "all"}}) {
    const cli::CheckOptions options = parsed({"check", "a.xml", option[0], option[1], "b.xml"});
    EXPECT_THAT(options.input.projects, ::testing::ElementsAre("a.xml", "b.xml")) << option[0];
  }
}

TEST(Options, PlanTakesWhatTheWorkDependsOn) {
  const auto options =
      parsed_by(cli::plan_syntax, {"plan", "a.xml", "--jobs", "2", "--max-paths", "2048",
                                   "--no-skip", "convex", "--format", "json", "b.xml"});
  EXPECT_THAT(options.input.projects, ::testing::ElementsAre("a.xml", "b.xml"));
  EXPECT_EQ(options.radiosity.max_paths, 2048u);
  EXPECT_TRUE(options.as_json);
  EXPECT_FALSE(parsed_by(cli::plan_syntax, {"plan", "a.xml"}).as_json);
  expect_usage_error({"plan", "a.xml", "--format", "html"}, "text or json is needed");
}

TEST(Options, NoSkipForbidsOneOrAllAndNamesTheChoices) {
  EXPECT_EQ(parsed({"check", "a.xml"}).settings.radiosity.skips, calc::SkipSet());
  const cli::CheckOptions options =
      parsed({"check", "a.xml", "--no-skip", "convex", "--no-skip", "dark-pairs", "b.xml"});
  calc::SkipSet expected;
  expected.forbid(calc::Skip::convex);
  expected.forbid(calc::Skip::dark_pairs);
  EXPECT_EQ(options.settings.radiosity.skips, expected);
  EXPECT_EQ(cli::reproducible_command(options),
            "luxgate check a.xml b.xml --no-skip dark-pairs --no-skip convex");
  const cli::CheckOptions none = parsed({"check", "a.xml", "--no-skip", "all"});
  expected.forbid_all();
  EXPECT_EQ(none.settings.radiosity.skips, expected);
  EXPECT_EQ(cli::reproducible_command(none), "luxgate check a.xml --no-skip all");
  expect_usage_error({"check", "a.xml", "--no-skip", "convx"},
                     "--no-skip: 'convx': unknown value; did you mean 'convex'?\n");
  expect_usage_error({"check", "a.xml", "--no-skip", "zzzzzz"},
                     "no-reflection, behind-plane, unlit-surfaces, dark-pairs, convex, "
                     "hidden-nodes, clear-distance, decided-points or all is needed");
}

TEST(Options, TheMethodIsPartOfTheReproducibleCommand) {
  EXPECT_EQ(parsed({"check", "a.xml"}).settings.radiosity.method, calc::Method::light_pool);
  const cli::CheckOptions options = parsed({"check", "a.xml", "--method", "instant-radiosity"});
  EXPECT_EQ(options.settings.radiosity.method, calc::Method::instant_radiosity);
  EXPECT_EQ(cli::reproducible_command(options), "luxgate check a.xml --method instant-radiosity");
  expect_usage_error({"check", "a.xml", "--method", "radiance"},
                     "light-pool or instant-radiosity is needed");
}

TEST(Options, HelpIsNoErrorAndNamesTheExitCodes) {
  const cli::TestLine result = cli::parse_words({"check", "--help"});
  EXPECT_FALSE(result.is_good);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("undecided"));
  EXPECT_THAT(result.out, HasSubstr("--tolerance SHARE"));
  EXPECT_THAT(result.out, HasSubstr("--goal NAME"));
}

TEST(Options, TakesTheDateFromTheEnvironmentUnlessGiven) {
  const cli::CheckOptions noon = parsed_by(cli::check_syntax, {"check", "a.xml"}, "1714564800");
  EXPECT_EQ(noon.timestamp, "2024-05-01T12:00:00Z");
  EXPECT_EQ(noon.settings.today, "2024-05-01");
  EXPECT_EQ(
      parsed_by(cli::check_syntax, {"check", "a.xml", "--timestamp", "0"}, "1714564800").timestamp,
      "1970-01-01T00:00:00Z");
  EXPECT_EQ(parsed({"check", "a.xml"}).settings.today, "");
  EXPECT_EQ(cli::parse_words({"check", "a.xml"}, "yesterday").exit_code, 2);
  EXPECT_EQ(cli::parse_words({"check", "a.xml"}, "now").exit_code, 2);
}

TEST(Options, ReproducibleCommandHoldsWhatChangesResultsOnly) {
  const cli::CheckOptions options =
      parsed({"check", "it's mine.xml", "--jobs", "4", "--quiet", "--format", "json", "--seed", "7",
              "--tolerance", "1%"});
  EXPECT_EQ(cli::reproducible_command(options),
            "luxgate check 'it'\\''s mine.xml' --seed 7 --tolerance 0.01");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml"})), "luxgate check a.xml");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml", "--goal", "accuracy"})),
            "luxgate check a.xml --goal accuracy");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml", "--goal", "verdict"})),
            "luxgate check a.xml");
}

TEST(Options, ReadsThePhotometryCommand) {
  const auto options = parsed_by(cli::photometry_syntax, {"photometry", "a.ies", "b.ldt",
                                                          "--compare", "--json", "--strict", "-q"});
  EXPECT_THAT(options.files, ::testing::ElementsAre("a.ies", "b.ldt"));
  EXPECT_EQ(options.format, cli::PhotometryFormat::json);
  EXPECT_TRUE(options.compare && options.strict && options.quiet);
  EXPECT_EQ(
      parsed_by(cli::photometry_syntax, {"photometry", "a.ies", "--convert", "b.LDT"}).convert_file,
      "b.LDT");
  const auto chosen =
      parsed_by(cli::photometry_syntax,
                {"photometry", "--lamp-set", "2", "--variant", "v1", "--emitter", "e#2", "a.gldf"});
  EXPECT_EQ(chosen.lamp_set, 2);
  EXPECT_EQ(chosen.variant, "v1");
  EXPECT_EQ(chosen.emitter, "e#2");
  EXPECT_THAT(chosen.files, ::testing::ElementsAre("a.gldf"));
}

TEST(Options, RefusesPhotometryOptionsThatContradict) {
  expect_usage_error({"photometry"}, "missing argument ");
  expect_usage_error({"photometry", "a.ies", "--json", "--csv"}, "' cannot be used with '--");
  expect_usage_error({"photometry", "a.ies", "--compare"}, "--compare needs two FILEs; found 1");
  expect_usage_error({"photometry", "a", "b", "c", "--compare"}, "found 3");
  expect_usage_error({"photometry", "a", "b", "--compare", "--csv"}, "use --json");
  expect_usage_error({"photometry", "a", "b", "--convert", "c.ies"}, "--convert is for one FILE");
  expect_usage_error({"photometry", "a", "--convert", "c.txt"}, "must end with .ies or .ldt");
  expect_usage_error({"photometry", "a", "--polar", "c.gif"}, "must end with .svg or .png");
  expect_usage_error({"photometry", "a", "--lamp-set", "0"}, "a whole number from 1 to 1000000");
  expect_usage_error({"photometry", "a", "--variant", ""}, "a name is needed");
}

}  // namespace
}  // namespace command_line_test
