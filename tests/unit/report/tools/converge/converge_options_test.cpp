#include "report/tools/converge/converge_options.h"

#include "report/tools/check/check_options.h"
#include "report/tools/vpl/vpl_options.h"
#include "tests/support/command_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cli::converge_options_test {
namespace {

using testing::HasSubstr;

TEST(ConvergeOptions, AreRead) {
  ConvergeOptions options;
  const TestLine result =
      parse_words(converge_syntax, options,
                  {"converge",     "a.xml", "--methods",   "path-tracing,shadow-map:64,gpu",
                   "--reference",  "r.csv", "--part",      "indirect",
                   "--min-paths",  "32",    "--max-paths", "128",
                   "--replicates", "8",     "--seeds",     "3",
                   "--seed",       "7",     "--clamp",     "2.5",
                   "--space",      "s",     "--plane",     "p",
                   "--plane",      "q",     "--jobs",      "2",
                   "--gl-device",  "1",     "--format",    "html=x.html",
                   "--format",     "csv"});
  ASSERT_TRUE(result.is_good) << result.err;
  EXPECT_EQ(options.project, "a.xml");
  EXPECT_EQ(options.methods, (std::vector<std::string>{"path-tracing", "shadow-map:64", "gpu"}));
  EXPECT_EQ(options.reference, "r.csv");
  EXPECT_TRUE(options.is_indirect);
  EXPECT_EQ(options.min_paths, 32u);
  EXPECT_EQ(options.max_paths, 128u);
  EXPECT_EQ(options.replicates, 8);
  EXPECT_EQ(options.seeds, 3);
  EXPECT_EQ(options.seed, 7u);
  EXPECT_EQ(options.clamp_per_m2, 2.5);
  EXPECT_EQ(options.space, "s");
  EXPECT_EQ(options.planes, (std::vector<std::string>{"p", "q"}));
  EXPECT_EQ(options.jobs, 2);
  EXPECT_EQ(options.gl_device, 1);
  ASSERT_EQ(options.outputs.size(), 2u);
  EXPECT_EQ(options.outputs[0].file, "x.html");
  EXPECT_EQ(options.outputs[1].kind, DataFormat::csv);
}

TEST(ConvergeOptions, BadOnesAreRefused) {
  const auto problem = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"converge", "a.xml"});
    const TestLine result = parse_words(words);
    EXPECT_FALSE(result.is_good);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  };
  EXPECT_THAT(problem({"--methods", "core,radiance"}), HasSubstr("radiance"));
  EXPECT_THAT(problem({"--methods", "core,core"}), HasSubstr("given twice"));
  EXPECT_THAT(problem({"--methods", ""}), HasSubstr("core"));
  EXPECT_THAT(problem({"--methods", "shadow-map:100"}), HasSubstr("power of two from 16 to 2048"));
  EXPECT_THAT(problem({"--methods", "shadow-map:N"}), HasSubstr("power of two"));
  EXPECT_THAT(problem({"--methods", "shadow-map:64,core,shadow-map:64"}), HasSubstr("given twice"));
  EXPECT_THAT(problem({"--gl-device", "0"}), HasSubstr("gpu and shadow-map:N"));
  EXPECT_THAT(problem({"--min-paths", "100"}), HasSubstr("power of two"));
  EXPECT_THAT(problem({"--min-paths", "256", "--max-paths", "64"}), HasSubstr("less than"));
  EXPECT_THAT(problem({"--replicates", "3"}), HasSubstr("4"));
  EXPECT_THAT(problem({"--seeds", "0"}), HasSubstr("1"));
  EXPECT_THAT(problem({"--clamp", "0"}), HasSubstr("above 0"));
  EXPECT_THAT(problem({"--format", "pdf"}), HasSubstr("html"));
  EXPECT_THAT(problem({"--format", "html="}), HasSubstr("file name"));
  EXPECT_THAT(problem({"--format", "csv", "--format", "text"}), HasSubstr("only one kind"));
  EXPECT_THAT(problem({"--reference", "r.csv", "--reference-paths", "64"}),
              HasSubstr("--reference own"));
}

TEST(VplOptions, AreReadAndChecked) {
  VplOptions vpl;
  const TestLine good = parse_words(vpl_syntax, vpl,
                                    {"vpl", "a.xml", "-o", "x.ply", "--paths", "64", "--seed", "5",
                                     "--replicates", "1", "--space", "hall"});
  ASSERT_TRUE(good.is_good) << good.err;
  EXPECT_EQ(vpl.output, "x.ply");
  EXPECT_EQ(vpl.radiosity.max_paths, 64u);
  EXPECT_EQ(vpl.radiosity.seed, 5u);
  EXPECT_EQ(vpl.radiosity.replicates, 1);
  EXPECT_EQ(vpl.space, "hall");
  EXPECT_THAT(parse_words({"vpl", "a.xml"}).err, HasSubstr("-o FILE.ply is needed"));
  EXPECT_THAT(parse_words({"vpl", "a.xml", "-o", "x", "--paths", "65"}).err,
              HasSubstr("power of two"));
  EXPECT_FALSE(parse_words({"vpl"}).is_good);
  VplOptions view;
  const TestLine drawn =
      parse_words(vpl_syntax, view, {"vpl", "a.xml", "--view", "x.PNG", "--gl-device", "0"});
  ASSERT_TRUE(drawn.is_good) << drawn.err;
  EXPECT_EQ(view.view, "x.PNG");
  EXPECT_EQ(view.gl_device, 0);
  EXPECT_TRUE(parse_words({"vpl", "a.xml", "-o", "x.ply", "--view", "x.exr"}).is_good);
  EXPECT_THAT(parse_words({"vpl", "a.xml", "--view", "x.jpg"}).err, HasSubstr(".png or .exr"));
  EXPECT_THAT(parse_words({"vpl", "a.xml", "-o", "x", "--gl-device", "0"}).err,
              HasSubstr("for --view"));
}

TEST(CheckOptions, AFileOfVerticesFixesSeedReplicatesAndPaths) {
  CheckOptions check;
  EXPECT_TRUE(parse_words(check_syntax, check, {"check", "a.xml", "--vpl", "x.ply"}).is_good);
  EXPECT_EQ(check.vpl_file, "x.ply");
  for (const char* name : {"--seed", "--replicates", "--max-paths"}) {
    const TestLine result = parse_words({"check", "a.xml", "--vpl", "x.ply", name, "16"});
    EXPECT_FALSE(result.is_good) << name;
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr(name));
  }
  EXPECT_THAT(parse_words({"check", "a.xml", "b.xml", "--vpl", "x.ply"}).err,
              HasSubstr("--vpl is for one project; found 2"));
}

}  // namespace
}  // namespace cli::converge_options_test
