#include "report/cli/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace {

using ::testing::HasSubstr;

cli::ParseResult parse(std::initializer_list<const char*> arguments,
                       const std::string& source_date_epoch = "") {
  std::vector<const char*> argv = {"/somewhere/luxgate"};
  argv.insert(argv.end(), arguments);
  return cli::parse_options(static_cast<int>(argv.size()), argv.data(), source_date_epoch);
}

cli::Options parsed(std::initializer_list<const char*> arguments) {
  const cli::ParseResult result = parse(arguments);
  EXPECT_TRUE(result.options.has_value()) << result.err;
  return result.options.value_or(cli::Options{});
}

void expect_usage_error(std::initializer_list<const char*> arguments, const std::string& part) {
  const cli::ParseResult result = parse(arguments);
  EXPECT_FALSE(result.options.has_value());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("luxgate: error: "));
  EXPECT_THAT(result.err, HasSubstr(part));
}

TEST(Options, HasTheDocumentedDefaults) {
  const cli::Options options = parsed({"check", "a.xml", "b/c.xml"});
  EXPECT_EQ(options.command, cli::Command::check);
  EXPECT_THAT(options.projects, ::testing::ElementsAre("a.xml", "b/c.xml"));
  EXPECT_TRUE(options.formats.empty());
  EXPECT_EQ(options.goal, rules::Goal::verdict);
  EXPECT_DOUBLE_EQ(options.tolerance, 0.02);
  EXPECT_DOUBLE_EQ(options.confidence, 0.95);
  EXPECT_EQ(options.radiosity.seed, 1u);
  EXPECT_EQ(options.radiosity.replicates, 16);
  EXPECT_EQ(options.radiosity.max_paths, 65536u);
  EXPECT_EQ(options.backend, cli::Backend::automatic);
  EXPECT_EQ(options.gl_device, -1);
  EXPECT_EQ(options.timestamp, "");
}

TEST(Options, ReadsEveryCalculationSetting) {
  const cli::Options options =
      parsed({"check", "a.xml", "--goal", "accuracy", "--tolerance", "5%", "--confidence=0.99",
              "--seed", "18446744073709551615", "--replicates", "32", "--max-paths", "1024",
              "--time-limit", "2.5", "--jobs", "3", "--backend", "gpu"});
  EXPECT_EQ(options.goal, rules::Goal::accuracy);
  EXPECT_DOUBLE_EQ(options.tolerance, 0.05);
  EXPECT_DOUBLE_EQ(options.confidence, 0.99);
  EXPECT_EQ(options.radiosity.seed, 18446744073709551615u);
  EXPECT_EQ(options.radiosity.replicates, 32);
  EXPECT_EQ(options.radiosity.max_paths, 1024u);
  EXPECT_DOUBLE_EQ(options.radiosity.time_limit_s, 2.5);
  EXPECT_EQ(options.radiosity.jobs, 3);
  EXPECT_EQ(options.backend, cli::Backend::gpu);
}

TEST(Options, GpuStagesBelongToResults) {
  const auto stages = [](const char* list) {
    return parsed({"check", "a.xml", "--backend", "gpu", "--gpu-stages", list});
  };
  const cli::Options two = stages("near-field,light-paths");
  EXPECT_EQ(two.gpu_stages, (cli::GpuStages{true, false, true}));
  EXPECT_EQ(cli::reproducible_command(two),
            "luxgate check a.xml --backend gpu --gpu-stages light-paths,near-field");
  EXPECT_EQ(cli::reproducible_command(stages("connections,near-field,light-paths")),
            "luxgate check a.xml --backend gpu");
  for (const char* wrong : {"", "near", "near-field,", "Near-Field", "all"}) {
    expect_usage_error({"check", "a.xml", "--backend", "gpu", "--gpu-stages", wrong},
                       "light-paths, connections or near-field");
  }
  expect_usage_error(
      {"check", "a.xml", "--backend", "gpu", "--gpu-stages", "near-field,near-field"},
      "near-field is named twice");
  expect_usage_error({"check", "a.xml", "--gpu-stages", "near-field"},
                     "--gpu-stages needs --backend gpu");
}

TEST(Options, BackendsBelongToResults) {
  for (const char* command : {"check", "plan"}) {
    const cli::Options gpu = parsed({command, "a.xml", "--backend", "gpu", "--gl-device", "2"});
    EXPECT_EQ(gpu.gl_device, 2);
    EXPECT_EQ(cli::reproducible_command(gpu), "luxgate check a.xml --backend gpu");
    EXPECT_EQ(cli::reproducible_command(parsed({command, "a.xml", "--backend", "cpu"})),
              "luxgate check a.xml --backend cpu");
  }
  expect_usage_error({"check", "a.xml", "--backend", "auto", "--gl-device", "0"},
                     "--gl-device needs --backend gpu");
  expect_usage_error({"check", "a.xml", "--gl-device", "-1"}, "a whole number from 0 to 1023");
}

TEST(Options, LowersTheFirstLookToTheMostPaths) {
  const cli::Options options = parsed({"check", "a.xml", "--max-paths", "64"});
  EXPECT_EQ(options.radiosity.first_paths, 64u);
  EXPECT_EQ(calc::validate(options.radiosity), "");
}

TEST(Options, FormatsRepeatWithoutSwallowingProjects) {
  const cli::Options options = parsed({"check", "--format", "json=out.json", "a.xml", "--format",
                                       "csv", "b.xml", "--rules", "own.xml", "c.xml"});
  ASSERT_EQ(options.formats.size(), 2u);
  EXPECT_EQ(options.formats[0].kind, cli::FormatKind::json);
  EXPECT_EQ(options.formats[0].file, "out.json");
  EXPECT_EQ(options.formats[1].kind, cli::FormatKind::csv);
  EXPECT_EQ(options.formats[1].file, "");
  EXPECT_THAT(options.projects, ::testing::ElementsAre("a.xml", "b.xml", "c.xml"));
  EXPECT_THAT(options.rule_files, ::testing::ElementsAre("own.xml"));
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
  expect_usage_error({"check", "a.xml", "--jobs", "0"}, "from 1 to");
}

TEST(Options, GeometryTakesFilesUnitsAndAxis) {
  const cli::Options options =
      parsed({"geometry", "a.obj", "b.glb", "--units", "mm", "--up", "y", "--strict", "--json"});
  EXPECT_EQ(options.command, cli::Command::geometry);
  EXPECT_EQ(options.geometry_files, (std::vector<std::string>{"a.obj", "b.glb"}));
  EXPECT_EQ(options.mesh_units, "mm");
  EXPECT_EQ(options.mesh_up, "y");
  EXPECT_TRUE(options.strict && options.geometry_as_json);
  expect_usage_error({"geometry"}, "files");
  expect_usage_error({"geometry", "a.obj", "--units", "yd"}, "yd");
}

TEST(Options, ErrorsOfCli11BecomeExitCodeTwo) {
  expect_usage_error({}, "no command: check, report, plan, validate, vpl, converge,");
  expect_usage_error({"check"}, "projects");
  expect_usage_error({"chek", "a.xml"}, "did you mean 'check'?");
  expect_usage_error({"check", "a.xml", "--frmat", "csv"}, "--frmat");
  expect_usage_error({"check", "a.xml", "--seed"}, "--seed");
}

TEST(Options, UnknownWordsGetTheChoicesAndASuggestion) {
  expect_usage_error({"check", "a.xml", "--format", "jsn"}, "did you mean 'json'?");
  expect_usage_error({"check", "a.xml", "--backend", "cuda"}, "auto, cpu or gpu");
  expect_usage_error({"check", "a.xml", "--goal", "accurcy"}, "did you mean 'accuracy'?");
  expect_usage_error({"check", "a.xml", "--color", "blue"}, "auto, always or never");
}

TEST(Options, LanguageBringsItsDecimalSignUnlessOneIsGiven) {
  const auto shown = [](std::initializer_list<const char*> arguments) {
    const report::Texts t = cli::report_texts(parsed(arguments));
    return std::string(t.language_tag()) + " " + t.number("0.5");
  };
  EXPECT_EQ(shown({"check", "a.xml"}), "en 0.5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "en"}), "en 0.5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "de"}), "de 0,5");
  EXPECT_EQ(shown({"check", "a.xml", "--language", "de", "--decimal", "point"}), "de 0.5");
  EXPECT_EQ(shown({"check", "a.xml", "--decimal", "comma"}), "en 0,5");
  EXPECT_EQ(shown({"report", "a.json", "--language=de"}), "de 0,5");
  expect_usage_error({"check", "a.xml", "--language", "fr"}, "--language: 'fr'");
  expect_usage_error({"check", "a.xml", "--decimal", ","}, "--decimal: ','");
  expect_usage_error({"plan", "a.xml", "--language", "de"}, "--language");
}

TEST(Options, LanguageIsNotPartOfTheCommandThatMakesTheSameNumbers) {
  const cli::Options options = parsed({"check", "a.xml", "--language", "de", "--decimal", "point"});
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
    const std::vector<const char*> argv = {"luxgate", "check",   "a.xml",
                                           option[0], option[1], "b.xml"};
    const cli::ParseResult result = cli::parse_options(6, argv.data(), "");
    ASSERT_TRUE(result.options.has_value()) << result.err;
    EXPECT_THAT(result.options->projects, ::testing::ElementsAre("a.xml", "b.xml")) << option[0];
  }
}

TEST(Options, PlanTakesWhatTheWorkDependsOn) {
  const cli::Options options = parsed({"plan", "a.xml", "--jobs", "2", "--max-paths", "2048",
                                       "--no-skip", "convex", "--format", "json", "b.xml"});
  EXPECT_EQ(options.command, cli::Command::plan);
  EXPECT_THAT(options.projects, ::testing::ElementsAre("a.xml", "b.xml"));
  EXPECT_EQ(options.radiosity.max_paths, 2048u);
  EXPECT_TRUE(options.plan_as_json);
  EXPECT_FALSE(parsed({"plan", "a.xml"}).plan_as_json);
  expect_usage_error({"plan", "a.xml", "--format", "html"}, "text or json is needed");
}

TEST(Options, NoSkipForbidsOneOrAllAndNamesTheChoices) {
  EXPECT_EQ(parsed({"check", "a.xml"}).radiosity.skips, calc::SkipSet());
  const cli::Options options =
      parsed({"check", "a.xml", "--no-skip", "convex", "--no-skip", "dark-pairs", "b.xml"});
  calc::SkipSet expected;
  expected.forbid(calc::Skip::convex);
  expected.forbid(calc::Skip::dark_pairs);
  EXPECT_EQ(options.radiosity.skips, expected);
  EXPECT_EQ(cli::reproducible_command(options),
            "luxgate check a.xml b.xml --no-skip dark-pairs --no-skip convex");
  const cli::Options none = parsed({"check", "a.xml", "--no-skip", "all"});
  expected.forbid_all();
  EXPECT_EQ(none.radiosity.skips, expected);
  EXPECT_EQ(cli::reproducible_command(none), "luxgate check a.xml --no-skip all");
  expect_usage_error({"check", "a.xml", "--no-skip", "convx"},
                     "no-reflection, behind-plane, unlit-surfaces, dark-pairs, convex, "
                     "hidden-nodes, clear-distance, decided-points or all is needed; did you mean "
                     "'convex'?");
}

TEST(Options, TheMethodIsPartOfTheReproducibleCommand) {
  EXPECT_EQ(parsed({"check", "a.xml"}).radiosity.method, calc::Method::light_pool);
  const cli::Options options = parsed({"check", "a.xml", "--method", "instant-radiosity"});
  EXPECT_EQ(options.radiosity.method, calc::Method::instant_radiosity);
  EXPECT_EQ(cli::reproducible_command(options), "luxgate check a.xml --method instant-radiosity");
  expect_usage_error({"check", "a.xml", "--method", "radiance"},
                     "light-pool or instant-radiosity is needed");
}

TEST(Options, HelpIsNoErrorAndNamesTheExitCodes) {
  const cli::ParseResult result = parse({"check", "--help"});
  EXPECT_FALSE(result.options.has_value());
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("undecided"));
  EXPECT_THAT(result.out, HasSubstr("--tolerance SHARE"));
  EXPECT_THAT(result.out, HasSubstr("--goal NAME"));
}

TEST(Options, TakesTheDateFromTheEnvironmentUnlessGiven) {
  EXPECT_EQ(parse({"check", "a.xml"}, "1714564800").options->timestamp, "2024-05-01T12:00:00Z");
  EXPECT_EQ(parse({"check", "a.xml", "--timestamp", "0"}, "1714564800").options->timestamp,
            "1970-01-01T00:00:00Z");
  EXPECT_EQ(parse({"check", "a.xml"}, "yesterday").exit_code, 2);
  EXPECT_EQ(parse({"check", "a.xml"}, "now").exit_code, 2);
}

TEST(Options, ReproducibleCommandHoldsWhatChangesResultsOnly) {
  const cli::Options options = parsed({"check", "it's mine.xml", "--jobs", "4", "--quiet",
                                       "--format", "json", "--seed", "7", "--tolerance", "1%"});
  EXPECT_EQ(cli::reproducible_command(options),
            "luxgate check 'it'\\''s mine.xml' --seed 7 --tolerance 0.01");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml"})), "luxgate check a.xml");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml", "--goal", "accuracy"})),
            "luxgate check a.xml --goal accuracy");
  EXPECT_EQ(cli::reproducible_command(parsed({"check", "a.xml", "--goal", "verdict"})),
            "luxgate check a.xml");
}

TEST(Options, ReadsThePhotometryCommand) {
  const cli::Options options =
      parsed({"photometry", "a.ies", "b.ldt", "--compare", "--json", "--strict", "-q"});
  EXPECT_EQ(options.command, cli::Command::photometry);
  EXPECT_THAT(options.photometry.files, ::testing::ElementsAre("a.ies", "b.ldt"));
  EXPECT_EQ(options.photometry.format, cli::PhotometryFormat::json);
  EXPECT_TRUE(options.photometry.compare && options.photometry.strict && options.quiet);
  EXPECT_EQ(parsed({"photometry", "a.ies", "--convert", "b.LDT"}).photometry.convert_file, "b.LDT");
  const cli::PhotometryOptions chosen =
      parsed({"photometry", "--lamp-set", "2", "--variant", "v1", "--emitter", "e#2", "a.gldf"})
          .photometry;
  EXPECT_EQ(chosen.lamp_set, 2);
  EXPECT_EQ(chosen.variant, "v1");
  EXPECT_EQ(chosen.emitter, "e#2");
  EXPECT_THAT(chosen.files, ::testing::ElementsAre("a.gldf"));
}

TEST(Options, RefusesPhotometryOptionsThatContradict) {
  expect_usage_error({"photometry"}, "files is required");
  expect_usage_error({"photometry", "a.ies", "--json", "--csv"}, "excludes");
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
