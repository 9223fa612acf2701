// Optional: luminaires that were delivered as .ies and .ldt, from a collection outside the
// repository that LUXGATE_SHARED_DATA names. Both readers must find the same light the same way
// round.

#include "calc/base/file_reader.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web_compare.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace calc::real_pairs_test {
namespace {

namespace fs = std::filesystem;

std::optional<PhotometricWeb> read(const fs::path& path) {
  Diagnostics diagnostics;
  return parse_photometry(DiskFileReader().read(path.string()).bytes, path.string(), diagnostics);
}

TEST(RealPhotometryPairs, AgreeInOrientation) {
  const char* shared = std::getenv("LUXGATE_SHARED_DATA");
  if (shared == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const fs::path folder = fs::path(shared) / "photometry";
  if (!fs::is_directory(folder / "ldt")) GTEST_SKIP() << "no folder " << folder / "ldt";
  int pairs = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "ldt")) {
    const fs::path partner = folder / "ies" / (entry.path().stem().string() + ".ies");
    if (!fs::exists(partner)) continue;
    const std::optional<PhotometricWeb> ldt = read(entry.path());
    const std::optional<PhotometricWeb> ies = read(partner);
    if (!ldt || !ies) continue;  // damaged fixtures; real_files_test.cpp says which may be
    ++pairs;
    const WebComparison found = compare_webs(*ldt, *ies);
    const TurnFit& best = found.fits.front();
    if (std::getenv("LUXGATE_VERBOSE") != nullptr) {
      std::fprintf(stderr, "%s: %s, rms %.2g\n", partner.filename().c_str(),
                   turn_words(best.turn).c_str(), best.rms);
    }
    EXPECT_TRUE(best.turn == WebTurn{}) << partner << ": " << turn_words(best.turn);
    EXPECT_LT(best.rms, 1e-4) << partner;
    EXPECT_NEAR(found.flux_ratio, 1.0, 1e-3) << partner;
    EXPECT_NE(found.openings, OpeningRelation::exchanged) << partner;
  }
  EXPECT_GE(pairs, 5);

  // The same luminaire, its planes renumbered by a quarter turn: the openings turn with the light.
  const std::string stem = "luxpy__Testlamp_Isym3_symmetryOverC90C270axis";
  if (!fs::exists(folder / "ies" / (stem + "_rot.IES"))) return;
  const WebComparison turned = compare_webs(*read(folder / "ldt" / (stem + ".ldt")),
                                            *read(folder / "ies" / (stem + "_rot.IES")));
  EXPECT_EQ(turned.fits.front().turn.quarters, 3);
  EXPECT_LT(turned.fits.front().rms, 1e-4);
  EXPECT_GT(turned.fits[turned.alike].rms, 0.1);
  EXPECT_EQ(turned.openings, OpeningRelation::agree);
}

}  // namespace
}  // namespace calc::real_pairs_test
