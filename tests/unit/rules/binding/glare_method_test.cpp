// How a row's glare is asked: by the tabular method where the room is one for it, at observers
// elsewhere and where somebody asks for them, never by neither.
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/coverage.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace rules::glare_method_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kPanel =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 3000 1 3 1 1 2 0.6 0.6 0\n1 1 12\n0 45 90\n0\n900 640 0\n";

// Six panels spread evenly over a room of 12 m x 8 m.
const std::string kEven =
    "<luminaire-grid id='e' type='panel' origin='0 0 2.9' size='12 8' columns='3' rows='2' "
    "group='g'/>";
const std::string kAtOneEnd =
    "<luminaire-grid id='e' type='panel' origin='0 0 2.9' size='5 3' columns='3' rows='2' "
    "group='g'/>";

struct Made {
  calc::Project project;
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;
  std::map<std::string, std::string> roles;  // of the first row: "room": "met"

  std::vector<std::string> ids() const {
    std::vector<std::string> ids;
    for (const calc::CalcPlane& plane : project.spaces.at(0).planes) ids.push_back(plane.id);
    return ids;
  }
  std::vector<Requirement> by_table() const {
    std::vector<Requirement> found;
    std::copy_if(requirements.begin(), requirements.end(), std::back_inserter(found),
                 [](const Requirement& r) { return r.metric == Metric::ugr_table; });
    return found;
  }
  bool has_observers() const {
    return std::any_of(requirements.begin(), requirements.end(), [](const Requirement& r) {
      return r.derived == calc::DerivedQuantity::ugr;
    });
  }
};

Made make(const std::string& inside, const std::string& luminaires = kEven) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><material id='m' reflectance='0.6'/>"
      "<luminaire-type id='panel' photometry='panel.ies'/><scene id='half'><dim group='g' "
      "level='0.5'/></scene><room id='r' size='12 8 3' ceiling='m' walls='m' floor='m'>" +
      inside + luminaires + "</room></luxgate>";
  calc::Diagnostics diagnostics;
  Made made;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"panel.ies", kPanel}});
  const std::vector<RulePack> packs = builtin_rule_packs();
  auto judged = load_judged_project(files, "p.xml", packs, diagnostics);
  for (const auto& d : diagnostics.all()) made.messages.push_back(format_diagnostic(d));
  if (!judged) return made;
  made.requirements = std::move(judged->requirements);
  made.project = std::move(judged->project);
  const calc::Space& space = made.project.spaces.at(0);
  std::vector<std::vector<Finding>> findings(space.planes.size());
  std::vector<JudgedPlane> planes;
  for (std::size_t i = 0; i < space.planes.size(); ++i) {
    for (const Requirement& requirement : made.requirements) {
      if (requirement.plane_id != space.planes[i].id) continue;
      Finding& finding = findings[i].emplace_back();
      finding.requirement = requirement;
      finding.verdict = Verdict::pass;
    }
    planes.push_back({&space, &space.planes[i], &findings[i]});
  }
  const auto rows = row_coverage(space, planes, packs, "2027-01-01",
                                 [](const auto&...) { return calc::Message(); });
  if (rows.empty()) return made;
  for (const RoleCoverage& role : rows[0].roles) {
    made.roles[role.role] = std::string(calc::name_of(role.state));
    if (!role.words.empty() && (role.role == "room" || role.role == "observer")) {
      made.roles[role.role] += ": " + role.words.english();
    }
  }
  made.roles["whole"] = rows[0].is_whole() ? "yes" : "no";
  return made;
}

std::string workplace(const std::string& attributes = "", const std::string& children = "",
                      const std::string& id = "w") {
  return "<workplace id='" + id + "' pack='en12464-1:2021' row='34.2' " + attributes + ">" +
         children + "</workplace>";
}

TEST(GlareMethod, IsTheTableWhereTheRoomIsOneForIt) {
  const Made made = make(workplace());
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_FALSE(made.has_observers());
  ASSERT_EQ(made.by_table().size(), 1u);
  const Requirement asked = made.by_table()[0];
  EXPECT_EQ(asked.plane_id, "w.task");
  EXPECT_EQ(asked.id, "UGR-table");
  EXPECT_EQ(asked.limit, 19.0);
  EXPECT_EQ(asked.comparison, Comparison::at_most);
  EXPECT_EQ(asked.state, LightState::initial);
  EXPECT_EQ(asked.problem, "");
  EXPECT_EQ(asked.origin.check, "glare.table");
  EXPECT_EQ(asked.clause, "EN 12464-1:2021 34.2");
  EXPECT_TRUE(std::isfinite(asked.of_space.value));
  EXPECT_THAT(asked.note.english(), HasSubstr("tabular method"));
  EXPECT_EQ(made.roles.at("room"), "met");
  EXPECT_EQ(made.roles.at("observer"), "not-made: judged by 'glare.table' instead");
  EXPECT_EQ(made.roles.at("whole"), "yes");
  EXPECT_THAT(calc::texts(made.project.spaces[0].notes),
              Contains(HasSubstr("judged by 'glare.table' instead")));
}

TEST(GlareMethod, IsAtObserversElsewhereAndSaysWhy) {
  const Made made = make(workplace(), kAtOneEnd);
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_TRUE(made.has_observers());
  EXPECT_THAT(made.by_table(), IsEmpty());
  EXPECT_THAT(made.ids(), Contains("w.observer.4"));
  EXPECT_EQ(made.roles.at("observer"), "met");
  EXPECT_THAT(made.roles.at("room"),
              HasSubstr("not-made: judged at observers: luminaire 'e[0,0]'"));
  EXPECT_EQ(made.roles.at("whole"), "yes");
}

TEST(GlareMethod, IsWhatTheWorkplaceSays) {
  const Made observers = make(workplace("glare='observers'"));
  EXPECT_TRUE(observers.has_observers());
  EXPECT_EQ(observers.by_table().size(), 1u);  // what the standard has is not chosen away
  EXPECT_EQ(observers.roles.at("room"), "met");
  EXPECT_EQ(observers.roles.at("observer"), "met");
  EXPECT_THAT(make(workplace("glare='observers'"), kAtOneEnd).by_table(), IsEmpty());
  const Made table = make(workplace("glare='table'"), kAtOneEnd);
  EXPECT_FALSE(table.has_observers());
  ASSERT_EQ(table.by_table().size(), 1u);
  EXPECT_THAT(table.by_table()[0].problem.english(), HasSubstr("spread evenly"));
  EXPECT_THAT(make(workplace("glare='both'")).messages,
              ElementsAre(HasSubstr("allowed: table or observers")));
}

// Who changes something about observers means to have some; who leaves them out leaves out no more.
TEST(GlareMethod, IsAtObserversWhereAZoneIsAboutThem) {
  const Made standing =
      make(workplace("", "<zone role='observer' height='1.7' because='standing'/>"));
  EXPECT_TRUE(standing.has_observers());
  EXPECT_EQ(standing.by_table().size(), 1u);
  const Made left_out = make(
      workplace("", "<without role='observer' because='later' by='A. Meier' until='2099-12-31'/>"));
  EXPECT_FALSE(left_out.has_observers());
  EXPECT_EQ(left_out.by_table().size(), 1u);
  EXPECT_EQ(left_out.roles.at("room"), "met");
}

const std::string kWithoutObservers =
    "<without role='observer' because='later' by='A. Meier' until='2099-12-31'/>";

TEST(GlareMethod, IsLeftOutOnlyByWhoSaysObserversAndLeavesThemOut) {
  const Made left_out = make(workplace("glare='observers'", kWithoutObservers));
  EXPECT_FALSE(left_out.has_observers());
  EXPECT_THAT(left_out.by_table(), IsEmpty());
  EXPECT_THAT(left_out.roles.at("observer"), HasSubstr("left-out"));
}

// With the table there are no observers to say something about; and there must be a choice.
TEST(GlareMethod, RefusesWhatHasNoMeaning) {
  for (const std::string& zone :
       {kWithoutObservers, std::string("<zone role='observer.1' height='1.7' because='b'/>")}) {
    EXPECT_THAT(make(workplace("glare='table'", zone)).messages,
                ElementsAre(HasSubstr("has no meaning together with 'glare=\"table\"'")));
  }
  EXPECT_THAT(
      make("<workplace id='w' pack='asr-a3-4' row='office' glare='table'/>").messages,
      Contains(HasSubstr("'glare' has no meaning together with 'pack=\"asr-a3-4:undated\"'")));
}

// One room has one rating, however many ask for it.
TEST(GlareMethod, AsksOnceForAllWorkplacesOfARoom) {
  const std::string a = "origin='1 1' size='2 2'", b = "origin='5 3' size='2 2'";
  const Made same = make(workplace(a, "", "a") + workplace(b, "", "b"));
  ASSERT_EQ(same.by_table().size(), 1u);
  EXPECT_EQ(same.by_table()[0].plane_id, "a.task");
  EXPECT_THAT(same.by_table()[0].origin.workplaces, ElementsAre("a", "b"));
  for (const calc::CalcPlane& plane : same.project.spaces[0].planes) {
    if (plane.id != "a.task") continue;
    EXPECT_THAT(plane.made_by.english(), Not(HasSubstr("also")));
  }
  const std::string other = "<workplace id='b' pack='en12464-1:2021' row='34.7' " + b + "/>";
  const Made different = make(workplace(a, "", "a") + other);
  ASSERT_EQ(different.by_table().size(), 2u);
  EXPECT_EQ(different.by_table()[1].plane_id, "b.task");
  EXPECT_EQ(different.by_table()[1].limit, 25.0);
}

TEST(GlareMethod, TakesTheLevelsOfAScene) {
  const double all = make(workplace()).by_table().at(0).of_space.value;
  const double half = make(workplace("scene='half'")).by_table().at(0).of_space.value;
  EXPECT_NEAR(half, all + 8.0 * std::log10(0.5), 1e-9);
}

const char* const kOwn = "<plane id='p' height='0.75' margin='0.5'>";

// Of planes that the project draws itself either is enough.
TEST(GlareMethod, OfOwnPlanesEitherCoversTheRow) {
  const std::string task = "<require pack='en12464-1:2021' row='34.2'/>";
  const std::string room = "<require pack='en12464-1:2021' row='34.2' role='room'/>";
  const Made neither = make(kOwn + task + "</plane>");
  EXPECT_EQ(neither.roles.at("observer"), "never-asked");
  EXPECT_EQ(neither.roles.count("room"), 0u);
  const Made table = make(kOwn + task + room + "</plane>");
  EXPECT_THAT(table.messages, IsEmpty());
  EXPECT_EQ(table.roles.at("room"), "met");
  EXPECT_EQ(table.roles.at("observer"), "not-made: judged by 'glare.table' instead");
  const Made eyes = make(kOwn + task +
                         "</plane><plane id='e' height='1.2' quantity='ugr' direction='1 0 0'>"
                         "<require pack='en12464-1:2021' row='34.2' role='observer'/></plane>"
                         "<plane id='f' height='1.2' quantity='ugr' direction='0 1 0'>"
                         "<require pack='en12464-1:2021' row='34.2' role='observer'/></plane>");
  EXPECT_EQ(eyes.roles.at("observer"), "met");
  EXPECT_EQ(eyes.roles.at("room"), "not-made: judged by 'glare' instead");
}

TEST(GlareMethod, MayBeAnOwnLimit) {
  const Made made = make(std::string(kOwn) +
                         "<require quantity='UGR-table' at-most='22'/><require "
                         "quantity='UGR-table' at-most='19' scene='half'/></plane>");
  EXPECT_THAT(made.messages, IsEmpty());
  ASSERT_EQ(made.by_table().size(), 2u);
  EXPECT_EQ(made.by_table()[0].limit, 22.0);
  EXPECT_EQ(made.by_table()[0].state, LightState::initial);
  EXPECT_STREQ(unit_of(made.by_table()[0]), "");
  EXPECT_NEAR(made.by_table()[1].of_space.value,
              made.by_table()[0].of_space.value + 8.0 * std::log10(0.5), 1e-9);
  for (const char* unfit : {"state='initial'", "light='all'", "unit='lx'"}) {
    const Made refused = make(std::string(kOwn) + "<require quantity='UGR-table' at-most='22' " +
                              unfit + "/></plane>");
    EXPECT_THAT(refused.messages, ElementsAre(HasSubstr("UGR-table"))) << unfit;
  }
}

TEST(GlareMethod, IsJudgedByItsNumberAlone) {
  const Made made = make(workplace());
  Requirement asked = made.by_table().at(0);
  const auto verdict = [&](const calc::Estimate& ugr) {
    asked.of_space = ugr;
    calc::SensorGrid grid;
    grid.position_m = {glm::dvec3(0.0)};
    return judge_plane({asked}, grid, {}, {}, 0.95).at(0);
  };
  EXPECT_EQ(verdict({18.9, 18.9, 18.9}).verdict, Verdict::pass);
  EXPECT_EQ(verdict({19.1, 19.1, 19.1}).verdict, Verdict::fail);
  EXPECT_EQ(verdict({18.0, 18.0, 19.5}).verdict, Verdict::undecided);
  constexpr double kNothing = -std::numeric_limits<double>::infinity();
  const Finding unseen = verdict({kNothing, kNothing, kNothing});
  EXPECT_EQ(unseen.verdict, Verdict::pass);
  EXPECT_THAT(unseen.reason.english(), HasSubstr("shines down, so there is nothing to rate"));
}

TEST(GlareMethod, MayBeWaivedByTheCheckThatIsAsked) {
  const std::string by = "because='b' by='A. Meier' until='2099-12-31'/>";
  EXPECT_THAT(make(workplace("", "<waiver checks='glare.table' " + by)).messages, IsEmpty());
  EXPECT_THAT(make(workplace("", "<waiver checks='glare' " + by)).messages,
              ElementsAre(HasSubstr("glare")));
}

}  // namespace
}  // namespace rules::glare_method_test
