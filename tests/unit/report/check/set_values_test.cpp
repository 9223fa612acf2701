#include "report/check/set_values.h"

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_elements.h"
#include "rules/binding/project_schema.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace set_values_test {
namespace {

constexpr const char* kProject = R"(<luxgate version="1">
  <!-- <luminaire-type id="spot" flux-lm="1"/> is no element -->
  <material id="light" reflectance="0.7"/>
  <luminaire-type id='spot' photometry="a.ies" flux-lm = '900'/>
  <scene id="night"><dim group="two words" level="1"/></scene>
  <room id="room" size="5 4
    2.8" floor="light">
    <plane id="desk" height="0.8"><require id="mean" at-least="300" clause="a > b"/></plane>
    <plane id="far" height="0.1"><require id="mean" at-least="100"/><require at-most="9"/></plane>
    <plane id="light" height="0.2"/>
  </room>
</luxgate>
)";

struct Changed {
  std::optional<std::string> text;
  std::string messages;
};

Changed changed(const std::string& bytes, const std::vector<check::SetValue>& values) {
  const calc::MemoryFileReader files({{"p.xml", bytes}});
  const std::vector<std::string> projects{"p.xml"};
  calc::Diagnostics diagnostics;
  check::check_values(projects, values, "set", files, diagnostics);
  Changed result;
  const calc::FileContent content = check::SetReader(files, projects, values).read("p.xml");
  if (content.ok()) result.text = content.bytes;
  for (const calc::Diagnostic& d : diagnostics.all()) {
    result.messages += calc::format_diagnostic(d) + "\n";
  }
  return result;
}

// The file with this instead of that, and nothing else.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_text(const std::vector<check::SetValue>& values, const std::string& from,
                 const std::string& to) {
  const Changed result = changed(kProject, values);
  EXPECT_EQ(result.text, with(kProject, from, to)) << result.messages;
}

void expect_error(const std::string& path, const std::string& message) {
  const Changed result = changed(kProject, {{path, "1"}});
  EXPECT_EQ(result.text, std::nullopt) << path;
  EXPECT_EQ(result.messages, message + "\n");
}

TEST(SetValues, ChangesOneValueAndNothingElse) {
  expect_text({{"spot.flux-lm", "1200"}}, "'900'", "'1200'");
  expect_text({{"desk.mean.at-least", "5"}}, "\"300\"", "\"5\"");
  expect_text({{"room.far.mean.at-least", "5"}}, "\"100\"", "\"5\"");
  expect_text({{"room.far.height", "5"}}, "\"0.1\"", "\"5\"");
}

TEST(SetValues, FindsElementsByNameAndKey) {
  // A plane and a material have this id.
  expect_text({{"material.light.reflectance", "0.2"}}, "\"0.7\"", "\"0.2\"");
  expect_text({{"room.light.height", "0.3"}}, "\"0.2\"", "\"0.3\"");
  expect_text({{"two words.level", "0.5"}}, "level=\"1\"", "level=\"0.5\"");
  expect_text({{"night.dim.level", "0.5"}}, "level=\"1\"", "level=\"0.5\"");
}

TEST(SetValues, AddsWhatIsNotThere) {
  expect_text({{"luxgate.maintenance-factor", "0.8"}}, "version=\"1\">",
              "version=\"1\" maintenance-factor=\"0.8\">");
  expect_text({{"spot.power-w", "30"}}, "'900'/>", "'900' power-w=\"30\"/>");
  expect_text({{"desk.mean.state", "initial"}}, "\"a > b\"/>", "\"a > b\" state=\"initial\"/>");
}

TEST(SetValues, KeepsTheNumbersOfLaterLines) {
  expect_text({{"room.size", "6 4 3"}}, "\"5 4\n    2.8\" floor", "\"6 4 3\"\n floor");
}

TEST(SetValues, EscapesValues) {
  const std::string value = "a<b> & \"c\" 'd' é";
  const Changed result = changed(kProject, {{"desk.mean.clause", value}, {"spot.variant", value}});
  ASSERT_TRUE(result.text) << result.messages;
  calc::Diagnostics diagnostics;
  const auto root = calc::parse_xml(*result.text, "p.xml", diagnostics);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->children[1].find("variant")->value, value);
  EXPECT_EQ(root->children[3].children[0].children[0].find("clause")->value, value);
}

TEST(SetValues, SetsSeveralAtOnce) {
  const Changed result = changed(kProject, {{"far.height", "0.4"},
                                            {"spot.flux-lm", "1"},
                                            {"spot.power-w", "2"},
                                            {"spot.opening", "point"}});
  std::string expected = with(kProject, "'900'", "'1' power-w=\"2\" opening=\"point\"");
  EXPECT_EQ(result.text, with(expected, "\"0.1\"", "\"0.4\"")) << result.messages;
}

// A package takes their place.
TEST(SetValues, APackageReplacesFluxAndPower) {
  const std::string with_package = with(kProject, " flux-lm = '900'", " package=\"P-1\"");
  EXPECT_EQ(changed(kProject, {{"spot.package", "P-1"}}).text, with_package);
  const std::string both =
      *changed(kProject, {{"spot.flux-lm", "5"}, {"spot.package", "P-1"}}).text;
  EXPECT_THAT(both, testing::HasSubstr("flux-lm = '5' package=\"P-1\""));
}

TEST(SetValues, ReadsOddFiles) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(changed(mark + kProject, {{"spot.flux-lm", "1"}}).text,
            mark + with(kProject, "'900'", "'1'"));
  std::string crlf = kProject;
  for (std::size_t at = 0; (at = crlf.find('\n', at)) != crlf.npos; at += 2) crlf.insert(at, "\r");
  EXPECT_EQ(changed(crlf, {{"far.height", "7"}}).text, with(crlf, "\"0.1\"", "\"7\""));
  // Latin-1 becomes UTF-8, and says so.
  const std::string latin =
      "<?xml version='1.0' encoding='ISO-8859-1'?><luxgate name='\xE9\xE9' version='1'>"
      "<material name='\xE9' id='m' reflectance='0.1'/></luxgate>";
  EXPECT_EQ(changed(latin, {{"m.reflectance", "0.2"}}).text,
            "<?xml version='1.0' encoding='UTF-8'?><luxgate name='éé' version='1'>"
            "<material name='é' id='m' reflectance='0.2'/></luxgate>");
  std::string wide = "\xFF\xFE";
  for (const char c : std::string(kProject)) wide += {c, '\0'};
  EXPECT_EQ(changed(wide, {{"spot.flux-lm", "1"}}).text, with(kProject, "'900'", "'1'"));
  EXPECT_EQ(changed("<luxgate version='1'/>", {{"luxgate.units", "cm"}}).text,
            "<luxgate version='1' units=\"cm\"/>");
  EXPECT_EQ(changed("<luxgate/>", {{"luxgate.units", "cm"}}).text, "<luxgate units=\"cm\"/>");
  // Of a value that holds what looks like the end of one, and of references.
  EXPECT_EQ(changed("<luxgate name='a=\"b\" &apos;' units='m'/>", {{"luxgate.units", "cm"}}).text,
            "<luxgate name='a=\"b\" &apos;' units='cm'/>");
}

// Who reads it says what is wrong.
TEST(SetValues, LeaveWhatIsNoProject) {
  for (const char* text : {"<a b='0'/>", "<luxgate><![CDATA[x]]></luxgate>"}) {
    const Changed result = changed(text, {{"a.b", "1"}});
    EXPECT_EQ(result.text, text);
    EXPECT_EQ(result.messages, "");
  }
}

TEST(SetValues, SaysWhatIsWrongWithAPath) {
  expect_error(
      "flux-lm",
      "p.xml: error[value-not-set]: --set flux-lm: a path is ID.attribute, or ID.ID.attribute with "
      "the ids of enclosing elements where one id is not enough; the root is 'luxgate'");
  expect_error(
      "spit.flux-lm",
      "p.xml: error[value-not-set]: --set spit.flux-lm: the project has no element 'spit'; "
      "it has desk, far, light, luxgate, mean, night, require, room, spot, two words; "
      "did you mean 'spot'?");
  expect_error(
      "spot.flux-lx",
      "p.xml:4:3: error[value-not-set]: --set spot.flux-lx: <luminaire-type> has no "
      "attribute 'flux-lx'; allowed: flux-lm, power-w, package, price, maintenance-factor, llmf, "
      "lsf, lmf, rsmf, opening, interpolation, lamp-set, variant or emitter; did you mean "
      "'flux-lm'?");
  expect_error("material.light.id",
               "p.xml:3:3: error[value-not-set]: --set material.light.id: 'id' of <material> "
               "cannot be set: it identifies the element; allowed: reflectance");
  expect_error("mean.at-least",
               "p.xml:8:35: error[value-not-set]: --set mean.at-least: 'mean' matches 2 elements: "
               "room.desk.mean (line 8), room.far.mean (line 9); a path must match exactly one");
  expect_error("light.height",
               "p.xml:3:3: error[value-not-set]: --set light.height: 'light' matches 2 elements: "
               "material.light "
               "(line 3), room.light (line 10); a path must match exactly one");
}

TEST(SetValues, NeverSetsIdsFilesAndWaivers) {
  for (const char* path : {"spot.id", "spot.photometry", "luxgate.version", "desk.was", "desk.file",
                           "desk.mean.waived-by", "two words.group"}) {
    EXPECT_EQ(changed(kProject, {{path, "1"}}).text, std::nullopt) << path;
  }
}

// Nobody moves to another check, by an option, what somebody has signed for one.
TEST(SetValues, NeverSetsWhatSomebodyHasSigned) {
  const std::string signed_words = R"( because="b" by="A" until="2030-01-01"/>)";
  const std::string project = R"(<luxgate version="1"><room id="r" size="1 1 1">
<plane id="p" height="0.1"><require id="q" pack="x" row="1" level="-1" level-because="z">
<waiver checks="a")" + signed_words +
                              R"(<deviation in="grid")" + signed_words + R"(</require></plane>
<workplace id="w"><without role="wall")" +
                              signed_words + "</workplace></room></luxgate>";
  for (const char* path : {"waiver.checks", "waiver.by", "deviation.in", "deviation.until",
                           "w.wall.role", "without.because", "q.level-because"}) {
    const Changed result = changed(project, {{path, "1"}});
    EXPECT_EQ(result.text, std::nullopt) << path;
    EXPECT_NE(result.messages.find("cannot be set"), std::string::npos) << result.messages;
  }
  EXPECT_TRUE(changed(project, {{"q.level", "0"}}).text);
}

TEST(SetValues, RefusesOneAttributeTwiceAndControlCharacters) {
  EXPECT_NE(changed(kProject, {{"room.far.height", "1"}, {"far.height", "2"}})
                .messages.find("'height' of <plane> is set twice, also as 'room.far.height'"),
            std::string::npos);
  EXPECT_NE(changed(kProject, {{"far.name", "a\nb"}}).messages.find("control character"),
            std::string::npos);
  EXPECT_NE(changed(kProject, {{"far.name", "a\xFF"}}).messages.find("not UTF-8"),
            std::string::npos);
}

// Project data have a place also where the file has none.
TEST(SetValues, AboutIsMadeWhereItIsNot) {
  expect_text({{"about.revision", "a<1>"}, {"luxgate.about.client", "Meier"}},
              "<luxgate version=\"1\">",
              "<luxgate version=\"1\"><about revision=\"a&lt;1&gt;\" client=\"Meier\"/>");
  EXPECT_EQ(changed("<luxgate/>", {{"about.date", "x"}}).text,
            "<luxgate><about date=\"x\"/></luxgate>");
  EXPECT_EQ(changed("<luxgate version='1' />", {{"about.note", "x"}}).text,
            "<luxgate version='1' ><about note=\"x\"/></luxgate>");
  EXPECT_EQ(
      changed("<luxgate><about note='y'/></luxgate>", {{"about.note", "x"}, {"about.number", "1"}})
          .text,
      "<luxgate><about note='x' number=\"1\"/></luxgate>");
  expect_error("about.customer",
               "p.xml:1:1: error[value-not-set]: --set about.customer: <about> has no attribute "
               "'customer'; allowed: client, number, revision, date, author, company, address or "
               "note");
  expect_error(
      "about.logo",
      "p.xml:1:1: error[value-not-set]: --set about.logo: 'logo' of <about> cannot be set: "
      "it names a file; allowed: client, number, "
      "revision, date, author, company, address or note");
}

void add_names(const calc::ElementRow& row, std::map<std::string_view, calc::Names>& names) {
  if (!names.emplace(row.type, calc::attribute_names(row)).second) return;
  for (const calc::ChildRow& child : row.children) {
    if (child.row != nullptr) add_names(*child.row, names);
    if (child.group == nullptr) continue;
    for (const calc::ChildRow& one : child.group->children) add_names(*one.row, names);
  }
}

TEST(SetValues, OnlyAboutChangesNoResult) {
  for (const char* path : {"about.revision", "luxgate.about.note"}) {
    EXPECT_TRUE(check::is_about_project({path, "x"})) << path;
  }
  for (const char* path : {"about.height", "about", "room.about.note", "luxgate.revision", "about.",
                           "luxgate.maintenance-factor"}) {
    EXPECT_FALSE(check::is_about_project({path, "x"})) << path;
  }
  // Whatever has the id "about": no other element has an attribute of such a name.
  std::map<std::string_view, calc::Names> names;
  for (const calc::ElementRow& row : rules::rows_about_rules()) add_names(row, names);
  add_names(*calc::kProjectRoot.row, names);
  for (const std::string_view ours : calc::attribute_names(calc::kAboutElement)) {
    for (const auto& [type, others] : names) {
      if (type == calc::kAboutElement.type) continue;
      EXPECT_EQ(std::find(others.begin(), others.end(), ours), others.end()) << type << " " << ours;
    }
  }
}

class FilesOfTest : public calc::FileReader {
 public:
  calc::FileContent read_within(const std::string&, const std::string& path) const override {
    const auto found = contents.find(path);
    return found == contents.end() ? calc::FileContent{"", "none"}
                                   : calc::FileContent{found->second, ""};
  }
  std::map<std::string, std::string> contents;
};

TEST(SetReader, ChangesProjectsOnly) {
  FilesOfTest files;
  files.contents = {
      {"a.xml", kProject}, {"b.xml", "<luxgate/>"}, {"c.xml", "<lux"}, {"x", kProject}};
  const std::vector<std::string> projects{"a.xml", "b.xml", "c.xml"};
  const std::vector<check::SetValue> values{{"spot.flux-lm", "1"}};
  const check::SetReader reader(files, projects, values);
  EXPECT_EQ(reader.read("a.xml").bytes, with(kProject, "'900'", "'1'"));
  EXPECT_EQ(reader.read("b.xml").error,
            "--set spot.flux-lm: the project has no element 'spot'; it has luxgate");
  EXPECT_EQ(reader.read("c.xml").bytes, "<lux");  // told by who reads it
  EXPECT_EQ(reader.read("x").bytes, kProject);
  EXPECT_EQ(reader.read("d.xml").error, "none");
}

}  // namespace
}  // namespace set_values_test
