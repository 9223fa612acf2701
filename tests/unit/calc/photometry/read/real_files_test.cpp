// Optional: reads a collection of foreign files outside the repository, named by
// LUXGATE_SHARED_DATA. Its manifest.csv holds each file's flux, integrated by another program.

#include "calc/base/file_reader.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web_sampling.h"
#include "tests/support/photometry_manifest.h"
#include "tests/support/photometry_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace calc::real_files_test {
namespace {

using test_support::read_manifest;
using test_support::Row;

struct Deviation {
  double share;
  std::string file;
};

void print_deviations(const char* what, std::vector<Deviation> deviations) {
  if (deviations.empty()) return;
  std::sort(deviations.begin(), deviations.end(),
            [](const Deviation& a, const Deviation& b) { return a.share < b.share; });
  std::printf("%s: %zu files, flux off by %.2g median, %.2g at 95 %%, %.2g at worst (%s)\n", what,
              deviations.size(), deviations[deviations.size() / 2].share,
              deviations[deviations.size() * 95 / 100].share, deviations.back().share,
              deviations.back().file.c_str());
}

// Every LM-63 and EULUMDAT file is read, or refused with a reason.
TEST(RealPhotometryFiles, AreReadWithTheFluxOfAnotherProgram) {
  const char* shared = std::getenv("LUXGATE_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const std::string folder = std::string(shared) + "/photometry/";
  const DiskFileReader files;
  const FileContent manifest = files.read(folder + "manifest.csv");
  if (!manifest.ok()) GTEST_SKIP() << "no manifest.csv in " << folder;

  std::map<std::string, int> counts;
  std::map<std::string, std::vector<Deviation>> deviations;  // by category
  for (const Row& row : read_manifest(manifest.bytes)) {
    if (row.at("format") != "IES" && row.at("format") != "LDT") continue;
    const std::string& file = row.at("file");
    const FileContent content = files.read(folder + file);
    ASSERT_TRUE(content.ok()) << file;
    Diagnostics diagnostics;
    PhotometryOptions options;
    options.read_companion = [&](const std::string& name) -> std::optional<std::string> {
      const FileContent companion = files.read(folder + file.substr(0, file.rfind('/') + 1) + name);
      return companion.ok() ? std::optional(companion.bytes) : std::nullopt;
    };
    const std::optional<PhotometricWeb> web =
        parse_photometry(content.bytes, file, diagnostics, options);
    EXPECT_EQ(!web, diagnostics.has_errors()) << file;
    ++counts[row.at("category") + " " + row.at("format") + (web ? " read" : " refused")];
    const std::string messages = test_support::diagnostics_text(diagnostics);
    if (std::getenv("LUXGATE_VERBOSE") != nullptr) std::fputs(messages.c_str(), stderr);
    if (!web) {
      EXPECT_NE(messages.find("error["), std::string::npos) << file;
      EXPECT_NE(row.at("category"), "real") << messages;
      continue;
    }
    EXPECT_NEAR(WebSampler(*web).c_prefix().back() / web->flux_lm(), 1.0, 1e-12) << file;
    const std::string& expected = row.at("flux_lm_linear_angle");
    if (expected.empty()) continue;
    const double off = std::abs(web->flux_lm() / std::stod(expected) - 1.0);
    EXPECT_LT(off, 1e-5) << file;
    deviations[row.at("category")].push_back({off, file});
    deviations["all"].push_back({off, file});
  }
  for (const auto& [what, count] : counts) std::printf("%s: %d\n", what.c_str(), count);
  for (const auto& [category, list] : deviations) print_deviations(category.c_str(), list);
}

// What becomes of a file without a choice: its flux, or part of the message that refuses it.
struct Outcome {
  const char* file;
  double flux_lm;  // 0 = refused
  const char* message;
  const char* variant = "";
  const char* emitter = "";

  // Names of tests, which bytes of addresses would change from run to run.
  friend void PrintTo(const Outcome& outcome, std::ostream* out) {
    *out << outcome.file << ' ' << outcome.variant << outcome.emitter;
  }
};

class RealXmlAndContainers : public testing::TestWithParam<Outcome> {};

TEST_P(RealXmlAndContainers, AreReadOrRefusedWithTheRightReason) {
  const Outcome& expected = GetParam();
  const char* shared = std::getenv("LUXGATE_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const FileContent content =
      DiskFileReader().read(std::string(shared) + "/photometry/" + expected.file);
  if (!content.ok()) GTEST_SKIP() << expected.file << ": " << content.error;
  Diagnostics diagnostics;
  PhotometryOptions options;
  options.variant = expected.variant;
  options.emitter = expected.emitter;
  const auto web = parse_photometry(content.bytes, expected.file, diagnostics, options);
  const std::string messages = test_support::diagnostics_text(diagnostics);
  if (std::getenv("LUXGATE_VERBOSE") != nullptr)
    std::printf("%s: %g lm\n%s", expected.file, web ? web->flux_lm() : 0.0, messages.c_str());
  ASSERT_EQ(web.has_value(), expected.flux_lm > 0.0) << messages;
  EXPECT_NE(messages.find(expected.message), std::string::npos) << messages;
  if (web) {
    EXPECT_NEAR(web->flux_lm() / expected.flux_lm, 1.0, 5e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealXmlAndContainers,
    testing::Values(
        Outcome{"tm33/eurs__minimal.xml", 974.24, "[photometry-outer-size]"},
        Outcome{"tm33/eurs__fluorescent.xml", 803.0, "[photometry-low-flux]"},
        Outcome{"tm33/eurs__with_custom_data.xml", 659.73, "[photometry-no-area]"},
        Outcome{"tm33/eurs__road_luminaire_bim.xml", 2100.3, "states 684, but the data have 24"},
        Outcome{"gldf/gldfnet__GldfWithFilesComplete.gldf", 0, "emitter-1#1, emitter-1#2"},
        Outcome{"gldf/gldfnet__GldfWithFilesComplete.gldf", 6300 * 0.6425,
                "[photometry-not-applied]", "", "emitter-1#2"},
        Outcome{"gldf/gldfnet__GldfWithInvalidRoot.gldf", 0, "error[gldf-content-type]"},
        Outcome{"gldf/gldfnet__GldfWithMissingProduct.gldf", 0, "has no 'product.xml'"},
        Outcome{"gldf/gldfrs__Just_URLs.gldf", 0, "error[gldf-url]"},
        Outcome{"gldf/gldfrs__Philips_SP542P_0.9_DEMO.gldf", 6600, "photometry file was kept"},
        Outcome{"gldf/gldfrs__full_demo.gldf", 0, "choose one with 'variant'"},
        Outcome{"gldf/gldfrs__full_demo.gldf", 0, "emitter01#1", "lui_k30x60", ""},
        Outcome{"gldf/gldfrs__full_demo.gldf", 810, "", "lui_zoom_max", ""},
        Outcome{"gldf/gldfrs__full_demo.gldf", 700, "", "lui_k30x60", "emitter01#2"},
        Outcome{"gldf/gldfrs__igz___p450.gldf", 2000 * 0.54, ""}));

}  // namespace
}  // namespace calc::real_files_test
