// A run with a store gives the bytes of a run without, whatever the store holds.
#include "calc/store/entry_folder.h"
#include "report/check/run.h"
#include "report/document/document.h"
#include "tests/support/memory_file_reader.h"
#include "tests/support/rendered.h"
#include "tests/support/scratch_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace store_test {
namespace {

namespace fs = std::filesystem;
using test_support::bytes_of;
using test_support::put_bytes;

const std::string kPanel = bytes_of(LUXGATE_SOURCE_DIR "/tests/plane_independence/panel.ies");

// A room of two channels: openings beside a screen, and a lamp without size behind it.
struct Design {
  double limit_lx = 60.0, uniformity = 0.5, dimming = 0.5, maintenance = 0.8;
  double walls = 0.6, lamp_x_m = 1.0, flux_lm = 800.0, height_m = 0.8;
  int columns = 5;
  std::string group = "row", plane = "desk";
  bool has_screen = true;
  calc::RadiositySettings radiosity{};
  bool by_luminaire = false;
  rules::Goal goal = rules::Goal::verdict;

  Design() {
    radiosity.replicates = 8;
    radiosity.first_paths = 64;
    radiosity.max_paths = 512;
    radiosity.jobs = 1;
  }

  std::string xml() const {
    return fmt::format(
        R"(<luxgate version="1" maintenance-factor="{}">
  <material id="grey" reflectance="{}"/><material id="floor" reflectance="0.2"/>
  <luminaire-type id="panel" photometry="panel.ies" flux-lm="{}"/>
  <luminaire-type id="point" photometry="point.ies"/>
  <scene id="evening"><dim group="{}" level="{}"/></scene>
  <room id="room" size="4 3 3" floor="floor" ceiling="grey" walls="grey">
    {}
    <luminaire id="L" type="panel" position="{} 1 2.9" group="{}"/>
    <luminaire id="M" type="panel" position="3 2 2.9"/>
    <luminaire id="P" type="point" position="2 2.5 2.5" group="{}"/>
    <plane id="{}" height="{}" count="{} 4"><require quantity="average" at-least="{}"/></plane>
    <plane id="even" height="0.2" count="4 3"><require quantity="Uo" at-least="{}"/></plane>
    <plane id="evening" on="wall2" count="3 3"><require quantity="minimum" at-least="{}" scene="evening"/></plane>
    <plane id="faces" height="1.2" count="3 2" quantity="cylindrical"><require quantity="average" at-least="20"/></plane>
    <plane id="eyes" height="1.2" count="2 2" quantity="ugr" direction="1 0 0"><require quantity="maximum" at-most="19"/></plane>
  </room>
</luxgate>)",
        maintenance, walls, flux_lm, group, dimming,
        has_screen ? R"(<box id="screen" size="0.05 2 1.5" position="2 0.5 0.1" material="grey"/>)"
                   : "",
        lamp_x_m, group, group, plane, height_m, columns, limit_lx, uniformity, 0.3 * limit_lx);
  }
};

class Counter : public check::Observer {
 public:
  void solved(const std::string&, const std::string&, const calc::PreparedScene&,
              const std::vector<calc::PlaneTask>&, const calc::SpaceSolution& solution) override {
    looks = solution.looks;
    pool_rays = solution.pool_rays;
  }
  calc::LookCounts looks;
  std::uint64_t pool_rays = 0;
};

struct Checked {
  std::string json;
  calc::LookCounts looks;
  std::uint64_t pool_rays = 0;
};

Checked checked(const Design& design, calc::EntryStore* entries) {
  calc::MemoryFileReader files;
  std::string point = kPanel;
  const std::size_t size = point.find("0.6 0.6 0");
  files.add("design.xml", design.xml());
  files.add("panel.ies", kPanel);
  files.add("point.ies", point.replace(size, 9, "0 0 0"));
  check::Settings settings;
  settings.radiosity = design.radiosity;
  settings.by_luminaire = design.by_luminaire;
  settings.goal = design.goal;
  settings.today = "2026-11-23";
  check::Run run = check::Run(settings).with_files(files);
  if (entries != nullptr) {  // which is the caller's
    run = run.with_light_in({std::shared_ptr<calc::EntryStore>(), entries});
  }
  Counter counter;
  report::Document document;
  document.projects.push_back(run.check("design.xml", counter));
  EXPECT_TRUE(document.projects[0].is_judged) << report::rendered("json", document);
  return {report::rendered("json", document), counter.looks, counter.pool_rays};
}

// The store must change nothing, and says what it spared.
calc::LookCounts same_with(calc::EntryStore& store, const Design& design) {
  const Checked without = checked(design, nullptr), with = checked(design, &store);
  EXPECT_EQ(without.json, with.json) << design.xml();
  EXPECT_EQ(without.pool_rays, with.pool_rays);
  EXPECT_EQ(without.looks.read, 0u);
  EXPECT_EQ(without.looks.computed, with.looks.read + with.looks.computed);
  return with.looks;
}

class StoreOfLooks : public testing::Test {
 protected:
  StoreOfLooks() : path((scratch.path() / "store").string()) {}
  calc::LookCounts same(const Design& design) const {
    calc::EntryFolder store(path);
    return same_with(store, design);
  }
  std::vector<fs::path> entries() const {
    std::vector<fs::path> files;
    if (!fs::exists(path)) return files;
    for (const auto& part : fs::directory_iterator(path)) {
      if (!part.is_directory()) continue;
      for (const auto& entry : fs::directory_iterator(part)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  test_support::ScratchFolder scratch;
  std::string path;
};

void revise(Design& design, std::mt19937& random) {
  const auto one_of = [&](auto first, auto second, auto third) {
    const auto k = random() % 3;
    return k == 0 ? first : k == 1 ? second : third;
  };
  const std::vector<std::function<void()>> changes = {
      [&] { design.limit_lx = one_of(40.0, 60.0, 75.0); },
      [&] { design.uniformity = one_of(0.3, 0.5, 0.7); },
      [&] { design.dimming = one_of(0.0, 0.5, 1.0); },
      [&] { design.maintenance = one_of(0.6, 0.8, 0.9); },
      [&] { design.walls = one_of(0.0, 0.6, 0.7); },
      [&] { design.lamp_x_m = one_of(1.0, 1.1, 2.0); },
      [&] { design.flux_lm = one_of(800.0, 900.0, 1000.0); },
      [&] { design.height_m = one_of(0.7, 0.8, 0.8); },
      [&] { design.columns = one_of(4, 5, 6); },
      [&] { design.group = one_of("row", "row", "window"); },
      [&] { design.plane = one_of("desk", "desk", "table"); },
      [&] { design.has_screen = one_of(true, true, false); },
      [&] { design.radiosity.seed = one_of(1u, 1u, 2u); },
      [&] { design.radiosity.max_paths = one_of(64u, 512u, 1024u); },
      [&] { design.radiosity.jobs = one_of(1, 2, 3); },
      [&] { design.by_luminaire = one_of(false, false, true); },
      [&] {
        design.goal = one_of(rules::Goal::verdict, rules::Goal::verdict, rules::Goal::accuracy);
      },
      [&] {
        design.radiosity.method = one_of(calc::Method::light_pool, calc::Method::light_pool,
                                         calc::Method::instant_radiosity);
      },
      [&] {
        design.radiosity.skips = {};
        if (random() % 2 == 0) return;
        design.radiosity.skips.forbid(static_cast<calc::Skip>(random() % calc::kSkips));
      }};
  for (auto count = 1 + random() % 2; count > 0; --count) changes[random() % changes.size()]();
}

void damage(const fs::path& entry, std::mt19937& random) {
  std::string bytes = fs::is_regular_file(fs::symlink_status(entry)) ? bytes_of(entry) : "";
  switch (random() % 6) {
    case 0:
      fs::remove_all(entry);
      break;
    case 1:
      if (!bytes.empty()) bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
      put_bytes(entry, bytes);
      break;
    case 2:
      put_bytes(entry, bytes.substr(0, bytes.empty() ? 0 : random() % bytes.size()));
      break;
    case 3:
      put_bytes(entry, "");
      break;
    case 4:
      fs::remove_all(entry);
      fs::create_directory(entry);
      break;
    case 5:
      fs::remove_all(entry);
      fs::create_symlink("/dev/zero", entry);
      break;
  }
}

TEST_F(StoreOfLooks, RandomRevisionsGiveTheSameBytes) {
  std::mt19937 random(20261123);
  Design design;
  calc::LookCounts all;
  for (int revision = 0; revision < 80; ++revision) {
    SCOPED_TRACE(revision);
    const calc::LookCounts looks = same(design);
    all.read += looks.read;
    all.computed += looks.computed;
    revise(design, random);
    if (HasFailure()) break;
  }
  EXPECT_GT(all.read, 100u);
  EXPECT_GT(all.computed, 100u);
}

TEST_F(StoreOfLooks, DamagedEntriesGiveTheSameBytes) {
  std::mt19937 random(4);
  Design design;
  std::uint64_t read = 0, damaged = 0;
  for (int revision = 0; revision < 40; ++revision) {
    SCOPED_TRACE(revision);
    calc::EntryFolder store(path);
    read += same_with(store, design).read;
    damaged += store.troubles().unusable;
    EXPECT_EQ(store.troubles().not_written, "");
    for (const fs::path& entry : entries()) {
      if (random() % 4 == 0) damage(entry, random);
    }
    if (random() % 4 == 0) revise(design, random);
    if (HasFailure()) break;
  }
  EXPECT_GT(read, 100u);
  EXPECT_GT(damaged, 30u);
}

TEST_F(StoreOfLooks, AnUnchangedDesignTracesNoRay) {
  const Design design;
  const calc::LookCounts cold = same(design), warm = same(design);
  EXPECT_EQ(cold.read, 0u);
  EXPECT_TRUE(cold.has_rays);
  EXPECT_EQ(warm.computed, 0u);
  EXPECT_EQ(warm.read, cold.computed);
  EXPECT_FALSE(warm.has_rays);
}

TEST_F(StoreOfLooks, LimitsDimmingFactorsAndNamesTraceNoRayInTheFirstLook) {
  Design design;
  design.radiosity.max_paths = design.radiosity.first_paths;
  same(design);
  const std::vector<std::function<void(Design&)>> changes = {
      [](Design& d) { d.limit_lx = 75.0; },   [](Design& d) { d.uniformity = 0.1; },
      [](Design& d) { d.dimming = 0.1; },     [](Design& d) { d.maintenance = 0.5; },
      [](Design& d) { d.group = "renamed"; }, [](Design& d) { d.goal = rules::Goal::accuracy; }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    Design revised = design;
    changes[k](revised);
    const calc::LookCounts looks = same(revised);
    EXPECT_EQ(looks.computed, 0u) << k;
    EXPECT_FALSE(looks.has_rays) << k;
  }
}

TEST_F(StoreOfLooks, OneMoreLookIsTheOnlyOneComputed) {
  Design design;
  design.goal = rules::Goal::accuracy;
  design.radiosity.max_paths = 128;
  const calc::LookCounts first = same(design);
  design.radiosity.max_paths = 256;
  const calc::LookCounts more = same(design);
  EXPECT_EQ(more.read, first.computed);
  EXPECT_GT(more.computed, 0u);
  EXPECT_LE(more.computed, 5u);  // planes
}

TEST_F(StoreOfLooks, OneChangedPlaneIsTheOnlyOneComputed) {
  Design design;
  design.radiosity.max_paths = design.radiosity.first_paths;
  const calc::LookCounts cold = same(design);
  design.columns = 7;
  const calc::LookCounts looks = same(design);
  EXPECT_EQ(looks.computed, 1u);
  EXPECT_EQ(looks.read, cold.computed - 1);
}

TEST_F(StoreOfLooks, AnyMissingEntryIsComputedAlone) {
  Design design;
  design.goal = rules::Goal::accuracy;
  design.radiosity.max_paths = 256;
  const calc::LookCounts cold = same(design);
  const std::vector<fs::path> all = entries();
  ASSERT_EQ(all.size(), cold.computed);
  for (const fs::path& entry : all) {
    const std::string bytes = bytes_of(entry);
    fs::remove(entry);
    EXPECT_EQ(same(design).computed, 1u);
    EXPECT_EQ(bytes_of(entry), bytes);  // two writers of one key write the same bytes
  }
}

// What a run of a time limit leaves unfinished must not be taken for a look.
TEST_F(StoreOfLooks, RunsThatWereCutShortLeaveNothingWrong) {
  Design design;
  design.goal = rules::Goal::accuracy;
  for (const double limit_s : {1e-4, 1e-3, 2e-3, 4e-3, 8e-3, 16e-3, 32e-3}) {
    Design hurried = design;
    hurried.radiosity.time_limit_s = limit_s;
    calc::EntryFolder store(path);
    checked(hurried, &store);
  }
  same(design);
}

TEST_F(StoreOfLooks, AnUnwritableStoreChangesNothing) {
  put_bytes(scratch.path() / "file", "");
  calc::EntryFolder store((scratch.path() / "file" / "store").string());
  same_with(store, Design());
  EXPECT_NE(store.troubles().not_written, "");
}

}  // namespace
}  // namespace store_test
