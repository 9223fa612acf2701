#include "report/tools/photometry/photometry.h"
#include "report/tools/photometry/photometry_sheet.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/web_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace photometry_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string quarter_turned_ies() {
  test_support::IesSample sample;
  sample.c_deg = test_support::angle_steps(0, 360, 15);
  sample.opening = "2 1.2 0.3 0";  // across, along
  sample.cd = test_support::crooked_light;
  return test_support::ies_text(sample);
}
std::string upright_ies() {
  test_support::IesSample sample;
  sample.c_deg = test_support::angle_steps(0, 360, 15);
  sample.opening = "2 0.3 1.2 0";
  sample.cd = [](double c, double gamma) {  // its C 0 is the other one's C 90
    return test_support::crooked_light(c + 90.0 >= 360.0 ? c - 270.0 : c + 90.0, gamma);
  };
  return test_support::ies_text(sample);
}

cli::PhotometryOptions for_files(const std::vector<std::string>& paths) {
  cli::PhotometryOptions options;
  options.files = paths;
  return options;
}

// A folder of its own with the given files, removed afterwards.
class PhotometryCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "luxgate-photometry-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    write("a.ies", upright_ies());
    write("b.ies", quarter_turned_ies());
    write("bad.ies", "prose\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string content(const std::string& name) const {
    return calc::DiskFileReader().read(path(name)).bytes;
  }
  cli::PhotometryRun run(cli::PhotometryOptions options, bool quiet = false) const {
    options.quiet = quiet;
    return cli::run_photometry(options, calc::DiskFileReader(), false);
  }

  fs::path folder_;
};

TEST_F(PhotometryCommand, ShowsTheOthersWhenOneFileIsBad) {
  const cli::PhotometryRun result =
      run(for_files({path("bad.ies"), path("none.ies"), path("a.ies")}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.out, HasSubstr("bad.ies\n  not readable: see the errors\n"));
  EXPECT_THAT(result.out, HasSubstr("a.ies: formula (luxgate examples)\n"));
  EXPECT_THAT(result.err, HasSubstr("error[photometry-format]"));
  EXPECT_THAT(result.err, HasSubstr("error[file-not-readable]"));
}

TEST_F(PhotometryCommand, HintsAtAnOpeningAcrossH0) {
  const cli::PhotometryRun across = run(for_files({path("b.ies")}));
  EXPECT_EQ(across.exit_code, 0);
  EXPECT_THAT(across.out, HasSubstr("warning[photometry-across-h0]: the opening is 0.3 m along H 0 "
                                    "and 1.2 m across it"));
  EXPECT_EQ(across.err, "");
  EXPECT_THAT(run(for_files({path("a.ies")})).out, Not(HasSubstr("across-h0")));
  // 1.2 m along C90, as the format has it; a text that starts with TILT= makes it no LM-63 file.
  std::string ldt = test_support::ldt_text({});
  write("c.ldt", ldt.replace(ldt.find("formula"), 7, "TILT=NONE"));
  EXPECT_THAT(run(for_files({path("c.ldt")})).out, Not(HasSubstr("across-h0")));
}

TEST_F(PhotometryCommand, GivesOneForWarningsIfStrict) {
  cli::PhotometryOptions options = for_files({path("b.ies")});
  options.strict = true;
  EXPECT_EQ(run(options).exit_code, 1);
  options.files = {path("a.ies")};
  EXPECT_EQ(run(options).exit_code, 0);
  options.files = {path("b.ies"), path("bad.ies")};
  EXPECT_EQ(run(options).exit_code, 2);
}

TEST_F(PhotometryCommand, FindsTheQuarterTurnBetweenTwoFiles) {
  cli::PhotometryOptions options = for_files({path("a.ies"), path("b.ies")});
  options.compare = true;
  const cli::PhotometryRun result = run(options);
  EXPECT_THAT(result.out, HasSubstr("found       B is A turned by 90 degrees about the vertical "
                                    "axis (C = C + 90)\n  residual    RMS 0.000 %"));
  EXPECT_THAT(result.out, HasSubstr("openings    they agree with that"));
  EXPECT_THAT(result.err, HasSubstr("across-h0"));

  options.format = cli::PhotometryFormat::json;
  const auto json = nlohmann::json::parse(run(options).out);
  EXPECT_EQ(json["comparison"]["same_light"], true);
  EXPECT_EQ(json["comparison"]["fits"][0]["turn_deg"], 90);
  EXPECT_EQ(json["comparison"]["openings"], "agree");
  EXPECT_EQ(json["comparison"]["fits"].size(), 8u);
}

TEST_F(PhotometryCommand, WarnsOfAPairThatIsNotOneLight) {
  test_support::IesSample other;
  write("other.ies", test_support::ies_text(other));
  cli::PhotometryOptions options = for_files({path("a.ies"), path("other.ies")});
  options.compare = true;
  options.strict = true;
  const cli::PhotometryRun result = run(options);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("A and B are not the same light"));
  EXPECT_THAT(result.err, HasSubstr("warning[photometry-pair-differs]"));
}

TEST_F(PhotometryCommand, ConvertsBothWays) {
  cli::PhotometryOptions options = for_files({path("a.ies")});
  options.convert_file = path("new/a.LDT");
  EXPECT_EQ(run(options).exit_code, 0);
  options = for_files({path("new/a.LDT")});
  options.convert_file = path("back.ies");
  EXPECT_EQ(run(options).exit_code, 0);
  options = for_files({path("a.ies"), path("back.ies")});
  options.compare = true;
  options.format = cli::PhotometryFormat::json;
  const auto json = nlohmann::json::parse(run(options).out);
  const auto& best = json["comparison"]["fits"][0];
  EXPECT_EQ(best["turn_deg"], 0);
  EXPECT_LT(best["largest"].get<double>(), 2e-6);
  EXPECT_NEAR(json["comparison"]["flux_ratio"].get<double>(), 1.0, 1e-6);
  EXPECT_EQ(json["comparison"]["openings"], "agree");
}

TEST_F(PhotometryCommand, NeverOverwritesAnInput) {
  const std::string before = content("a.ies");
  cli::PhotometryOptions options = for_files({path("a.ies")});
  options.convert_file = path("x/../a.ies");
  const cli::PhotometryRun result = run(options);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("was read as an input and is not overwritten"));
  EXPECT_EQ(content("a.ies"), before);
}

TEST_F(PhotometryCommand, DrawsOneFileOrAll) {
  fs::create_directory(folder_ / "other");
  write("other/a.ies", upright_ies());
  cli::PhotometryOptions options = for_files({path("a.ies"), path("bad.ies"), path("other/a.ies")});
  options.polar_folder = path("polar");
  run(options);
  EXPECT_THAT(content("polar/a.ies.svg"), HasSubstr("<title>Polar diagram: formula</title>"));
  EXPECT_THAT(content("polar/a.ies-2.svg"), HasSubstr("</svg>"));
  EXPECT_FALSE(fs::exists(path("polar/bad.ies.svg")));

  options = for_files({path("a.ies")});
  options.polar_file = path("a.png");
  EXPECT_EQ(run(options).exit_code, 0);
  EXPECT_EQ(content("a.png").substr(1, 3), "PNG");
}

TEST_F(PhotometryCommand, JsonHoldsWhatTheTextSays) {
  cli::PhotometryOptions options = for_files({path("a.ies"), path("b.ies"), path("bad.ies")});
  options.format = cli::PhotometryFormat::json;
  const cli::PhotometryRun result = run(options);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["format"], "luxgate-photometry");
  EXPECT_EQ(json["format_version"], 1);
  ASSERT_EQ(json["files"].size(), 3u);
  const auto& light = json["files"][0]["light"];
  EXPECT_EQ(light["format"], "IESNA:LM-63-2002");
  EXPECT_EQ(light["rated_lamp_flux_lm"], nullptr);
  EXPECT_NEAR(light["efficacy_lm_per_w"].get<double>(), light["flux_lm"].get<double>() / 10, 1e-9);
  EXPECT_EQ(light["downward_share"], 1.0);
  EXPECT_EQ(light["symmetry"]["exact"], "none");
  EXPECT_EQ(light["table"]["c_planes"], 24);
  EXPECT_EQ(light["table"]["gamma_last_deg"], 90.0);
  EXPECT_EQ(light["table"]["axis"], "vertical");
  EXPECT_FALSE(light["table"].contains("v_first_deg"));
  EXPECT_GT(light["cubic"]["largest_difference"].get<double>(), 0.0);
  EXPECT_NE(light["cubic"]["flux_difference"].get<double>(), 0.0);
  EXPECT_EQ(light["axis_rule"], "H 0 is C 0; length along C 0, width along C 90");
  EXPECT_EQ(light["lamp_tilt"], nullptr);
  EXPECT_EQ(light["stated_flux_lm"], nullptr);
  EXPECT_EQ(light["opening"]["longer_side"], "C0-C180");
  EXPECT_EQ(light["beam_50_percent"][1]["planes"], "C90-C270");
  EXPECT_EQ(json["files"][1]["diagnostics"][0]["id"], "photometry-across-h0");
  EXPECT_EQ(json["files"][2]["readable"], false);
  EXPECT_FALSE(json["files"][2].contains("light"));
  EXPECT_EQ(json["files"][2]["diagnostics"][0]["severity"], "error");
}

TEST_F(PhotometryCommand, CsvHasOneFullLinePerFile) {
  cli::PhotometryOptions options = for_files({path("a.ies"), path("bad.ies")});
  options.format = cli::PhotometryFormat::csv;
  const std::string csv = run(options).out;
  std::size_t begin = 0;
  int lines = 0;
  for (std::size_t end = 0; (end = csv.find("\r\n", begin)) != std::string::npos; begin = end + 2) {
    ++lines;
    const std::string line = csv.substr(begin, end - begin);
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 35) << line;
  }
  EXPECT_EQ(lines, 3);
  EXPECT_THAT(csv, HasSubstr("bad.ies,no,,,"));
}

TEST_F(PhotometryCommand, QuietPrintsErrorsOnly) {
  const cli::PhotometryRun result = run(for_files({path("b.ies"), path("bad.ies")}), true);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, Not(HasSubstr("warning")));
  EXPECT_THAT(result.err, HasSubstr("error[photometry-format]"));
}

TEST_F(PhotometryCommand, ChoosesALampSet) {
  test_support::LdtSample sample;
  sample.lamp_set_lines = {"1", "a", "1000", "", "", "10", "1", "b", "2000", "", "", "20"};
  write("two.ldt", test_support::ldt_text(sample));
  cli::PhotometryOptions options = for_files({path("two.ldt")});
  options.format = cli::PhotometryFormat::json;
  const auto rated = [&] {
    const auto json = nlohmann::json::parse(run(options).out);
    return json["files"][0]["light"]["rated_lamp_flux_lm"].get<double>();
  };
  EXPECT_EQ(rated(), 1000.0);
  options.lamp_set = 2;
  EXPECT_EQ(rated(), 2000.0);
  options.lamp_set = 3;
  EXPECT_THAT(run(options).err, HasSubstr("has no lamp set '3'; allowed: 1 (a, 1000 lm), 2"));
  options.files = {path("a.ies")};
  EXPECT_THAT(run(options).err, HasSubstr("error[photometry-option-unused]"));
}

TEST_F(PhotometryCommand, ChoosesAVariantAndAnEmitter) {
  test_support::GldfSample sample;
  sample.emitters =
      "<Emitter id='e1'><LightEmitter photometryId='p1'/></Emitter>"
      "<Emitter id='e2'><LightEmitter photometryId='p2'/></Emitter>";
  sample.variants =
      "<Variant id='v1'><EmitterReference emitterId='e1'/><EmitterReference emitterId='e2'/>"
      "</Variant><Variant id='v2'><EmitterReference emitterId='e2'/></Variant>";
  write("a.gldf", test_support::gldf_bytes(sample));
  cli::PhotometryOptions options = for_files({path("a.gldf")});
  // Without a choice every light is shown, those of a variant that go together with their places.
  const auto all = run(options);
  EXPECT_EQ(all.exit_code, 0);
  for (const char* words :
       {"a.gldf [variant v1, emitter e1]: ", "a.gldf [variant v1, emitter e2]: ",
        "a.gldf [variant v2, emitter e2]: ", "together    emitter 'all': 2 emitters, ",
        "place       0 0 0 m from the middle of them, light along 0 0 -1, C 0 along 1 0 0\n",
        "warning[gldf-places]"}) {
    EXPECT_THAT(all.out, HasSubstr(words));
  }
  options.format = cli::PhotometryFormat::json;
  const auto json = nlohmann::json::parse(run(options).out)["files"];
  ASSERT_EQ(json.size(), 3u);
  EXPECT_EQ(json[0]["variant"], "v1");
  EXPECT_EQ(json[1]["emitter"], "e2");
  EXPECT_EQ(json[0]["together"]["emitters"], 2);
  EXPECT_FALSE(json[2].contains("together"));
  options.format = cli::PhotometryFormat::text;
  // What takes one light asks for it.
  options.convert_file = path("b.ldt");
  EXPECT_EQ(run(options).exit_code, 2);
  options.convert_file.clear();
  options.emitter = "all";
  options.variant = "v1";
  EXPECT_THAT(run(options).out, HasSubstr("[variant v1, emitter e2]"));
  options.emitter.clear();
  options.variant = "v2";
  EXPECT_THAT(run(options).out, HasSubstr("format      GLDF (IESNA:LM-63-2002)\n"));
  options.variant = "v1";
  options.emitter = "e1";
  EXPECT_THAT(run(options).out, HasSubstr("format      GLDF (EULUMDAT)\n"));
}

TEST_F(PhotometryCommand, ReadsTheTiltFileBesideAndNeverOverwritesIt) {
  test_support::IesSample sample;
  sample.tilt = "TILT=MH.ies\n";
  write("lamp.ies", test_support::ies_text(sample));
  cli::PhotometryOptions options = for_files({path("lamp.ies")});
  EXPECT_THAT(run(options).err, HasSubstr("MH.ies': No such file"));
  EXPECT_THAT(run(options).err, HasSubstr("error[photometry-tilt-file]"));
  write("MH.ies", "2\n3\n0 45 90\n1 0.9 0.75\n");
  EXPECT_THAT(run(options).out,
              HasSubstr("  lamp tilt   the lamp is horizontal along C0-C180; where it is tilted "
                        "the light is multiplied by\n              1 at 0°, 0.9 at 45°, 0.75 at "
                        "90°\n"));
  options.format = cli::PhotometryFormat::json;
  const auto tilt = nlohmann::json::parse(run(options).out)["files"][0]["light"]["lamp_tilt"];
  EXPECT_EQ(tilt["geometry"], 2);
  EXPECT_EQ(tilt["angles_deg"], nlohmann::json({0.0, 45.0, 90.0}));
  EXPECT_EQ(tilt["factors"], nlohmann::json({1.0, 0.9, 0.75}));
  options.convert_file = path("MH.ies");
  EXPECT_THAT(run(options).err, HasSubstr("was read as an input and is not overwritten"));
  EXPECT_THAT(content("MH.ies"), HasSubstr("0 45 90"));
}

std::string type_b_ies() {
  test_support::IesSample sample;
  sample.type = "2";
  sample.gamma_deg = test_support::angle_steps(-40, 40, 5);
  sample.c_deg = test_support::angle_steps(-30, 30, 5);
  sample.cd = [](double h, double v) {
    return std::max(0.0,
                    1000.0 * (1.0 - v * v / 1600.0) * (1.0 - h * h / 900.0) * (1.0 + 0.01 * h));
  };
  return test_support::ies_text(sample);
}

TEST_F(PhotometryCommand, WritesADataSheet) {
  cli::PhotometryOptions options = for_files({path("a.ies")});
  options.sheet_file = path("sheet.html");
  EXPECT_EQ(run(options).exit_code, 0);
  const std::string sheet = content("sheet.html");
  for (const char* words : {"<h1>formula</h1>", "luxgate examples", "1200 × 300 mm", "lm/W",
                            "CIE flux code", "4 H × 8 H", "C315", "data:image/svg+xml;base64,"}) {
    EXPECT_THAT(sheet, HasSubstr(words));
  }
  EXPECT_THAT(sheet, Not(HasSubstr("<script")));
  options.page.language = report::Language::german;
  EXPECT_EQ(run(options).exit_code, 0);
  EXPECT_THAT(content("sheet.html"), HasSubstr("Lichttechnisches Datenblatt"));
  options.sheet_file = path("a.ies");  // never over an input
  EXPECT_EQ(run(options).exit_code, 2);
  options.sheet_file = path("sheet.pdf");  // nobody prints it here
  const cli::PhotometryRun unprinted = run(options);
  EXPECT_EQ(unprinted.exit_code, 2);
  EXPECT_THAT(unprinted.err, HasSubstr("nothing prints it"));
  EXPECT_FALSE(fs::exists(path("sheet.pdf")));
}

TEST_F(PhotometryCommand, ADataSheetSaysWhatItDoesNotKnow) {
  const calc::PhotometricWeb point =
      calc::PhotometricWeb::make({0.0}, {0.0, 3.0}, {1.0, 1.0}, {}, {});
  cli::PhotometryFile file;
  file.path = "p.ies";
  file.web = point;
  file.facts = cli::photometry_facts(point);
  const std::string sheet = cli::render_photometry_sheet({}, file, "00", report::Paper::letter);
  EXPECT_THAT(sheet, HasSubstr("not stated"));
  EXPECT_THAT(sheet, HasSubstr("a point: the file states no size"));
  EXPECT_THAT(sheet, HasSubstr("No luminances and no UGR"));
  EXPECT_THAT(sheet, HasSubstr("No light cone"));
  EXPECT_THAT(sheet, HasSubstr("size: letter"));
  EXPECT_THAT(sheet, Not(HasSubstr(">nan")));
}

// Cosine light of 2000 cd and one square metre: 2000 cd/m2 in every direction, log10 2 of the way
// from 10^3 to 10^4.
TEST_F(PhotometryCommand, TheLuminanceDiagramOfCosineLightIsUpright) {
  std::vector<double> gamma, cd;
  for (int k = 0; k <= 90; ++k) {
    gamma.push_back(k * 3.14159265358979 / 180.0);
    cd.push_back(2000.0 * std::max(0.0, std::cos(gamma.back())));
  }
  calc::LuminousOpening opening;
  opening.shape = calc::OpeningShape::rectangle;
  opening.along_c0_m = opening.along_c90_m = 1.0;
  const calc::PhotometricWeb web = calc::PhotometricWeb::make({0.0}, gamma, cd, opening, {});
  cli::PhotometryFile file;
  file.web = web;
  file.facts = cli::photometry_facts(web);
  const std::string sheet = cli::render_photometry_sheet({}, file, "00", report::Paper::a4);
  const std::size_t begin = sheet.find("Luminance diagram");
  ASSERT_NE(begin, sheet.npos);
  const std::string svg = sheet.substr(begin, sheet.find("</svg>", begin) - begin);
  EXPECT_THAT(svg, HasSubstr(">10³</text>"));
  EXPECT_THAT(svg, HasSubstr(">10⁴</text>"));
  for (const std::string kind : {"c0", "c90"}) {
    const std::size_t path = svg.find("<path class=\"" + kind + "\" d=\"M") + kind.size() + 19;
    std::istringstream data(svg.substr(path, svg.find('"', path) - path));
    double x = 0.0, y = 0.0, first_y = 0.0;
    int points = 0;
    while (data >> x >> y) {
      if (++points == 1) first_y = y;
      EXPECT_NEAR(x, 44.0 + 382.0 * 0.30103, 0.3) << kind << " " << points;
      data.ignore(1);  // L
    }
    EXPECT_EQ(points, 81) << kind;
    EXPECT_EQ(first_y, 282.0);
    EXPECT_EQ(y, 14.0);
  }
}

// Half of the light to either side of the horizon; of what goes down, by cosine law, 44 % within
// 41.4 degrees (sin^2), 75 % within 60 and 94 % within 75.5.
TEST_F(PhotometryCommand, TheFluxCodeIsThatOfCosineLight) {
  std::vector<double> gamma, cd;
  for (int k = 0; k <= 180; ++k) {
    gamma.push_back(k * 3.14159265358979 / 180.0);
    cd.push_back(std::abs(std::cos(gamma.back())));
  }
  const calc::PhotometricWeb web = calc::PhotometricWeb::make({0.0}, gamma, cd, {}, {});
  cli::PhotometryFile file;
  file.web = web;
  file.facts = cli::photometry_facts(web);
  EXPECT_THAT(cli::render_photometry_sheet({}, file, "00", report::Paper::a4),
              HasSubstr(">44 75 94 50 100<"));
}

TEST_F(PhotometryCommand, ShowsTheAnglesOfTypeB) {
  write("flood.ies", type_b_ies());
  cli::PhotometryOptions options = for_files({path("flood.ies")});
  const cli::PhotometryRun shown = run(options);
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("  table       LM-63 type B, planes about the line C90-C270: V "
                                   "-40 to 40, H -30 to 30 (step 5)\n"));
  EXPECT_THAT(shown.out, HasSubstr("  axes        type B, planes about the C 90 line"));
  EXPECT_THAT(shown.out, HasSubstr("symmetry    about C90-C270\n"));
  options.format = cli::PhotometryFormat::json;
  const auto table = nlohmann::json::parse(run(options).out)["files"][0]["light"]["table"];
  EXPECT_EQ(table["axis"], "C90-C270");
  EXPECT_EQ(table["v_first_deg"], -40.0);
  EXPECT_EQ(table["v_last_deg"], 40.0);
  EXPECT_EQ(table["h_first_deg"], -30.0);
  EXPECT_EQ(table["h_last_deg"], 30.0);
  options.format = cli::PhotometryFormat::csv;
  EXPECT_THAT(run(options).out, HasSubstr(",C90-C270,C90-C270,"));
}

TEST_F(PhotometryCommand, ConvertsTypeBByResamplingWithAWarning) {
  write("flood.ies", type_b_ies());
  cli::PhotometryOptions options = for_files({path("flood.ies")});
  options.convert_file = path("flood.ldt");
  const cli::PhotometryRun converted = run(options);
  EXPECT_EQ(converted.exit_code, 0);
  EXPECT_THAT(converted.err, HasSubstr("warning[photometry-write-resampled]"));
  options = for_files({path("flood.ies"), path("flood.ldt")});
  options.compare = true;
  EXPECT_THAT(run(options).out, HasSubstr("B is A as it is, not turned (C = C)"));
}

TEST(PhotometryText, ShowsSplitBeamsNearSymmetryAndEfficiency) {
  const calc::PhotometricWeb web = test_support::with_source(
      test_support::make_web(test_support::angle_steps(0, 360, 90), {0, 30, 60, 90},
                             [](double c, double g) {
                               if (g == 30) return c == 90 ? 995.0 : c == 270 ? 1000.0 : 50.0;
                               return g == 0 ? 100.0 : 0.0;
                             }),
      {calc::OpeningShape::rectangle, 1.2, 0.3, 0.05},
      {"EULUMDAT", "lamp\x1b", "", 1000, 20, "", "x", "some rule", {}, 500.0});
  cli::PhotometryFile file;
  file.path = "f.ldt";
  file.web = web;
  file.facts = cli::photometry_facts(web);
  const std::string text = cli::render_photometry_text(file, false);
  EXPECT_THAT(text, HasSubstr("f.ldt: lamp \n"));
  EXPECT_THAT(text, HasSubstr("              500.000 lm stated for the luminaire, "));
  EXPECT_THAT(text, HasSubstr("axes        some rule\n"));
  EXPECT_THAT(text, HasSubstr("lamps       1000.00 lm stated; the luminaire gives "));
  EXPECT_THAT(text, HasSubstr("maximum     1000.0 cd at C 270, gamma 30\n"));
  EXPECT_THAT(
      text, HasSubstr("beam 50 %   C0-C180 60°; C90-C270 89.9° over 2 lobes, 31.7° the highest\n"));
  EXPECT_THAT(text,
              HasSubstr("symmetry    about C90-C270; about C0-C180 and C90-C270 within 0.50 % "
                        "of the maximum\n"));
  EXPECT_THAT(text,
              HasSubstr("opening     rectangle 1.20 m along C0, 0.30 m along C90, 0.05 m high; "
                        "longer side along C0-C180, the maximum lies across it\n"));
  EXPECT_THAT(text, HasSubstr("cubic       interpolation would change the light by up to "));
  EXPECT_THAT(text, HasSubstr("warnings    none\n"));
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  file.web = test_support::with_opening(web, {calc::OpeningShape::disk, 0.2, 0.2, 0.1});
  EXPECT_THAT(cli::render_photometry_text(file, false),
              HasSubstr("opening     disk 0.20 m along C0, 0.20 m along C90, 0.10 m high (used as "
                        "flat)\n"));
  file.web = test_support::with_opening(web, {calc::OpeningShape::cylinder, 0.2, 0.2, 0.1});
  EXPECT_THAT(cli::render_photometry_text(file, false),
              HasSubstr("cylinder 0.20 m along C0, 0.20 m "
                        "along C90, 0.10 m high\n"));
  EXPECT_NE(cli::render_photometry_text(file, true).find("\033[1mf.ldt"), std::string::npos);
}

}  // namespace
}  // namespace photometry_test
