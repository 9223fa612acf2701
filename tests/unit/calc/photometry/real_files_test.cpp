// Optional: reads a collection of foreign files outside the repository, named by
// LUXGATE_SHARED_DATA. Its manifest.csv holds each file's flux, integrated by another program.

#include "calc/file_reader.h"
#include "calc/photometry/photometry_file.h"
#include "calc/photometry/web_sampling.h"
#include "tests/support/photometry_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace calc {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split_csv_line(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

std::vector<Row> read_manifest(const std::string& bytes) {
  std::vector<Row> rows;
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin < bytes.size()) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const std::vector<std::string> cells = split_csv_line(bytes.substr(begin, end - begin));
    begin = end + 1;
    if (names.empty()) {
      names = cells;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) row[names[i]] = cells[i];
    rows.push_back(row);
  }
  return rows;
}

TEST(RealPhotometryFiles, AreReadWithTheFluxOfAnotherProgram) {
  const char* shared = std::getenv("LUXGATE_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const std::string folder = std::string(shared) + "/photometry/";
  const DiskFileReader files;
  const FileContent manifest = files.read(folder + "manifest.csv");
  if (!manifest.ok()) GTEST_SKIP() << "no manifest.csv in " << folder;

  std::map<std::string, int> counts;
  for (const Row& row : read_manifest(manifest.bytes)) {
    if (row.at("format") != "IES" && row.at("format") != "LDT") continue;
    const FileContent content = files.read(folder + row.at("file"));
    ASSERT_TRUE(content.ok()) << row.at("file");
    Diagnostics diagnostics;
    const std::optional<PhotometricWeb> web =
        parse_photometry(content.bytes, row.at("file"), diagnostics);
    EXPECT_EQ(!web, diagnostics.has_errors()) << row.at("file");
    ++counts[row.at("category") + " " + row.at("format") + (web ? " read" : " refused")];
    if (std::getenv("LUXGATE_VERBOSE") != nullptr)
      std::fputs(test_support::diagnostics_text(diagnostics).c_str(), stderr);

    if (row.at("category") == "real" && row.at("photometric_type") == "C") {
      EXPECT_TRUE(web) << test_support::diagnostics_text(diagnostics);
    }
    if (!web) continue;
    EXPECT_NEAR(WebSampler(*web).normalisation_lm() / web->flux_lm(), 1.0, 1e-12) << row.at("file");
    const std::string& expected = row.at("flux_lm_linear_angle");
    if (expected.empty()) continue;
    EXPECT_NEAR(web->flux_lm() / std::stod(expected), 1.0, 1e-3) << row.at("file");
  }
  for (const auto& [what, count] : counts) std::printf("%s: %d\n", what.c_str(), count);
}

}  // namespace
}  // namespace calc
