// Photometry files that are read again for data sheets.
#include "report/shell/output/sheet_files.h"

#include "calc/base/file_hash.h"
#include "calc/base/units.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/photometry_samples.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace cli::sheet_files_test {
namespace {

namespace fs = std::filesystem;

// As a result has it, with the flux of the project.
report::LuminaireRow row_of(const std::string& bytes, double flux_lm,
                            const calc::PhotometryOptions& options = {}) {
  calc::Diagnostics diagnostics;
  const auto light = calc::parse_photometry(bytes, "a", diagnostics, options);
  EXPECT_TRUE(light) << test_support::diagnostics_text(diagnostics);
  report::LuminaireRow row;
  if (!light) return row;
  row.type_id = "t";
  row.photometry_file = "lib/a.any";
  row.sha256 = calc::sha256_hex(bytes);
  row.name = light->source().luminaire_name;
  row.maker = light->source().manufacturer;
  row.article_number = light->source().article_number;
  row.lamp = light->source().lamp;
  row.colour_temperature = light->source().colour_temperature;
  row.colour_rendering = light->source().colour_rendering;
  row.flux_lm = flux_lm;
  row.file_flux_lm = light->flux_lm();
  for (int step = -report::kPolarHalfSteps; step <= report::kPolarHalfSteps; ++step) {
    const double gamma = calc::radians_from_degrees(std::abs(step) * report::kPolarStep_deg);
    const double c = step < 0 ? calc::kPi : 0.0, scale = flux_lm / light->flux_lm();
    row.c0_cd.push_back(scale * light->intensity_cd(c, gamma));
    row.c90_cd.push_back(scale * light->intensity_cd(c + 0.5 * calc::kPi, gamma));
  }
  return row;
}

class SheetFilesTest : public testing::Test {
 protected:
  // A project in the folder that was calculated with these bytes.
  report::ProjectPart project_of(const report::LuminaireRow& row) const {
    report::ProjectPart project;
    project.path = (folder_.path() / "p.xml").string();
    project.luminaires = {row};
    project.inputs = {{"lib/a.any", row.sha256}};
    return project;
  }
  void put(const std::string& bytes) const {
    fs::create_directories(folder_.path() / "lib");
    test_support::put_bytes(folder_.path() / "lib/a.any", bytes);
  }
  static report::Text why(const SheetFiles& files, const report::LuminaireRow& row) {
    const auto light = files.light_of(row);
    const auto* text = std::get_if<report::Text>(&light);
    return text == nullptr ? report::Text::sheets_title : *text;
  }

  test_support::ScratchFolder folder_;
  const std::string bytes_ = test_support::ies_text({});
};

TEST_F(SheetFilesTest, AFileIsFoundThoughTheProjectHasAnotherFlux) {
  const report::LuminaireRow row = row_of(bytes_, 777.0);
  put(bytes_);
  SheetFiles files;
  EXPECT_EQ(why(files, row), report::Text::sheet_no_file);  // of no project
  files.see(project_of(row), "");
  const auto found = files.light_of(row);
  ASSERT_TRUE(std::holds_alternative<report::SheetLight>(found));
  const auto& light = std::get<report::SheetLight>(found);
  EXPECT_DOUBLE_EQ(light.flux_lm, row.file_flux_lm);
  EXPECT_EQ(light.file_name, "a.any");
  EXPECT_EQ(light.emitters, 1U);
}

TEST_F(SheetFilesTest, AMissingOrOtherFileIsSaid) {
  const report::LuminaireRow row = row_of(bytes_, 777.0);
  SheetFiles files;
  files.see(project_of(row), "");
  EXPECT_EQ(why(files, row), report::Text::sheet_not_found);
  put(bytes_ + "\n");
  EXPECT_EQ(why(files, row), report::Text::sheet_other_file);
}

TEST_F(SheetFilesTest, AnotherLightIsNotShown) {
  put(bytes_);
  report::LuminaireRow row = row_of(bytes_, 777.0);
  SheetFiles files;
  files.see(project_of(row), "");
  report::LuminaireRow other = row;
  other.c90_cd[80] += 0.01 * other.c90_cd[72] + 1.0;
  EXPECT_EQ(why(files, other), report::Text::sheet_other_light);
  other = row;
  other.colour_temperature = "9000";
  EXPECT_EQ(why(files, other), report::Text::sheet_other_light);
  other = row;
  other.c0_cd.clear();
  other.c90_cd.clear();
  EXPECT_EQ(why(files, other), report::Text::sheets_title);  // an old result: its flux is the same
  other.file_flux_lm *= 1.01;
  EXPECT_EQ(why(files, other), report::Text::sheet_other_light);
}

TEST_F(SheetFilesTest, AResultThatWasMovedWithItsProjectFindsItsFiles) {
  put(bytes_);
  const report::LuminaireRow row = row_of(bytes_, 777.0);
  report::ProjectPart project = project_of(row);
  project.path = "elsewhere/p.xml";
  SheetFiles files;
  files.see(project, (folder_.path() / "result.json").string());
  EXPECT_EQ(why(files, row), report::Text::sheets_title);
}

// Whoever writes a result must not learn what other folders hold.
TEST_F(SheetFilesTest, AFileOutsideOfTheFolderIsNotRead) {
  put(bytes_);
  const report::LuminaireRow row = row_of(bytes_, 777.0);
  report::ProjectPart project = project_of(row);
  fs::create_directories(folder_.path() / "sub");
  project.path = (folder_.path() / "sub/p.xml").string();
  project.inputs = {{"../lib/a.any", row.sha256}};
  SheetFiles files;
  files.see(project, "");
  EXPECT_EQ(why(files, row), report::Text::sheet_not_found);
  put(bytes_ + "\n");
  EXPECT_EQ(why(files, row), report::Text::sheet_not_found);
}

TEST_F(SheetFilesTest, ALampSetIsFoundByItsLight) {
  test_support::LdtSample sample;
  for (const char* line : {"1", "LED", "2000", "3000 K", "90", "20"})
    sample.lamp_set_lines.emplace_back(line);
  const std::string bytes = test_support::ldt_text(sample);
  put(bytes);
  calc::PhotometryOptions second;
  second.lamp_set = 2;
  const report::LuminaireRow row = row_of(bytes, 500.0, second);
  SheetFiles files;
  files.see(project_of(row), "");
  const auto found = files.light_of(row);
  ASSERT_TRUE(std::holds_alternative<report::SheetLight>(found));
  EXPECT_EQ(std::get<report::SheetLight>(found).power_w, 20.0);
}

TEST_F(SheetFilesTest, AVariantOfAProductIsFoundByItsLight) {
  test_support::GldfSample sample;
  sample.emitters +=
      "<Emitter id='e2'><ChangeableLightEmitter><PhotometryReference photometryId='p2'/>"
      "</ChangeableLightEmitter></Emitter>";
  sample.variants +=
      "<Variant id='v2'><Name><Locale language='en'>Two</Locale></Name><Geometry>"
      "<EmitterReference emitterId='e2'/></Geometry></Variant>";
  const std::string bytes = test_support::gldf_bytes(sample);
  put(bytes);
  calc::PhotometryOptions second;
  second.variant = "v2";
  const report::LuminaireRow row = row_of(bytes, 500.0, second);
  SheetFiles files;
  files.see(project_of(row), "");
  const auto found = files.light_of(row);
  ASSERT_TRUE(std::holds_alternative<report::SheetLight>(found));
  EXPECT_DOUBLE_EQ(std::get<report::SheetLight>(found).flux_lm, row.file_flux_lm);
}

}  // namespace
}  // namespace cli::sheet_files_test
