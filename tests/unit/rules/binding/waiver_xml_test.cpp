// <waiver>: which checks it waives, and everything that it must not.

#include "rules/binding/waiver_xml.h"
#include "rules/binding/judged_project.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules::waiver_xml_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n";

struct Waived {
  std::vector<std::string> checks;  // "w.wall.1 wall.Em" of every requirement that is waived
  std::vector<std::string> errors;
  std::vector<Requirement> requirements;
};

// `inside` begins in line 3.
Waived waived_in(const std::string& inside) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='1'><material id='m' reflectance='0.7'/>"
      "<luminaire-type id='spot' photometry='spot.ies'/>\n"
      "<room id='r' size='12 8 3' ceiling='m' walls='m' floor='m'>"
      "<luminaire id='l' type='spot' position='6 4 2.9'/>\n" +
      inside + "</room></luxgate>";
  calc::Diagnostics diagnostics;
  Waived waived;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"spot.ies", kIes}});
  const auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  for (const calc::Diagnostic& d : diagnostics.all()) {
    if (d.severity() == calc::Severity::error) waived.errors.push_back(format_diagnostic(d));
  }
  if (!judged) return waived;
  waived.requirements = judged->requirements;
  for (const Requirement& requirement : judged->requirements) {
    if (!requirement.waiver) continue;
    waived.checks.push_back(requirement.plane_id + " " + requirement.origin.check);
  }
  return waived;
}

Waived in_require(const std::string& children, const std::string& attributes = "row='34.2'") {
  return waived_in("<plane id='t' height='0.75' margin='0.5'>\n<require pack='en12464-1:2021' " +
                   attributes + ">\n" + children + "</require></plane>");
}

Waived in_workplace(const std::string& children) {
  return waived_in("<workplace id='w' pack='en12464-1:2021' row='34.2'>\n" + children +
                   "</workplace>");
}

std::string waiver(const std::string& checks, const std::string& until = "2027-06-30") {
  return "<waiver checks='" + checks + "' because='spring' by='J. Doe' until='" + until + "'/>";
}

TEST(Waivers, WaiveTheChecksThatTheyName) {
  const Waived one = in_require(waiver("task.Uo"));
  EXPECT_THAT(one.errors, IsEmpty());
  EXPECT_THAT(one.checks, ElementsAre("t task.Uo"));
  const calc::Waiver& by = *one.requirements.at(1).waiver;
  EXPECT_EQ(by.reason, "spring");
  EXPECT_EQ(by.owner, "J. Doe");
  EXPECT_EQ(by.until, "2027-06-30");
  EXPECT_EQ(by.where.line, 5);
  EXPECT_THAT(in_require(waiver(" task.Em  task.Uo ")).checks,
              ElementsAre("t task.Em", "t task.Uo"));
  const Waived two = in_require(waiver("task.Em") + waiver("task.Uo", "2028-01-01"));
  EXPECT_EQ(two.requirements.at(1).waiver->until, "2028-01-01");
}

TEST(Waivers, OfAWorkplaceAreForEveryPlaneOfTheRole) {
  const Waived waived = in_workplace(waiver("wall.Em ceiling.Uo"));
  EXPECT_THAT(waived.errors, IsEmpty());
  EXPECT_THAT(waived.checks, ElementsAre("w.wall.1 wall.Em", "w.wall.2 wall.Em", "w.wall.3 wall.Em",
                                         "w.wall.4 wall.Em", "w.ceiling ceiling.Uo"));
}

TEST(Waivers, OfUnknownChecksAreErrorsWithTheList) {
  EXPECT_THAT(
      in_require(waiver("task.Ehm")).errors,
      ElementsAre(
          "p.xml:5:9: error[unknown-reference]: attribute 'checks' of <waiver>: "
          "there is no check 'task.Ehm'; allowed: task.Em, task.Uo, surround.Em, "
          "surround.Uo, background.Em, background.Uo, wall.Em, wall.Uo, "
          "ceiling.Em, ceiling.Uo, cylinder.Em, cylinder.Uo, modelling.low, "
          "modelling.high, shelf.Ev, glare, glare.table or colour; did you mean 'task.Em'?"));
  EXPECT_THAT(in_workplace(waiver("wal.Em")).errors,
              ElementsAre(HasSubstr("there is no check 'wal.Em'")));
}

TEST(Waivers, OfOneCheckTwiceAreErrors) {
  EXPECT_THAT(in_require(waiver("task.Em task.Em")).errors,
              ElementsAre(HasSubstr("the waived check 'task.Em' is given twice, also in line 5")));
  EXPECT_THAT(in_workplace(waiver("wall.Em") + "\n" + waiver("task.Em wall.Em")).errors,
              ElementsAre(HasSubstr("the waived check 'wall.Em' is given twice, also in line 4")));
}

TEST(Waivers, OfWhatIsNotAskedAreErrors) {
  EXPECT_THAT(
      in_require(waiver("wall.Em")).errors,
      ElementsAre(HasSubstr(
          "error[waiver-not-asked]: attribute 'checks' of <waiver>: the check 'wall.Em', of the "
          "role 'wall', is not required here; required: task.Em, task.Uo or colour")));
  EXPECT_THAT(in_require(waiver("task.Em"), "row='34.2' role='wall'").errors,
              ElementsAre(HasSubstr("required: wall.Em or wall.Uo")));
}

// A task of the whole room has no surround; a ceiling that is left out is not asked either. Colour
// is asked along with the task.
TEST(Waivers, OfWhatAWorkplaceDoesNotMakeAreErrors) {
  EXPECT_THAT(
      in_workplace(waiver("surround.Em")).errors,
      ElementsAre(HasSubstr("'surround.Em', of the role 'surround', is not required here")));
  EXPECT_THAT(in_workplace("<without role='ceiling' because='open' by='A' until='2099-12-31'/>" +
                           waiver("ceiling.Em"))
                  .errors,
              ElementsAre(HasSubstr("'ceiling.Em', of the role 'ceiling', is not required here")));
  EXPECT_THAT(in_workplace(waiver("colour")).errors, testing::IsEmpty());
  EXPECT_THAT(in_workplace("<without role='wall.1' because='glass' by='A' until='2099-12-31'/>" +
                           waiver("wall.Em"))
                  .checks,
              ElementsAre("w.wall.2 wall.Em", "w.wall.3 wall.Em", "w.wall.4 wall.Em"));
}

TEST(Waivers, NeedReasonOwnerDayAndChecks) {
  EXPECT_THAT(in_require("<waiver checks='task.Em' by='J' until='2027-06-30'/>").errors,
              ElementsAre(HasSubstr("<waiver> needs the attribute 'because'")));
  EXPECT_THAT(in_require("<waiver checks='task.Em' because='x' until='2027-06-30'/>").errors,
              ElementsAre(HasSubstr("<waiver> needs the attribute 'by'")));
  EXPECT_THAT(in_require("<waiver checks='task.Em' because='x' by='J'/>").errors,
              ElementsAre(HasSubstr("<waiver> needs the attribute 'until'")));
  EXPECT_THAT(in_require("<waiver because='x' by='J' until='2027-06-30'/>").errors,
              ElementsAre(HasSubstr("<waiver> needs the attribute 'checks'")));
  EXPECT_THAT(in_require(waiver("task.Em", "2027-02-29")).errors,
              ElementsAre(HasSubstr("'until' of <waiver>: '2027-02-29' is not a date")));
  EXPECT_THAT(in_require("<waiver checks='task.Em' because='x' by='J' until='2027-06-30' "
                         "role='task'/>")
                  .errors,
              ElementsAre(HasSubstr("unknown attribute 'role' of <waiver>")));
  // Once, however many planes a workplace makes.
  EXPECT_THAT(in_workplace(waiver("wall.Em", "soon")).errors,
              ElementsAre(HasSubstr("'soon' is not a date")));
}

TEST(Waivers, OfARowNameTheirChecks) {
  EXPECT_THAT(
      in_require("", "row='34.2' waived-because='r' waived-by='o' waived-until='2027-06-30'")
          .errors,
      ElementsAre(HasSubstr(
          "error[waiver-of-whole-row]: attribute 'waived-because' of <require>: it would waive "
          "every check of the row; write <waiver checks=\"task.Em task.Uo colour\" ")));
  EXPECT_THAT(
      in_require("", "row='34.2' waived-by='o'").errors,
      ElementsAre(HasSubstr("attribute 'waived-by' of <require>: it would waive every check")));
}

TEST(Waivers, OfALimitOfItsOwnAreAttributes) {
  const auto own = [](const std::string& inside, const std::string& more) {
    return waived_in("<plane id='t' height='0.75'><require quantity='average' at-least='5'" + more +
                     ">" + inside + "</require></plane>");
  };
  EXPECT_THAT(own(waiver("average"), "").errors,
              ElementsAre(HasSubstr(
                  "error[waiver-of-own-limit]: <waiver> is only for requirements of a rule pack")));
  const Waived good = own("", " waived-because='r' waived-by='o' waived-until='2027-06-30'");
  EXPECT_THAT(good.errors, IsEmpty());
  EXPECT_THAT(good.checks, ElementsAre("t "));
}

}  // namespace
}  // namespace rules::waiver_xml_test
