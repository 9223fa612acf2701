#include "rules/binding/bind.h"
#include "calc/base/units.h"
#include "calc/photometry/web.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rules::bind_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Attributes = std::vector<std::pair<std::string, std::string>>;

// Line `line`; attributes in columns 10, 20, ...
calc::RequirementText text_of(const Attributes& attributes, int line = 7) {
  calc::RequirementText text;
  text.element.name = "require";
  text.element.where = {"project.xml", line, 5};
  int column = 0;
  for (const auto& [name, value] : attributes) {
    text.element.attributes.push_back({name, value, {"project.xml", line, column += 10}});
  }
  return text;
}

calc::CalcPlane plane_of(const std::string& id, const std::vector<Attributes>& requirements) {
  calc::CalcPlane plane;
  plane.id = id;
  int line = 7;
  for (const Attributes& attributes : requirements) {
    plane.requirements.push_back(text_of(attributes, line++));
  }
  return plane;
}

calc::Project project_of(std::vector<calc::CalcPlane> planes) {
  calc::Project project;
  project.scenes = {{"full", {}, {}}, {"night", {}, {}}};
  project.spaces.emplace_back();
  project.spaces.back().planes = std::move(planes);
  return project;
}

struct Bound {
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;
};

Bound bind_project(const calc::Project& project,
                   const std::vector<RulePack>& packs = builtin_rule_packs()) {
  calc::Diagnostics diagnostics;
  Bound bound{bind_requirements(project, packs, diagnostics), {}};
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    bound.messages.push_back(format_diagnostic(diagnostic));
  }
  return bound;
}

Bound bind_one(const Attributes& attributes) {
  return bind_project(project_of({plane_of("desk", {attributes})}));
}

Requirement bound_requirement(const Attributes& attributes) {
  const Bound bound = bind_one(attributes);
  EXPECT_THAT(bound.messages, IsEmpty());
  EXPECT_EQ(bound.requirements.size(), 1u);
  return bound.requirements.empty() ? Requirement{} : bound.requirements.front();
}

// The messages of one wrong requirement, which must not be bound.
std::vector<std::string> messages_of(const Attributes& attributes) {
  const Bound bound = bind_one(attributes);
  EXPECT_THAT(bound.requirements, IsEmpty());
  return bound.messages;
}

RulePack small_pack(const std::string& id, const std::string& edition, std::size_t rows,
                    const std::string& more = "") {
  std::string xml = "<rule-pack id='" + id + "' edition='" + edition +
                    "' title='Own' version='1' kind='company' status='published' "
                    "licence='internal' role='desk'><parameter id='E' unit='lx' meaning='m'/>";
  for (std::size_t i = 1; i <= rows; ++i) {
    xml += "<row ref='r" + std::to_string(i) +
           "' name='n' trust='confirmed'><value of='E' required='1'/></row>";
  }
  xml += "<check id='min' role='desk' quantity='planar' statistic='minimum' at-least='row(E)'/>" +
         more + "</rule-pack>";
  calc::Diagnostics diagnostics;
  std::optional<RulePack> pack = parse_rule_pack(xml, edition + ".xml", diagnostics);
  EXPECT_TRUE(pack.has_value()) << xml;
  return pack.value_or(RulePack{});
}

TEST(BindRequirements, ReadsAPlainLimit) {
  const Requirement r = bound_requirement({{"quantity", "average"}, {"at-least", "500"}});
  EXPECT_EQ(r.plane_id, "desk");
  EXPECT_EQ(r.id, "average");
  EXPECT_EQ(r.metric, Metric::average);
  EXPECT_EQ(r.comparison, Comparison::at_least);
  EXPECT_EQ(r.limit, 500);
  EXPECT_EQ(r.state, LightState::maintained);
  EXPECT_EQ(r.scene, "");
  EXPECT_EQ(r.clause, "");
  EXPECT_EQ(r.where.line, 7);
}

TEST(BindRequirements, ReadsEveryAttribute) {
  const Requirement r = bound_requirement({{"id", "glare-limit"},
                                           {"quantity", "percentile"},
                                           {"percent", "90"},
                                           {"at-most", " 2e3 "},
                                           {"unit", "lx"},
                                           {"state", "initial"},
                                           {"scene", "night"},
                                           {"clause", "contract 4.2"}});
  EXPECT_EQ(r.id, "glare-limit");
  EXPECT_EQ(r.metric, Metric::percentile);
  EXPECT_EQ(std::get<Percentile>(r.arguments).percent, 90);
  EXPECT_EQ(r.comparison, Comparison::at_most);
  EXPECT_EQ(r.limit, 2000);
  EXPECT_EQ(r.state, LightState::initial);
  EXPECT_EQ(r.scene, "night");
  EXPECT_EQ(r.clause, "contract 4.2");
}

TEST(BindRequirements, ConvertsFootcandles) {
  const Requirement r =
      bound_requirement({{"quantity", "minimum"}, {"at-least", "1"}, {"unit", "fc"}});
  EXPECT_DOUBLE_EQ(r.limit, 10.763910416709722);
}

TEST(BindRequirements, ReadsAPointInWorldCoordinates) {
  const Requirement r =
      bound_requirement({{"quantity", "value"}, {"at", "1.5 -2 0.75"}, {"at-least", "300"}});
  const auto& at = std::get<PointOfValue>(r.arguments);
  EXPECT_EQ(at.point_m, glm::dvec3(1.5, -2, 0.75));
  EXPECT_FALSE(at.facing);
  const Requirement up = bound_requirement(
      {{"quantity", "value"}, {"at", "1 2 3"}, {"facing", "0 0 5"}, {"at-least", "300"}});
  EXPECT_EQ(std::get<PointOfValue>(up.arguments).facing, glm::dvec3(0, 0, 1));
}

TEST(BindRequirements, TakesTheEndsOfRanges) {
  EXPECT_EQ(bound_requirement({{"quantity", "Uo"}, {"at-least", "1"}}).limit, 1);
  EXPECT_EQ(bound_requirement({{"quantity", "Ud"}, {"at-least", "0"}}).limit, 0);
  EXPECT_EQ(bound_requirement({{"quantity", "maximum"}, {"at-most", "0"}}).limit, 0);
}

TEST(BindRequirements, NamesAndNumbersRequirementsWithoutId) {
  const Attributes average{{"quantity", "average"}, {"at-least", "1"}};
  const Attributes uo{{"quantity", "Uo"}, {"at-least", "0.5"}};
  const Attributes named{{"id", "average-2"}, {"quantity", "maximum"}, {"at-most", "9"}};
  const Bound bound = bind_project(project_of(
      {plane_of("a", {average, uo, average, named, average}), plane_of("b", {average})}));
  EXPECT_THAT(bound.messages, IsEmpty());
  std::vector<std::string> ids;
  for (const Requirement& r : bound.requirements) ids.push_back(r.plane_id + "/" + r.id);
  EXPECT_THAT(ids, ElementsAre("a/average", "a/Uo", "a/average-3", "a/average-2", "a/average-4",
                               "b/average"));
}

TEST(BindRequirements, ExpandsARowOfARulePack) {
  const Bound bound = bind_one({{"pack", "en12464-1"}, {"row", "34.2"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_EQ(bound.requirements[0].id, "average");
  EXPECT_EQ(bound.requirements[0].limit, 500);
  EXPECT_EQ(bound.requirements[0].clause, "EN 12464-1:2021 34.2");
  EXPECT_EQ(bound.requirements[0].where.line, 7);
  EXPECT_EQ(bound.requirements[1].metric, Metric::uniformity_min_avg);
  EXPECT_EQ(bound.requirements[1].limit, 0.6);
  EXPECT_EQ(bound.requirements[1].plane_id, "desk");
}

TEST(BindRequirements, TakesTheModifiedLevelWhereTheRowHasOne) {
  const Bound bound =
      bind_one({{"pack", "en12464-1:2021"}, {"row", "34.2"}, {"level", "modified"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_EQ(bound.requirements[0].limit, 1000);
  EXPECT_EQ(bound.requirements[0].clause, "EN 12464-1:2021 34.2 (modified)");
  EXPECT_EQ(bound.requirements[1].limit, 0.6);
  EXPECT_EQ(bound.requirements[1].clause, "EN 12464-1:2021 34.2");
}

TEST(BindRequirements, TakesStepsAlongTheStandardsScaleWithTheReason) {
  const Bound bound = bind_one({{"pack", "en12464-1:2021"},
                                {"row", "34.2"},
                                {"level", "-1"},
                                {"level-because", "used for an hour a week"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 2u);
  const Requirement& average = bound.requirements[0];
  EXPECT_EQ(average.limit, 300);
  EXPECT_EQ(average.clause, "EN 12464-1:2021 34.2 (-1 step) [unverified requirement]");
  EXPECT_THAT(average.note.english(), testing::HasSubstr("level -1 step: used for an hour a week"));
  EXPECT_EQ(average.origin.level, (RowLevel{.steps = -1}));
  // What no scale is about stays what it is, and needs no word.
  EXPECT_EQ(bound.requirements[1].limit, 0.6);
  EXPECT_EQ(bound.requirements[1].clause, "EN 12464-1:2021 34.2");
  EXPECT_EQ(bound.requirements[1].note, "");
}

TEST(BindRequirements, AReasonMayGoWithTheModifiedLevel) {
  const Bound bound = bind_one({{"pack", "en12464-1:2021"},
                                {"row", "34.2"},
                                {"level", "modified"},
                                {"level-because", "older staff"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  EXPECT_EQ(bound.requirements.at(0).note, "level modified: older staff");
}

TEST(BindRequirements, ABareIdMeansTheEditionInForce) {
  EXPECT_EQ(bind_one({{"pack", "en12464-1"}, {"row", "34.2"}}).requirements.at(0).clause,
            "EN 12464-1:2021 34.2");
  EXPECT_EQ(bind_one({{"pack", "en12464-1:2011"}, {"row", "5.26.2"}}).requirements.at(0).clause,
            "EN 12464-1:2011 5.26.2");
}

TEST(BindRequirements, TakesTheChecksOfTheRole) {
  const Bound bound = bind_one({{"pack", "en12464-1"}, {"row", "34.2"}, {"role", "background"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_DOUBLE_EQ(bound.requirements[0].limit, 100.0);  // a third of the surround's 300 lx
  EXPECT_EQ(bound.requirements[0].mask.id, "wall-zone");
  EXPECT_EQ(bound.requirements[1].limit, 0.1);
}

TEST(BindRequirements, SaysHowWellARequirementIsKnown) {
  const Bound bound = bind_one({{"pack", "en12464-1:2011"}, {"row", "5.26.2"}});
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_EQ(bound.requirements[0].note, "the rule pack marks en12464-1:2011 as superseded");
  EXPECT_EQ(bound.requirements[1].note,
            "unverified requirement; the rule pack marks en12464-1:2011 as superseded");
  EXPECT_EQ(bound.requirements[1].clause, "EN 12464-1:2011 5.26.2 [unverified requirement]");
}

TEST(BindRequirements, CannotJudgeAValueThatThePackDoesNotKnow) {
  const Bound bound = bind_one({{"pack", "en12193"}, {"row", "ice-hockey-II"}});
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_EQ(bound.requirements[0].problem, "");
  EXPECT_EQ(bound.requirements[1].problem, "row ice-hockey-II: Uo is not known");
  EXPECT_TRUE(std::isnan(bound.requirements[1].limit));
}

TEST(BindRequirements, LeavesOutWhatTheRowDoesNotSpecify) {
  const Bound bound = bind_one({{"pack", "en12464-1"}, {"row", "14.1"}, {"role", "ceiling"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 1u);
  EXPECT_EQ(bound.requirements[0].metric, Metric::uniformity_min_avg);
}

TEST(BindRequirements, JudgesEmergencyLightInItsScene) {
  const Bound bound = bind_one({{"pack", "en1838"}, {"scene", "night"}});
  EXPECT_THAT(bound.messages, IsEmpty());
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_EQ(bound.requirements[0].scene, "night");
  EXPECT_EQ(bound.requirements[0].state, LightState::end_of_duration);
  EXPECT_TRUE(bound.requirements[0].direct_only);
  EXPECT_EQ(bound.requirements[0].mask.id, "width");
  EXPECT_EQ(bound.requirements[1].limit, 0.025);
}

TEST(BindRequirements, SaysWhenASceneDimsNothing) {
  const auto note_with = [](std::vector<std::pair<std::string, double>> levels) {
    calc::Project project = project_of({plane_of("p", {{{"pack", "en1838"}, {"scene", "night"}}})});
    project.scenes.back().level_of_group = std::move(levels);
    return bind_project(project).requirements.at(0).note;
  };
  const std::string words = "scene night dims nothing; every luminaire is at full output";
  EXPECT_EQ(note_with({}), words);
  EXPECT_EQ(note_with({{"exit", 1.0}}), words);
  EXPECT_EQ(note_with({{"exit", 1.0}, {"normal", 0.0}}), "");
}

calc::PhotometricWeb even_web() {
  return calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi}, {100.0, 100.0}, {}, {});
}

// What a scene does not name is at full output: a normal luminaire would light the route.
TEST(BindRequirements, AnEmergencySceneMustNameEveryLuminaire) {
  const auto problem_with = [](const std::string& group, const char* role) {
    calc::Project project =
        project_of({plane_of("p", {{{"pack", "egress-us"}, {"role", role}, {"scene", "night"}}})});
    project.scenes.back().level_of_group = {{"exit", 0.2}};
    project.luminaire_types.emplace_back();
    project.webs.push_back(even_web());
    calc::Luminaire exit;
    exit.id = "E";
    exit.group = "exit";
    calc::Luminaire other;
    other.id = "N";
    other.group = group;
    project.spaces[0].luminaires = {exit, other};
    return bind_project(project).requirements.at(0).problem;
  };
  EXPECT_EQ(problem_with("exit", "route-start"), "");
  EXPECT_EQ(problem_with("normal", "route-start"),
            "scene 'night' does not say what 1 luminaires do in an emergency; the first is 'N'. "
            "Give each a group, and each group a <dim> in the scene");
  EXPECT_NE(problem_with("", "route-start"), "");
  EXPECT_EQ(problem_with("normal", "route-normal"), "");
}

// What the project states, and nothing compares with the light, stands in every report.
TEST(BindRequirements, AFactIsSaidWithTheLimitThatHangsOnIt) {
  const auto note_with = [](const std::string& role, const std::string& facts) {
    return bind_one({{"pack", "en1838"}, {"role", role}, {"scene", "night"}, {"facts", facts}})
        .requirements.at(0)
        .note.english();
  };
  EXPECT_THAT(note_with("high-risk", "task-illuminance=500 lx"),
              HasSubstr("stated by the project, not calculated: task-illuminance = 500 lx"));
  EXPECT_THAT(note_with("high-risk", "task-illuminance=50 fc"),
              HasSubstr("task-illuminance = 538.196 lx"));
}

TEST(BindRequirements, TakesFactsFromTheProject) {
  const auto limit_with = [](const std::string& facts) {
    return bind_one(
               {{"pack", "en1838"}, {"role", "high-risk"}, {"scene", "night"}, {"facts", facts}})
        .requirements.at(0)
        .limit;
  };
  EXPECT_EQ(limit_with("task-illuminance=500 lx"), 50.0);
  EXPECT_EQ(limit_with(" task-illuminance = 100 lx ; "), 15.0);
}

TEST(BindRequirements, CannotJudgeWithoutTheFact) {
  const Bound bound = bind_one({{"pack", "en1838"}, {"role", "high-risk"}, {"scene", "night"}});
  ASSERT_EQ(bound.requirements.size(), 2u);
  EXPECT_EQ(bound.requirements[0].problem, "fact 'task-illuminance' is not stated");
}

TEST(BindRequirements, PutsOutOnlyLuminairesWithAGroupOfTheirOwn) {
  const auto bound_with = [](const std::string& group) {
    calc::Project project = project_of(
        {plane_of("p", {{{"pack", "egress-us"}, {"role", "route-one-out"}, {"scene", "night"}}})});
    project.scenes.back().level_of_group = {{"a", 0.2}, {"b", 0.2}};
    project.luminaire_types.emplace_back();
    project.webs.push_back(even_web());
    calc::Luminaire first, second;
    first.id = "E1";
    first.group = "a";
    second.id = "E2";
    second.group = group;
    project.spaces[0].luminaires = {first, second};
    return bind_project(project).requirements.at(0);
  };
  EXPECT_TRUE(bound_with("b").any_one_unit_out);
  EXPECT_EQ(bound_with("b").problem, "");
  EXPECT_THAT(bound_with("b").note.english(), testing::HasSubstr("any one luminaire out"));
  EXPECT_EQ(bound_with("a").problem,
            "luminaire 'E2' has no dimming group of its own in scene 'night'; give each "
            "luminaire one, so that it can be out alone");
}

TEST(BindRequirements, ReadsAShareAndItsRange) {
  const Requirement r =
      bound_requirement({{"quantity", "share"}, {"from", "300"}, {"at-least", "0.9"}});
  EXPECT_EQ(r.metric, Metric::share);
  EXPECT_EQ(std::get<ValueRange>(r.arguments).from, 300);
  EXPECT_FALSE(std::isfinite(std::get<ValueRange>(r.arguments).to));
  EXPECT_EQ(r.limit, 0.9);
}

// A project with one plane of a quantity that is more than one illuminance.
Bound bind_derived(calc::DerivedQuantity derived, const Attributes& attributes) {
  calc::CalcPlane plane = plane_of("desk", {attributes});
  plane.derived = derived;
  plane.kernel = derived == calc::DerivedQuantity::ugr ? calc::ReceiverKernel::planar
                                                       : calc::ReceiverKernel::cylindrical;
  return bind_project(project_of({plane}));
}

TEST(BindRequirements, LeavesReflectedLightOutWhereAsked) {
  EXPECT_FALSE(bound_requirement({{"quantity", "average"}, {"at-least", "5"}}).direct_only);
  EXPECT_TRUE(bound_requirement({{"quantity", "average"}, {"at-least", "5"}, {"light", "direct"}})
                  .direct_only);
  EXPECT_THAT(bind_derived(calc::DerivedQuantity::ugr,
                           {{"quantity", "maximum"}, {"at-most", "19"}, {"light", "direct"}})
                  .messages,
              ElementsAre(testing::HasSubstr("'light' has no meaning together with 'ugr points'")));
}

TEST(BindRequirements, ReadsLimitsOfRatingsAsPlainNumbers) {
  const Bound glare =
      bind_derived(calc::DerivedQuantity::ugr, {{"quantity", "maximum"}, {"at-most", "19"}});
  ASSERT_EQ(glare.requirements.size(), 1u);
  EXPECT_EQ(glare.requirements[0].limit, 19.0);
  EXPECT_EQ(glare.requirements[0].state, LightState::initial);  // when it is worst
  EXPECT_EQ(glare.requirements[0].derived, calc::DerivedQuantity::ugr);
  EXPECT_STREQ(unit_of(glare.requirements[0]), "");
  const Bound modelling =
      bind_derived(calc::DerivedQuantity::modelling,
                   {{"quantity", "share"}, {"from", "0.3"}, {"to", "0.6"}, {"at-least", "0.9"}});
  ASSERT_EQ(modelling.requirements.size(), 1u);
  EXPECT_EQ(std::get<ValueRange>(modelling.requirements[0].arguments).to, 0.6);
}

TEST(BindRequirements, TakesGlareAndModellingOfRows) {
  const Bound glare =
      bind_derived(calc::DerivedQuantity::ugr,
                   {{"pack", "en12464-1:2021"}, {"row", "34.2"}, {"role", "observer"}});
  ASSERT_EQ(glare.requirements.size(), 1u) << testing::PrintToString(glare.messages);
  EXPECT_EQ(glare.requirements[0].metric, Metric::maximum);
  EXPECT_EQ(glare.requirements[0].limit, 19.0);
  EXPECT_EQ(glare.requirements[0].comparison, Comparison::at_most);
  EXPECT_EQ(glare.requirements[0].state, LightState::initial);
  EXPECT_EQ(glare.requirements[0].problem, "");
  const Bound modelling =
      bind_derived(calc::DerivedQuantity::modelling,
                   {{"pack", "en12464-1:2021"}, {"row", "34.2"}, {"role", "modelling"}});
  ASSERT_EQ(modelling.requirements.size(), 2u) << testing::PrintToString(modelling.messages);
  EXPECT_EQ(modelling.requirements[0].metric, Metric::minimum);
  EXPECT_EQ(modelling.requirements[1].limit, 0.6);
}

// A room of 4 m x 5 m with luminaires of these powers; 0: not stated.
Bound bind_in_lit_room(const std::vector<double>& powers_w, const Attributes& attributes,
                       const std::optional<calc::EnergyUse>& energy = std::nullopt,
                       const std::vector<RulePack>& packs = builtin_rule_packs()) {
  calc::Project project = project_of({plane_of("desk", {attributes})});
  calc::Space& space = project.spaces.front();
  space.shell = calc::RoomShell{{{0, 0}, {4, 0}, {4, 5}, {0, 5}}, 0.0, 3.0};
  space.energy = energy;
  for (const double power_w : powers_w) {
    calc::LuminaireType type;
    type.power_w = power_w;
    calc::Luminaire luminaire;
    luminaire.type = project.luminaire_types.size();
    project.webs.push_back(even_web());
    project.luminaire_types.push_back(type);
    space.luminaires.push_back(luminaire);
  }
  return bind_project(project, packs);
}

TEST(BindRequirements, KnowsThePowerDensityOfTheRoom) {
  const Attributes attributes{{"quantity", "power-density"}, {"at-most", "6.5"}};
  const Bound bound = bind_in_lit_room({30, 50, 50}, attributes);
  ASSERT_EQ(bound.requirements.size(), 1u) << testing::PrintToString(bound.messages);
  EXPECT_EQ(bound.requirements[0].of_space.value, 6.5);
  EXPECT_EQ(bound.requirements[0].limit, 6.5);
  EXPECT_EQ(bound.requirements[0].problem, "");
  EXPECT_STREQ(unit_of(bound.requirements[0]), "W/m2");
}

TEST(BindRequirements, CannotJudgePowerThatNobodyStates) {
  const Bound bound =
      bind_in_lit_room({30, 0}, {{"quantity", "power-per-100-lx"}, {"at-most", "2"}});
  ASSERT_EQ(bound.requirements.size(), 1u);
  EXPECT_EQ(bound.requirements[0].problem,
            "1 of 2 luminaires have no stated power, neither in the project (power-w) nor in "
            "their photometry");
  const Bound open = bind_one({{"quantity", "power-density"}, {"at-most", "6.5"}});
  ASSERT_EQ(open.requirements.size(), 1u);
  EXPECT_EQ(open.requirements[0].problem, "the floor area of the space is not known");
}

TEST(BindRequirements, KnowsTheEnergyOfTheRoom) {
  // 130 W 0.9 (2000 h 0.8 0.75 + 500 h 0.8) = 187.2 kWh; / 20 m2 + 2.5 = 11.86.
  const calc::EnergyUse use{2000, 500, 2.5, {0.8, 0.75, 0.9}, {}};
  const Attributes attributes{{"quantity", "LENI"}, {"at-most", "12"}};
  const Bound bound = bind_in_lit_room({30, 50, 50}, attributes, use);
  ASSERT_EQ(bound.requirements.size(), 1u) << testing::PrintToString(bound.messages);
  const Requirement& requirement = bound.requirements[0];
  EXPECT_EQ(requirement.metric, Metric::leni);
  EXPECT_EQ(requirement.id, "LENI");
  EXPECT_NEAR(requirement.of_space.value, 11.86, 1e-12);
  EXPECT_EQ(requirement.problem, "");
  EXPECT_THAT(requirement.note.english(), testing::HasSubstr("Fo 0.8, FD 0.75"));
  EXPECT_STREQ(unit_of(requirement), "kWh/m2/a");
  EXPECT_FALSE(is_in_lux(requirement));
}

TEST(BindRequirements, TakesEnergyOfPacks) {
  calc::Diagnostics diagnostics;
  const auto pack = parse_rule_pack(
      "<rule-pack id='own' edition='1' title='Own' version='1' kind='contract' "
      "status='published' licence='internal' role='room'>"
      "<check id='e' role='room' quantity='LENI' statistic='value' at-most='0.5 * 70 kWh/m2/a'/>"
      "</rule-pack>",
      "own.xml", diagnostics);
  ASSERT_TRUE(pack);
  const calc::EnergyUse use{2000, 500, 2.5, {}, {}};
  const Bound bound = bind_in_lit_room({40}, {{"pack", "own"}}, use, {*pack});
  ASSERT_EQ(bound.requirements.size(), 1u) << testing::PrintToString(bound.messages);
  EXPECT_EQ(bound.requirements[0].metric, Metric::leni);
  EXPECT_NEAR(bound.requirements[0].of_space.value, 7.5, 1e-12);  // 100 kWh / 20 m2 + 2.5
  EXPECT_EQ(bound.requirements[0].limit, 35.0);
  EXPECT_EQ(bound.requirements[0].problem, "");
  // The unit is part of the limit.
  EXPECT_FALSE(parse_rule_pack(
      "<rule-pack id='own' edition='1' title='Own' version='1' kind='contract' "
      "status='published' licence='internal' role='room'>"
      "<check id='e' role='room' quantity='LENI' statistic='value' at-most='35 W/m2'/>"
      "</rule-pack>",
      "own.xml", diagnostics));
}

TEST(BindRequirements, CannotJudgeEnergyThatNobodyStates) {
  const Attributes attributes{{"quantity", "LENI"}, {"at-most", "12"}};
  const calc::EnergyUse use{2000, 500, 2.5, {}, {}};
  EXPECT_THAT(bind_in_lit_room({30}, attributes).requirements.at(0).problem.english(),
              testing::HasSubstr("hours of use and parasitic energy are not stated"));
  EXPECT_THAT(bind_in_lit_room({30, 0}, attributes, use).requirements.at(0).problem.english(),
              testing::HasSubstr("1 of 2 luminaires have no stated power"));
  const Attributes dimmed{{"quantity", "LENI"}, {"at-most", "12"}, {"state", "initial"}};
  EXPECT_THAT(bind_in_lit_room({30}, dimmed, use).messages,
              ElementsAre(testing::HasSubstr("'state' has no meaning")));
  const Attributes in_lux{{"quantity", "LENI"}, {"at-most", "12"}, {"unit", "lx"}};
  EXPECT_THAT(bind_in_lit_room({30}, in_lux, use).messages,
              ElementsAre(testing::HasSubstr("'unit' has no meaning")));
}

TEST(BindRequirements, TakesPowerOfRows) {
  const Bound bound = bind_in_lit_room({100}, {{"pack", "ashrae90-1"}, {"row", "open-office"}});
  ASSERT_EQ(bound.requirements.size(), 1u) << testing::PrintToString(bound.messages);
  EXPECT_EQ(bound.requirements[0].metric, Metric::power_density);
  EXPECT_EQ(bound.requirements[0].of_space.value, 5.0);
  EXPECT_NEAR(bound.requirements[0].limit, 0.61 * 10.7639, 1e-4);
  EXPECT_EQ(bound.requirements[0].problem, "");
}

TEST(BindRequirementsMessage, WhatRatingsDoNotHave) {
  const auto messages = [](const Attributes& attributes) {
    return bind_derived(calc::DerivedQuantity::ugr, attributes).messages;
  };
  EXPECT_THAT(messages({{"quantity", "average"}, {"at-most", "19"}}),
              ElementsAre("project.xml:7:10: error[quantity-not-of-points]: <require>: 'average' "
                          "does not apply to points of quantity 'ugr'; allowed: maximum, value, "
                          "share, power-density, LENI, UGR-table, road-luminance, road-Uo, "
                          "road-Ul, TI, REI, ULR, intensity, glare-intensity, "
                          "peak-intensity, luminaire-distance or Ra"));
  EXPECT_THAT(messages({{"quantity", "maximum"}, {"at-most", "19"}, {"unit", "lx"}}),
              ElementsAre(testing::HasSubstr("'unit' has no meaning")));
  EXPECT_THAT(
      messages({{"pack", "en12464-1"}, {"row", "34.2"}, {"role", "task"}}),
      ElementsAre(testing::HasSubstr("is about the quantity 'planar'; this plane measures 'ugr'")));
}

TEST(BindRequirements, ReadsAWaiverBesideALimit) {
  const Attributes waiver{
      {"waived-because", "r"}, {"waived-by", "o"}, {"waived-until", "2028-02-29"}};
  Attributes own{{"quantity", "average"}, {"at-least", "5"}};
  own.insert(own.end(), waiver.begin(), waiver.end());
  const Requirement r = bound_requirement(own);
  ASSERT_TRUE(r.waiver.has_value());
  EXPECT_EQ(r.waiver->reason, "r");
  EXPECT_EQ(r.waiver->owner, "o");
  EXPECT_EQ(r.waiver->until, "2028-02-29");
}

TEST(RequirementsOfPlane, AreItsOwnInOrder) {
  const Attributes average{{"quantity", "average"}, {"at-least", "1"}};
  const Attributes uo{{"quantity", "Uo"}, {"at-least", "0.5"}};
  const Bound bound = bind_project(
      project_of({plane_of("a", {average}), plane_of("b", {uo, average}), plane_of("c", {})}));
  const std::vector<Requirement> own = requirements_of_plane(bound.requirements, "b");
  ASSERT_EQ(own.size(), 2u);
  EXPECT_EQ(own[0].id, "Uo");
  EXPECT_EQ(own[1].id, "average");
  EXPECT_THAT(requirements_of_plane(bound.requirements, "c"), IsEmpty());
}

// --- errors, word by word --------------------------------------------------------------------

TEST(BindRequirementsMessage, UnknownAttribute) {
  EXPECT_THAT(
      messages_of({{"quantity", "average"}, {"at-lest", "500"}, {"at-least", "500"}}),
      ElementsAre(
          "project.xml:7:20: error[unknown-attribute]: unknown attribute 'at-lest' "
          "of <require>; allowed: id, was, quantity, at-least, at-most, percent, at, facing, "
          "state, scene, clause, unit, pack, row, level, level-because, role, facts, from, to, "
          "reflectance, light, waived-because, waived-by or waived-until; did you mean "
          "'at-least'?"));
}

TEST(BindRequirementsMessage, MissingQuantity) {
  EXPECT_THAT(messages_of({{"at-least", "500"}}),
              ElementsAre("project.xml:7:5: error[missing-attribute]: <require> needs the "
                          "attribute 'quantity'"));
}

TEST(BindRequirementsMessage, UnknownQuantity) {
  EXPECT_THAT(messages_of({{"quantity", "avarage"}, {"at-least", "500"}}),
              ElementsAre("project.xml:7:10: error[unknown-value]: attribute 'quantity' of "
                          "<require>: unknown value 'avarage'; allowed: average, minimum, maximum, "
                          "Uo, Ud, percentile, value, share, gradient, power-density, "
                          "power-per-100-lx, LENI, UGR-table, road-luminance, road-Uo, road-Ul, "
                          "TI, REI, GR, ULR, intensity, glare-intensity, peak-intensity, "
                          "luminaire-distance or Ra; "
                          "did you mean 'average'?"));
}

TEST(BindRequirementsMessage, NoLimit) {
  EXPECT_THAT(messages_of({{"quantity", "average"}}),
              ElementsAre("project.xml:7:5: error[missing-form]: <require> needs 'at-least' or "
                          "'at-most'"));
}

TEST(BindRequirementsMessage, TwoLimits) {
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "1"}, {"at-most", "2"}}),
              ElementsAre("project.xml:7:30: error[exclusive-attributes]: <require> has both "
                          "'at-least' and 'at-most'; give only one of them"));
}

TEST(BindRequirementsMessage, LimitThatIsNoNumber) {
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "500 lx"}}),
              ElementsAre("project.xml:7:20: error[not-a-number]: attribute 'at-least' of "
                          "<require>: '500 lx' is not a finite number; expected a limit in lx from "
                          "0 to 1e9"));
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "nan"}}).size(), 1u);
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "1e999"}}).size(), 1u);
}

TEST(BindRequirementsMessage, LimitOutOfRange) {
  EXPECT_THAT(messages_of({{"quantity", "minimum"}, {"at-least", "-5"}}),
              ElementsAre("project.xml:7:20: error[number-out-of-range]: attribute 'at-least' of "
                          "<require>: -5 is not allowed; expected a limit in lx from 0 to 1e9"));
  EXPECT_THAT(messages_of({{"quantity", "minimum"}, {"at-least", "-5"}, {"unit", "fc"}}),
              ElementsAre("project.xml:7:20: error[number-out-of-range]: attribute 'at-least' of "
                          "<require>: -5 is not allowed; expected a limit in fc from 0 to 1e9"));
  EXPECT_THAT(messages_of({{"quantity", "Uo"}, {"at-least", "60"}}),
              ElementsAre("project.xml:7:20: error[number-out-of-range]: attribute 'at-least' of "
                          "<require>: 60 is not allowed; expected a ratio from 0 to 1"));
}

TEST(BindRequirementsMessage, UnknownUnit) {
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "500"}, {"unit", "lux"}}),
              ElementsAre("project.xml:7:30: error[unknown-value]: attribute 'unit' of <require>: "
                          "unknown value 'lux'; allowed: lx or fc; did you mean 'lx'?"));
}

TEST(BindRequirementsMessage, UnitOfARatio) {
  EXPECT_THAT(messages_of({{"quantity", "Uo"}, {"at-least", "0.6"}, {"unit", "lx"}}),
              ElementsAre("project.xml:7:30: error[attribute-without-meaning]: <require>: 'unit' "
                          "has no meaning together with 'quantity=\"Uo\"'"));
}

TEST(BindRequirementsMessage, PercentWithoutPercentile) {
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "5"}, {"percent", "10"}}),
              ElementsAre("project.xml:7:30: error[attribute-without-meaning]: <require>: "
                          "'percent' has no meaning together with 'quantity=\"average\"'"));
}

TEST(BindRequirementsMessage, PercentileWithoutPercent) {
  EXPECT_THAT(messages_of({{"quantity", "percentile"}, {"at-least", "5"}}),
              ElementsAre("project.xml:7:5: error[missing-attribute]: <require> needs the "
                          "attribute 'percent'"));
}

TEST(BindRequirementsMessage, PercentOutOfRange) {
  EXPECT_THAT(messages_of({{"quantity", "percentile"}, {"at-least", "5"}, {"percent", "101"}}),
              ElementsAre("project.xml:7:30: error[number-out-of-range]: attribute 'percent' of "
                          "<require>: 101 is not allowed; expected a number from 0 to 100"));
}

TEST(BindRequirementsMessage, PointWithoutValue) {
  EXPECT_THAT(messages_of({{"quantity", "minimum"}, {"at-least", "5"}, {"at", "0 0 0"}}),
              ElementsAre("project.xml:7:30: error[attribute-without-meaning]: <require>: 'at' has "
                          "no meaning together with 'quantity=\"minimum\"'"));
}

TEST(BindRequirementsMessage, LookThatIsNone) {
  EXPECT_THAT(
      messages_of({{"quantity", "value"}, {"at-least", "5"}, {"at", "0 0 0"}, {"facing", "0 0 0"}}),
      ElementsAre("project.xml:7:40: error[zero-vector]: attribute 'facing' of <require>: the "
                  "direction must not be zero"));
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "5"}, {"facing", "0 0 1"}}),
              ElementsAre("project.xml:7:30: error[attribute-without-meaning]: <require>: 'facing' "
                          "has no meaning together with 'quantity=\"average\"'"));
}

TEST(BindRequirementsMessage, PointThatIsNone) {
  EXPECT_THAT(messages_of({{"quantity", "value"}, {"at-least", "5"}, {"at", "1 2"}}),
              ElementsAre("project.xml:7:30: error[wrong-number-count]: attribute 'at' of "
                          "<require>: expected 3 numbers (x y z) in metres, in world coordinates, "
                          "found 2 numbers"));
}

TEST(BindRequirementsMessage, ValueWithoutPoint) {
  EXPECT_THAT(messages_of({{"quantity", "value"}, {"at-least", "5"}}),
              ElementsAre("project.xml:7:5: error[missing-attribute]: <require> needs the "
                          "attribute 'at'"));
}

TEST(BindRequirementsMessage, UnknownState) {
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "5"}, {"state", "new"}}),
              ElementsAre("project.xml:7:30: error[unknown-value]: attribute 'state' of <require>: "
                          "unknown value 'new'; allowed: maintained or initial"));
}

TEST(BindRequirementsMessage, UnknownScene) {
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "5"}, {"scene", "nigth"}}),
              ElementsAre("project.xml:7:30: error[unknown-reference]: attribute 'scene' of "
                          "<require>: there is no scene 'nigth'; allowed: full or night"));
  calc::Project project = project_of(
      {plane_of("desk", {{{"quantity", "average"}, {"at-least", "5"}, {"scene", "full"}}})});
  project.scenes.clear();
  EXPECT_THAT(bind_project(project).messages,
              ElementsAre("project.xml:7:30: error[unknown-reference]: attribute 'scene' of "
                          "<require>: there is no scene 'full'; no scene is defined"));
}

TEST(BindRequirementsMessage, RepeatedId) {
  const Attributes first{{"id", "x"}, {"quantity", "average"}, {"at-least", "1"}};
  const Attributes second{{"quantity", "minimum"}, {"at-least", "1"}, {"id", "x"}};
  EXPECT_THAT(bind_project(project_of({plane_of("desk", {first, second})})).messages,
              ElementsAre("project.xml:8:30: error[duplicate-id]: the requirement id 'x' is "
                          "given twice, also in line 7"));
  EXPECT_THAT(bind_project(project_of({plane_of("a", {first}), plane_of("b", {second})})).messages,
              IsEmpty());
}

TEST(BindRequirementsMessage, EmptyId) {
  EXPECT_THAT(messages_of({{"id", ""}, {"quantity", "average"}, {"at-least", "1"}}),
              ElementsAre("project.xml:7:10: error[empty-attribute]: attribute 'id' of <require> "
                          "must not be empty"));
}

TEST(BindRequirementsMessage, OtherAttributesBesidePack) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}, {"row", "34.2"}, {"at-least", "300"}}),
              ElementsAre("project.xml:7:30: error[attribute-without-meaning]: <require>: "
                          "'at-least' has no meaning together with 'pack'"));
}

TEST(BindRequirementsMessage, RowAndPackOnTheirOwn) {
  EXPECT_THAT(messages_of({{"row", "34.2"}}),
              ElementsAre("project.xml:7:10: error[missing-partner]: <require> has 'row' without "
                          "'pack'; the two belong together"));
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}}),
              ElementsAre("project.xml:7:10: error[missing-partner]: <require> has 'pack' without "
                          "'row'; the two belong together"));
}

TEST(BindRequirementsMessage, LevelWithoutPack) {
  EXPECT_THAT(messages_of({{"level", "modified"}}),
              ElementsAre("project.xml:7:10: error[missing-partner]: <require> has 'level' without "
                          "'pack'; the two belong together"));
}

TEST(BindRequirementsMessage, UnknownLevel) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}, {"row", "34.2"}, {"level", "require"}}),
              ElementsAre("project.xml:7:30: error[unknown-value]: attribute 'level' of <require>: "
                          "unknown value 'require'; allowed: required, modified, -3, -2, -1, +1, "
                          "+2 or +3; did you mean 'required'?"));
}

TEST(BindRequirementsMessage, UnknownPack) {
  const Bound bound =
      bind_project(project_of({plane_of("desk", {{{"pack", "owm"}, {"row", "r1"}}})}),
                   {small_pack("own", "1", 1)});
  EXPECT_THAT(bound.messages,
              ElementsAre("project.xml:7:10: error[unknown-reference]: attribute 'pack' of "
                          "<require>: there is no rule pack 'owm'; allowed: own:1 (1.xml); did you "
                          "mean 'own'?"));
}

TEST(BindRequirementsMessage, UnknownRow) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}, {"row", "34.9"}}),
              ElementsAre("project.xml:7:20: error[unknown-reference]: attribute 'row' of "
                          "<require>: there is no row '34.9'; allowed: 9.1, 9.2, 9.3, 9.4, 9.5, "
                          "9.6, 10.1, 10.2, 10.3, 10.4, 10.5, 10.6, 10.7, 10.8, 11.1, 11.2, 11.3, "
                          "12.1, 12.2 or 12.3 and 305 more; did you mean '30.9'?"));
}

TEST(BindRequirementsMessage, AmbiguousPack) {
  const std::vector<RulePack> packs{small_pack("own", "1", 1), small_pack("own", "2", 1)};
  const auto project = [](const std::string& pack) {
    return project_of({plane_of("desk", {{{"pack", pack}, {"row", "r1"}}})});
  };
  EXPECT_THAT(bind_project(project("own"), packs).messages,
              ElementsAre("project.xml:7:10: error[ambiguous-rule-pack]: rule pack 'own' is loaded "
                          "more than once: own:1 (1.xml), own:2 (2.xml); write id:edition, and "
                          "load each edition once"));
  EXPECT_THAT(bind_project(project("own:2"), packs).messages, IsEmpty());
  EXPECT_EQ(bind_project(project("own:2"), packs).requirements.at(0).clause, "Own:2 r1");
}

TEST(BindRequirementsMessage, WaiversThatAreNone) {
  const auto message = [](const std::string& until) {
    return messages_of({{"quantity", "average"},
                        {"at-least", "5"},
                        {"waived-because", "r"},
                        {"waived-by", "o"},
                        {"waived-until", until}});
  };
  for (const char* until : {"2027-02-29", "2027-13-01", "2027-1-1", "soon", "2027-00-10"}) {
    EXPECT_THAT(message(until),
                ElementsAre("project.xml:7:50: error[waiver-incomplete]: attribute "
                            "'waived-until' of <require>: '" +
                            std::string(until) + "' is not a date; expected YYYY-MM-DD"));
  }
  EXPECT_THAT(
      messages_of({{"quantity", "average"}, {"at-least", "5"}, {"waived-because", "r"}}),
      ElementsAre(testing::HasSubstr("<require> has 'waived-because' without 'waived-by'")));
}

TEST(BindRequirementsMessage, SharesThatAreNone) {
  EXPECT_THAT(messages_of({{"quantity", "share"}, {"at-least", "0.9"}}),
              ElementsAre(testing::HasSubstr("<require> needs 'from' or 'to', or both")));
  EXPECT_THAT(
      messages_of({{"quantity", "share"}, {"at-least", "0.9"}, {"from", "5"}, {"to", "4"}}),
      ElementsAre(testing::HasSubstr("attribute 'to' of <require>: must be larger than 'from'")));
  EXPECT_THAT(messages_of({{"quantity", "average"}, {"at-least", "9"}, {"from", "5"}}),
              ElementsAre(testing::HasSubstr("'from' has no meaning together with "
                                             "'quantity=\"average\"'")));
}

TEST(BindRequirementsMessage, UnknownRole) {
  EXPECT_THAT(messages_of({{"pack", "en1838"}, {"role", "rout"}, {"scene", "night"}}),
              ElementsAre("project.xml:7:20: error[unknown-reference]: attribute 'role' of "
                          "<require>: there is no role 'rout'; allowed: route, open-area, "
                          "route-5s, route-60s, open-area-5s, open-area-60s, high-risk, "
                          "safety-item, emphasis, glare, glare-stairs or glare-high-risk; "
                          "did you mean 'route'?"));
}

TEST(BindRequirementsMessage, LevelWithoutRow) {
  EXPECT_THAT(messages_of({{"pack", "en1838"}, {"scene", "night"}, {"level", "modified"}}),
              ElementsAre("project.xml:7:30: error[missing-partner]: <require> has 'level' without "
                          "'row'; the two belong together"));
}

TEST(BindRequirementsMessage, EmergencyWithoutScene) {
  EXPECT_THAT(messages_of({{"pack", "en1838"}}),
              ElementsAre("project.xml:7:5: error[rule-needs-scene]: role 'route' of rule pack "
                          "'en1838:2024' is judged with emergency luminaires only: name the scene "
                          "that lights only these, scene=\"...\""));
}

TEST(BindRequirementsMessage, PlaneThatMeasuresSomethingElse) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}, {"row", "34.2"}, {"role", "cylinder"}}),
              ElementsAre("project.xml:7:5: error[rule-wrong-quantity]: role 'cylinder' of rule "
                          "pack 'en12464-1:2021' is about the quantity 'cylindrical'; this plane "
                          "measures 'planar'"));
}

TEST(BindRequirementsMessage, FactsThatAreNone) {
  const auto message = [](const std::string& facts) {
    return messages_of(
        {{"pack", "en1838"}, {"role", "high-risk"}, {"scene", "night"}, {"facts", facts}});
  };
  const std::string head = "project.xml:7:40: error[rule-fact]: attribute 'facts' of <require>: ";
  const std::string tail =
      ": 'task-illuminance' is an illuminance (lx, fc), given once; expected "
      "'task-illuminance=NUMBER lx'";
  EXPECT_THAT(message("task-illuminance=500"), ElementsAre(head + "'task-illuminance=500'" + tail));
  EXPECT_THAT(message("task-illuminance"), ElementsAre(head + "'task-illuminance'" + tail));
  EXPECT_THAT(message("task-illuminance=5 lx; task-illuminance=6 lx"),
              ElementsAre(head + "'task-illuminance=6 lx'" + tail));
  EXPECT_THAT(message("area=5 m"),
              ElementsAre("project.xml:7:40: error[unknown-reference]: attribute 'facts' of "
                          "<require>: there is no fact 'area'; allowed: task-illuminance"));
}

TEST(BindRequirementsMessage, RoleForWhichTheRowHasNothing) {
  const RulePack pack = small_pack(
      "own", "1", 1,
      "<parameter id='W' unit='lx' meaning='m'/>"
      "<check id='w' role='wall' quantity='planar' statistic='minimum' at-least='row(W)'/>");
  const Bound bound = bind_project(
      project_of({plane_of("desk", {{{"pack", "own"}, {"row", "r1"}, {"role", "wall"}}})}), {pack});
  EXPECT_THAT(
      bound.messages,
      ElementsAre("project.xml:7:5: error[rule-requires-nothing]: rule pack 'own:1' row "
                  "'r1' requires nothing of the role 'wall'; it requires something of desk"));
}

TEST(BindRequirementsMessage, NoModifiedLevel) {
  const calc::Project project =
      project_of({plane_of("desk", {{{"pack", "own"}, {"row", "r1"}, {"level", "modified"}}})});
  const Bound bound = bind_project(project, {small_pack("own", "1", 1)});
  EXPECT_THAT(bound.requirements, IsEmpty());
  EXPECT_THAT(bound.messages,
              ElementsAre("project.xml:7:30: error[no-such-level]: row 'r1' of rule pack "
                          "'own:1' has no values of level 'modified'; allowed: required"));
}

TEST(BindRequirementsMessage, StepsThatTheStandardDoesNotHave) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"},
                           {"row", "34.2"},
                           {"level", "-2"},
                           {"level-because", "seldom used"}}),
              ElementsAre("project.xml:7:30: error[no-such-level]: row '34.2' of rule pack "
                          "'en12464-1:2021' has no values of level '-2'; allowed: required, "
                          "modified, -1, +1 or +2"));
}

TEST(BindRequirementsMessage, StepsWithoutAReason) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}, {"row", "34.2"}, {"level", "+1"}}),
              ElementsAre("project.xml:7:30: error[missing-partner]: <require> has 'level' "
                          "without 'level-because'; the two belong together"));
}

TEST(BindRequirementsMessage, AReasonForNoOtherLevel) {
  EXPECT_THAT(messages_of({{"pack", "en12464-1"}, {"row", "34.2"}, {"level-because", "why"}}),
              ElementsAre("project.xml:7:30: error[attribute-without-meaning]: <require>: "
                          "'level-because' has no meaning together with 'level=\"required\"'"));
}

TEST(BindRequirementsMessage, ListsAFewOfManyRows) {
  const calc::Project project = project_of({plane_of("desk", {{{"pack", "own"}, {"row", "x"}}})});
  const Bound bound = bind_project(project, {small_pack("own", "1", 22)});
  ASSERT_EQ(bound.messages.size(), 1u);
  EXPECT_THAT(bound.messages[0], testing::HasSubstr("r19 or r20 and 2 more"));
}

TEST(BindRequirementsMessage, AllErrorsAreReported) {
  const Bound bound = bind_project(project_of({plane_of(
      "desk", {{{"quantity", "average"}, {"at-least", "-1"}, {"state", "old"}, {"scene", "x"}},
               {{"quantity", "Uo"}, {"at-least", "0.5"}},
               {{"quantity", "what"}}})}));
  EXPECT_EQ(bound.messages.size(), 4u);
  ASSERT_EQ(bound.requirements.size(), 1u);
  EXPECT_EQ(bound.requirements[0].id, "Uo");
}

}  // namespace
}  // namespace rules::bind_test
