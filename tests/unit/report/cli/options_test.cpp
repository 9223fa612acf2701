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
  EXPECT_DOUBLE_EQ(options.tolerance, 0.02);
  EXPECT_DOUBLE_EQ(options.confidence, 0.95);
  EXPECT_EQ(options.radiosity.seed, 1u);
  EXPECT_EQ(options.radiosity.replicates, 16);
  EXPECT_EQ(options.radiosity.max_paths, 65536u);
  EXPECT_EQ(options.backend, cli::Backend::cpu);
  EXPECT_EQ(options.timestamp, "");
}

TEST(Options, ReadsEveryCalculationSetting) {
  const cli::Options options =
      parsed({"check", "a.xml", "--tolerance", "5%", "--confidence=0.99", "--seed",
              "18446744073709551615", "--replicates", "32", "--max-paths", "1024", "--time-limit",
              "2.5", "--jobs", "3", "--backend", "gpu"});
  EXPECT_DOUBLE_EQ(options.tolerance, 0.05);
  EXPECT_DOUBLE_EQ(options.confidence, 0.99);
  EXPECT_EQ(options.radiosity.seed, 18446744073709551615u);
  EXPECT_EQ(options.radiosity.replicates, 32);
  EXPECT_EQ(options.radiosity.max_paths, 1024u);
  EXPECT_DOUBLE_EQ(options.radiosity.time_limit_s, 2.5);
  EXPECT_EQ(options.radiosity.jobs, 3);
  EXPECT_EQ(options.backend, cli::Backend::gpu);
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

TEST(Options, ErrorsOfCli11BecomeExitCodeTwo) {
  expect_usage_error({}, "no command: check, validate,");
  expect_usage_error({"check"}, "projects");
  expect_usage_error({"chek", "a.xml"}, "did you mean 'check'?");
  expect_usage_error({"check", "a.xml", "--frmat", "csv"}, "--frmat");
  expect_usage_error({"check", "a.xml", "--seed"}, "--seed");
}

TEST(Options, UnknownWordsGetTheChoicesAndASuggestion) {
  expect_usage_error({"check", "a.xml", "--format", "jsn"}, "did you mean 'json'?");
  expect_usage_error({"check", "a.xml", "--backend", "cuda"}, "cpu or gpu");
  expect_usage_error({"check", "a.xml", "--color", "blue"}, "auto, always or never");
}

TEST(Options, OnlyOneFormatGoesToStandardOutput) {
  expect_usage_error({"check", "a.xml", "--format", "csv", "--format", "json"}, "only one kind");
}

TEST(Options, RefusesAProjectGivenTwice) {
  expect_usage_error({"check", "a/b.xml", "a/./b.xml"}, "given twice");
}

TEST(Options, ImagesNeedAFolder) { expect_usage_error({"check", "a.xml", "--images"}, "--output"); }

TEST(Options, HelpIsNoErrorAndNamesTheExitCodes) {
  const cli::ParseResult result = parse({"check", "--help"});
  EXPECT_FALSE(result.options.has_value());
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("undecided"));
  EXPECT_THAT(result.out, HasSubstr("--tolerance SHARE"));
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
}

}  // namespace
