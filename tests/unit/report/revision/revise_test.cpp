#include "report/revision/revise.h"

#include "calc/base/diagnostic_ids.h"
#include "report/result_file/read_json.h"
#include "report/revision/gate.h"
#include "report/revision/results.h"
#include "report/revision/revision_tables.h"
#include "tests/support/message_text.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace report::revise_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr Gate kRegression{GateMode::regression, 0.01, ""};

Document base() {
  Document document = small_document();
  document.provenance.replicates = 16;
  document.provenance.max_paths = 1024;
  ProjectPart& project = document.projects[0];
  LuminaireRow row;
  row.type_id = "panel";
  row.photometry_file = "panel.ies";
  row.sha256 = "0123456789";
  row.count = 1;
  row.flux_lm = row.file_flux_lm = 4000;
  row.power_w = row.file_power_w = 30;
  row.max_intensity_cd = 1500;
  row.maintenance_factor = 0.8;
  project.luminaires = {row};
  LuminaireMark mark;
  mark.position_m = {2, 1, 3};
  mark.type_id = "panel";
  project.spaces[0].luminaires = {mark};
  project.spaces[0].scene_sha256 = "the light of today";
  return document;
}

rules::Finding& finding(Document& document, std::size_t k = 0) {
  return document.projects[0].spaces[0].planes[0].findings.at(k);
}
PlanePart& plane(Document& document) { return document.projects[0].spaces[0].planes[0]; }

// A point of the plane is left out.
void lose(Document& document, std::size_t k) {
  PlanePart& of = plane(document);
  const PointRow& point = of.points.at(k);
  of.grid.dropped.push_back(
      {point.position_m, point.column, point.row, calc::DropReason::inside_solid, "desk"});
  of.points.erase(of.points.begin() + static_cast<std::ptrdiff_t>(k));
}

Revision revised(const std::function<void(Document&)>& change, const Gate& gate = kRegression) {
  const Document before = base();
  Document after = before;
  change(after);
  return revise(before, after, "main.json", gate);
}

std::vector<std::string> asked(const Revision& revision) {
  std::vector<std::string> list;
  for (const ChangedQuestion& question : revision.questions) {
    list.push_back(std::string(calc::name_of(question.change)) + " " +
                   std::string(calc::name_of(question.part)));
  }
  return list;
}

std::vector<std::string> became(const Revision& revision) {
  std::vector<std::string> list;
  for (const ChangedResult& result : revision.results) {
    list.emplace_back(calc::name_of(result.change));
  }
  return list;
}

void set_measured(rules::Finding& of, const calc::Estimate& measured) {
  of.measured = measured;
  judge_again(of);
}

void fail_first(Document& document) {
  rules::Finding& of = finding(document);
  const bool is_lower = rules::is_lower_limit(of.requirement.comparison);
  set_measured(
      of, estimate((is_lower ? 0.8 : 1.2) * of.requirement.limit, 0.001 * of.requirement.limit));
}

TEST(Revise, OfTheSameDocumentNothingHasChanged) {
  const Revision revision = revised([](Document&) {});
  EXPECT_THAT(became(revision), IsEmpty());
  EXPECT_THAT(asked(revision), IsEmpty());
  EXPECT_THAT(revision.inputs, IsEmpty());
  EXPECT_EQ(revision.same, base().projects[0].spaces[0].planes[0].findings.size());
}

// 1.5 W/m2 of 2, of the rooms a and b.
void add_building(Document& document) {
  rules::Finding sum;
  sum.requirement.id = "power-density";
  sum.requirement.metric = rules::Metric::power_density;
  sum.requirement.comparison = rules::Comparison::at_most;
  sum.requirement.limit = 2.0;
  set_measured(sum, {1.5, 1.5, 1.5});
  rules::AggregateFinding building;
  building.kind = rules::AggregateKind::building;
  building.rule = rules::AggregateRule::sum;
  building.over = rules::AggregateOver::rooms;
  building.id = "B/power-density";
  building.building_id = "B";
  building.verdict = sum.verdict;
  building.sum = sum;
  for (const char* name : {"a", "b"}) {
    rules::AggregateMember room;
    room.name = name;
    room.verdict = rules::Verdict::pass;
    room.value = 1.5;
    room.area_m2 = 10.0;
    room.stated = calc::Message::words("1000 h");
    building.members.push_back(room);
  }
  document.projects[0].aggregates = {building};
}

Revision building_revised(const std::function<void(rules::AggregateFinding&)>& change) {
  Document before = base();
  add_building(before);
  Document after = before;
  change(after.projects[0].aggregates[0]);
  return revise(before, after, "main.json", kRegression);
}

TEST(Revise, OfABuildingQuestionsAreNamed) {
  using Building = rules::AggregateFinding;
  EXPECT_THAT(asked(building_revised([](Building&) {})), IsEmpty());
  EXPECT_THAT(asked(building_revised([](Building& b) { b.sum->requirement.limit = 2.5; })),
              ElementsAre("weaker limit"));
  EXPECT_THAT(asked(building_revised([](Building& b) { b.sum->requirement.limit = 1.8; })),
              ElementsAre("stricter limit"));
  EXPECT_THAT(asked(building_revised([](Building& b) { b.members.pop_back(); })),
              ElementsAre("weaker aggregate"));
  EXPECT_THAT(asked(building_revised([](Building& b) { b.members[1].name = "c"; })),
              ElementsAre("weaker aggregate", "stricter aggregate"));
  // A new room that takes less makes up for the others.
  EXPECT_THAT(asked(building_revised([](Building& b) {
                b.members.push_back(b.members[0]);
                b.members.back().name = "store";
                b.members.back().value = 0.1;
              })),
              ElementsAre("exchanged aggregate"));
  Document before = base();
  add_building(before);
  before.projects[0].aggregates[0].verdict = rules::Verdict::not_judged;
  before.projects[0].aggregates[0].sum->verdict = rules::Verdict::not_judged;
  Document after = before;
  after.projects[0].aggregates[0].members.push_back(before.projects[0].aggregates[0].members[0]);
  after.projects[0].aggregates[0].members.back().name = "store";
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)),
              ElementsAre("exchanged aggregate"));
  EXPECT_THAT(asked(building_revised(
                  [](Building& b) { b.members[1].stated = calc::Message::words("10 h"); })),
              ElementsAre("exchanged energy"));
  const rules::Waiver waiver{"later", "A. Meier", "2027-06-30"};
  EXPECT_THAT(asked(building_revised([&](Building& b) { b.sum->requirement.waiver = waiver; })),
              ElementsAre("weaker waiver"));
}

// A luminaire that is added must not say more by hand than its file does, or than the same
// photometry did before.
TEST(Revise, LuminairesThatAreAddedAreHeldAgainstTheirFile) {
  const auto added = [](const std::function<void(LuminaireRow&)>& change) {
    return asked(revised([&](Document& d) {
      ProjectPart& project = d.projects[0];
      LuminaireRow row = project.luminaires.at(0);
      row.type_id = "boost";
      change(row);
      project.luminaires.push_back(row);
      LuminaireMark mark;
      mark.position_m = {5, 5, 3};
      mark.type_id = "boost";
      project.spaces[0].luminaires.push_back(mark);
    }));
  };
  EXPECT_THAT(added([](LuminaireRow&) {}), IsEmpty());
  EXPECT_THAT(added([](LuminaireRow& row) { row.flux_lm = 7000; }), ElementsAre("weaker flux"));
  EXPECT_THAT(added([](LuminaireRow& row) { row.power_w = 20; }), ElementsAre("weaker power"));
  EXPECT_THAT(added([](LuminaireRow& row) { row.maintenance_factor = 1.0; }),
              ElementsAre("weaker maintenance-factor"));
  EXPECT_THAT(added([](LuminaireRow& row) {
                row.sha256 = "other";
                row.flux_lm = 7000;
                row.maintenance_factor = 0.9;
              }),
              ElementsAre("weaker maintenance-factor", "weaker flux"));
  EXPECT_THAT(added([](LuminaireRow& row) { row.flux_lm = 100; }), IsEmpty());
}

// In folders of their own, and the folders in another one.
TEST(Revise, ProjectsOfOneNameAreMatchedByTheirFolder) {
  Document before = base();
  before.projects.push_back(before.projects[0]);
  for (ProjectPart& project : before.projects) project.name = "";
  before.projects[0].path = "a/project.xml";
  before.projects[1].path = "b/project.xml";
  Document after = before;
  after.projects[0].path = "x/a/project.xml";
  after.projects[1].path = "x/b/project.xml";
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)), IsEmpty());
  // With paths that say nothing, by the files themselves.
  before.projects[0].inputs = after.projects[0].inputs = {{"a/project.xml", "11"}};
  before.projects[1].inputs = after.projects[1].inputs = {{"b/project.xml", "22"}};
  after.projects[0].path = "project1/project.xml";
  after.projects[1].path = "project2/project.xml";
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)), IsEmpty());
}

// Which other aggregates have not: a value that becomes worse, though the limit is met.
TEST(Revise, OfABuildingAWorseValueStopsTheGate) {
  const Revision worse = building_revised([](rules::AggregateFinding& b) {
    set_measured(*b.sum, {1.6, 1.6, 1.6});
  });
  EXPECT_THAT(became(worse), ElementsAre("worse"));
  EXPECT_EQ(reasons_of(worse).results.size(), 1u);
  EXPECT_TRUE(worse.results[0].is_aggregate);
  const Revision little = building_revised([](rules::AggregateFinding& b) {
    set_measured(*b.sum, {1.51, 1.51, 1.51});
  });
  EXPECT_TRUE(reasons_of(little).results.empty());
}

TEST(Revise, OfABuildingThatWasRenamedNothingHasChanged) {
  const Revision renamed = building_revised([](rules::AggregateFinding& b) {
    b.id = "house/power-density";
    b.building_id = "house";
    b.building_was = "B";
  });
  EXPECT_THAT(became(renamed), IsEmpty());
  EXPECT_THAT(asked(renamed), IsEmpty());
}

struct QuestionCase {
  const char* name;
  std::function<void(Document&)> change;
  std::vector<std::string> asked;
};

class ChangedQuestions : public ::testing::TestWithParam<QuestionCase> {};

// What each of them is called, that a gate stops at it unless it is stricter, and that the other
// way round it is the opposite.
TEST_P(ChangedQuestions, AreNamedAndStopTheGate) {
  const Document before = base();
  Document after = before;
  GetParam().change(after);
  const Revision forth = revise(before, after, "main.json", kRegression);
  EXPECT_EQ(asked(forth), GetParam().asked);
  EXPECT_FALSE(reasons_of(forth).questions.empty());
  const Revision back = revise(after, before, "main.json", kRegression);
  ASSERT_EQ(back.questions.size(), forth.questions.size());
  for (std::size_t k = 0; k < back.questions.size(); ++k) {
    const bool is_exchanged = forth.questions[k].change == QuestionChange::exchanged;
    EXPECT_EQ(back.questions[k].change,
              is_exchanged ? QuestionChange::exchanged : QuestionChange::stricter);
    EXPECT_EQ(back.questions[k].before, forth.questions[k].after);
  }
  Revision accepted = forth;
  accepted.gate.weaker_accepted_by = "the client agreed";
  EXPECT_TRUE(reasons_of(accepted).questions.empty());
}

const rules::Waiver kWaiver{"glass", "A. Meier", "2027-06-30"};

INSTANTIATE_TEST_SUITE_P(
    All, ChangedQuestions,
    ::testing::Values(
        QuestionCase{"LimitLowered",
                     [](Document& d) { finding(d).requirement.limit *= 0.75; },
                     {"weaker limit"}},
        QuestionCase{
            "Comparison",
            [](Document& d) { finding(d).requirement.comparison = rules::Comparison::at_most; },
            {"exchanged quantity"}},
        QuestionCase{"Scene",
                     [](Document& d) { finding(d).requirement.scene = "bright"; },
                     {"exchanged light"}},
        QuestionCase{"Initial",
                     [](Document& d) { finding(d).requirement.state = rules::LightState::initial; },
                     {"exchanged light"}},
        QuestionCase{"DirectOnly",
                     [](Document& d) { finding(d).requirement.direct_only = true; },
                     {"exchanged light"}},
        QuestionCase{"Advice",
                     [](Document& d) { finding(d).requirement.severity = rules::Severity::advice; },
                     {"weaker severity"}},
        QuestionCase{"Metric",
                     [](Document& d) { finding(d).requirement.metric = rules::Metric::maximum; },
                     {"exchanged quantity"}},
        QuestionCase{"Waiver",
                     [](Document& d) { finding(d).requirement.waiver = kWaiver; },
                     {"weaker waiver"}},
        QuestionCase{"Deviation",
                     [](Document& d) {
                       finding(d).requirement.deviations = {{rules::FitAspect::grid,
                                                             calc::Message::words("1 x 1 points"),
                                                             kWaiver, true}};
                     },
                     {"weaker deviation"}},
        QuestionCase{"Tolerance",
                     [](Document& d) { finding(d).requirement.policy.tolerance = 0.05; },
                     {"weaker policy"}},
        QuestionCase{"Rounding",
                     [](Document& d) { finding(d).requirement.policy.compares_rounded = true; },
                     {"weaker policy"}},
        QuestionCase{"Mask",
                     [](Document& d) { finding(d).requirement.mask.id = "inner"; },
                     {"exchanged mask"}},
        QuestionCase{"Energy",
                     [](Document& d) {
                       finding(d).requirement.metric = rules::Metric::leni;
                       finding(d).requirement.stated_words = calc::Message::words("100 h by day");
                     },
                     {"exchanged quantity", "exchanged energy"}},
        QuestionCase{"Stated",
                     [](Document& d) {
                       finding(d).requirement.stated_words = calc::Message::words("surface R1");
                     },
                     {"exchanged stated"}},
        QuestionCase{
            "ExactPoint",
            [](Document& d) {
              finding(d).requirement.arguments = rules::PointOfValue{glm::dvec3{1, 1, 1}, {}};
            },
            {"exchanged quantity"}},
        QuestionCase{"RequirementGone",
                     [](Document& d) { plane(d).findings.pop_back(); },
                     {"weaker requirement"}},
        QuestionCase{"PlaneGone",
                     [](Document& d) { d.projects[0].spaces[0].planes.clear(); },
                     {"weaker plane"}},
        QuestionCase{
            "RoomGone", [](Document& d) { d.projects[0].spaces.clear(); }, {"weaker room"}},
        QuestionCase{"ProjectGone", [](Document& d) { d.projects.clear(); }, {"weaker project"}},
        QuestionCase{"Facing",
                     [](Document& d) {
                       plane(d).points.at(1).normal = {1, 0, 0};
                     },
                     {"exchanged area"}},
        QuestionCase{"MaintenanceFactorOfATypeByAnotherId",
                     [](Document& d) {
                       d.projects[0].luminaires.at(0).type_id = "other";
                       d.projects[0].luminaires.at(0).maintenance_factor *= 1.1;
                     },
                     {"weaker maintenance-factor"}},
        QuestionCase{
            "Margin", [](Document& d) { plane(d).grid.margin_m += 0.5; }, {"weaker margin"}},
        QuestionCase{"Grid",
                     [](Document& d) {
                       plane(d).grid.columns -= 1;
                       plane(d).points.pop_back();
                     },
                     {"weaker grid"}},
        QuestionCase{"LostPoints", [](Document& d) { lose(d, 1); }, {"weaker lost-points"}},
        QuestionCase{"MaintenanceFactor",
                     [](Document& d) { d.projects[0].luminaires.at(0).maintenance_factor *= 1.1; },
                     {"weaker maintenance-factor"}},
        QuestionCase{"Flux",
                     [](Document& d) { d.projects[0].luminaires.at(0).flux_lm *= 1.1; },
                     {"weaker flux"}},
        QuestionCase{"Power",
                     [](Document& d) { d.projects[0].luminaires.at(0).power_w *= 0.9; },
                     {"weaker power"}},
        QuestionCase{"Confidence",
                     [](Document& d) { d.provenance.confidence = 0.9; },
                     {"weaker confidence"}},
        QuestionCase{
            "Tolerance2", [](Document& d) { d.provenance.tolerance *= 2; }, {"weaker accuracy"}},
        QuestionCase{
            "Replicates", [](Document& d) { d.provenance.replicates -= 8; }, {"weaker accuracy"}},
        QuestionCase{
            "MaxPaths", [](Document& d) { d.provenance.max_paths /= 2; }, {"weaker accuracy"}},
        QuestionCase{
            "Method", [](Document& d) { d.provenance.method = "--clamp 1"; }, {"exchanged method"}},
        QuestionCase{"FluxOfAnotherFile",
                     [](Document& d) {
                       d.projects[0].luminaires.at(0).sha256 = "other";
                       d.projects[0].luminaires.at(0).flux_lm *= 1.1;
                     },
                     {"weaker flux"}},
        QuestionCase{"PowerOfAnotherFile",
                     [](Document& d) {
                       d.projects[0].luminaires.at(0).sha256 = "other";
                       d.projects[0].luminaires.at(0).power_w *= 0.9;
                     },
                     {"weaker power"}},
        QuestionCase{"MaintenanceFactorOfAnotherTypeInItsPlace",
                     [](Document& d) {
                       ProjectPart& project = d.projects[0];
                       project.luminaires.push_back(project.luminaires.at(0));
                       project.luminaires[1].type_id = "other";
                       project.luminaires[1].maintenance_factor *= 1.1;
                       project.spaces[0].luminaires.at(0).type_id = "other";
                     },
                     {"weaker maintenance-factor"}}),
    [](const auto& param) { return std::string(param.param.name); });

TEST(Revise, PointsThatLieElsewhereAreExchanged) {
  const Revision revision = revised([](Document& d) { plane(d).points.at(0).position_m.z += 0.1; });
  EXPECT_THAT(asked(revision), ElementsAre("exchanged grid"));
  EXPECT_THAT(revision.questions.at(0).after, HasSubstr("up to 0.1 m elsewhere"));
}

TEST(Revise, ASmallerAreaIsWeakerAndALargerOneExchanged) {
  const auto with_width = [](double more_m) {
    return revised([&](Document& d) {
      plane(d).outline_m.at(1).x += more_m;
      plane(d).outline_m.at(2).x += more_m;
    });
  };
  EXPECT_THAT(asked(with_width(-0.1)), ElementsAre("weaker area"));
  EXPECT_THAT(asked(with_width(0.1)), ElementsAre("exchanged area"));
}

TEST(Revise, AsManyPointsLeftOutButOthersAreExchanged) {
  Document before = base(), after = before;
  lose(before, 0);
  lose(after, 1);
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)),
              ElementsAre("exchanged lost-points"));
}

TEST(Revise, ARectangleMayBeginAtAnyCornerAndItsPointsStandInAnyOrder) {
  const Revision revision = revised([](Document& d) {
    PlanePart& of = plane(d);
    std::rotate(of.outline_m.begin(), of.outline_m.begin() + 1, of.outline_m.end());
    std::reverse(of.outline_m.begin(), of.outline_m.end());
    std::swap(of.grid.columns, of.grid.rows);
    std::swap(of.points.at(0), of.points.at(1));
    for (PointRow& point : of.points) std::swap(point.column, point.row);
  });
  EXPECT_THAT(asked(revision), IsEmpty());
  EXPECT_THAT(revised([](Document& d) { plane(d).outline_m.at(0).x -= 0.001; }).questions,
              ::testing::SizeIs(1));
}

TEST(Revise, PointsAreTheSameWithinRoundingWhereverTheyLie) {
  for (const double place_m : {0.0, 0.001, -12.3456789, 4711.0}) {
    Document before = base();
    plane(before).points.at(0).position_m.x = place_m;
    Document after = before;
    plane(after).points.at(0).position_m.x += 0.9e-6;
    EXPECT_THAT(asked(revise(before, after, "", kRegression)), IsEmpty()) << place_m;
    plane(after).points.at(0).position_m.x = place_m - 0.9e-6;
    EXPECT_THAT(asked(revise(before, after, "", kRegression)), IsEmpty()) << place_m;
    plane(after).points.at(0).position_m.x = place_m + 2e-6;
    EXPECT_THAT(asked(revise(before, after, "", kRegression)), ElementsAre("exchanged grid"));
  }
}

TEST(Revise, AFailureWhoseWaiverIsOverIsBroken) {
  Document before = base();
  fail_first(before);
  finding(before).requirement.waiver = kWaiver;
  finding(before).is_waived = true;
  Document after = before;
  finding(after).is_waived = false;
  const Revision revision = revise(before, after, "main.json", kRegression);
  EXPECT_EQ(became(revision), std::vector<std::string>{"broken"});
  EXPECT_EQ(revision.known_failures, 1u) << "the other one";
  EXPECT_EQ(reasons_of(revision).results.size(), 1u);
  EXPECT_THAT(became(revise(before, before, "main.json", kRegression)), IsEmpty());
}

TEST(Revise, WhatTheIntervalDoesNotExcludeIsCounted) {
  const auto untold = [](double half_width, const Gate& gate) {
    Document document = base();
    set_measured(finding(document), estimate(600, half_width));
    return revise(document, document, "main.json", gate).untold;
  };
  EXPECT_EQ(untold(1.0, {GateMode::regression, 0.02, ""}), 0u);
  EXPECT_EQ(untold(12.0, {GateMode::regression, 0.02, ""}), 1u);  // 17 of 600
  EXPECT_EQ(untold(12.0, {GateMode::regression, 0.03, ""}), 0u);
}

TEST(Revise, RequirementsWithoutIdsMayChangePlaces) {
  Document before = base();
  finding(before, 1).requirement.metric = rules::Metric::average;
  finding(before, 1).requirement.id = "average-2";
  const Revision swapped = revise(
      before,
      [&] {
        Document after = before;
        std::swap(plane(after).findings[0], plane(after).findings[1]);
        std::swap(finding(after, 0).requirement.id, finding(after, 1).requirement.id);
        return after;
      }(),
      "main.json", kRegression);
  EXPECT_THAT(asked(swapped), IsEmpty());
  EXPECT_THAT(became(swapped), IsEmpty());
  EXPECT_EQ(swapped.same, 2u);
}

TEST(Revise, FilesThatChangedWithoutEffectAreNoted) {
  Document before = base();
  before.projects[0].inputs = {{"office.xml", "0123"}, {"panel.ies", "4567"}};
  Document after = before;
  after.projects[0].inputs[1].sha256 = "89ab";
  EXPECT_THAT(calc::texts(revise(before, after, "", kRegression).notes),
              ElementsAre(HasSubstr("panel.ies")));
  finding(after).requirement.limit -= 1.0;  // that says enough
  EXPECT_THAT(calc::texts(revise(before, after, "", kRegression).notes), IsEmpty());
}

TEST(Revise, ALimitBelowWhichIsToStayIsWeakerWhereItRises) {
  Document before = base();
  finding(before).requirement.comparison = rules::Comparison::at_most;
  Document after = before;
  finding(after).requirement.limit *= 1.1;
  EXPECT_THAT(asked(revise(before, after, "main.json", {})), ElementsAre("weaker limit"));
}

TEST(Revise, AnotherRowIsExchangedAndALimitOfOnesOwnIsWeakerThanARow) {
  Document own = base(), row = base(), other = base();
  finding(row).requirement.origin = {"en12464-1:2021", "task.Em", "34.2", {}, {}, {}};
  finding(other).requirement.origin = {"en12464-1:2021", "task.Em", "34.3", {}, {}, {}};
  EXPECT_THAT(asked(revise(row, other, "main.json", {})), ElementsAre("exchanged rule"));
  EXPECT_THAT(asked(revise(row, own, "main.json", {})), ElementsAre("weaker rule"));
  EXPECT_THAT(asked(revise(own, row, "main.json", {})), ElementsAre("exchanged rule"));
  Document lower = row;
  finding(lower).requirement.origin.level = rules::level_named("-1");
  EXPECT_THAT(asked(revise(row, lower, "main.json", {})), ElementsAre("weaker rule"));
}

TEST(Revise, ALongerWaiverIsWeaker) {
  Document before = base();
  finding(before).requirement.waiver = kWaiver;
  Document after = before;
  finding(after).requirement.waiver->until = "2028-01-01";
  EXPECT_THAT(asked(revise(before, after, "main.json", {})), ElementsAre("weaker waiver"));
  EXPECT_THAT(asked(revise(after, before, "main.json", {})), ElementsAre("stricter waiver"));
}

TEST(Revise, AnotherFolderOrNameOfAProjectChangesNothing) {
  const Revision moved = revised([](Document& d) { d.projects[0].path = "elsewhere/other.xml"; });
  EXPECT_THAT(asked(moved), IsEmpty());
  const Revision renamed = revised([](Document& d) { d.projects[0].name = "Other name"; });
  EXPECT_THAT(asked(renamed), IsEmpty());
}

TEST(Revise, ProjectsAreToldApartByPathThenNameThenFile) {
  Document before;
  for (const char* path : {"a/one.xml", "a/two.xml", "a/three.xml"}) {
    before.projects.push_back(base().projects[0]);
    before.projects.back().path = path;
    before.projects.back().name = std::string("Design ") + path[2];
  }
  before.projects[1].name = "Second";
  Document after = before;
  std::swap(after.projects[0], after.projects[2]);
  for (ProjectPart& project : after.projects) project.path.replace(0, 1, "b");
  after.projects[1].path = "b/moved.xml";
  const Revision revision = revise(before, after, "main.json", kRegression);
  EXPECT_THAT(asked(revision), IsEmpty());
  EXPECT_THAT(became(revision), IsEmpty());
}

TEST(Revise, VerdictsTellWhatBecameOfThem) {
  const auto change = [](const calc::Estimate& was, const calc::Estimate& is) {
    Document before = base();
    set_measured(finding(before), was);
    Document after = before;
    set_measured(finding(after), is);
    const Revision revision = revise(before, after, "main.json", kRegression);
    return revision.results.empty() ? ResultChange::same : revision.results[0].change;
  };
  Document document = base();
  const double limit = finding(document).requirement.limit;
  const calc::Estimate good = estimate(1.2 * limit, 0.01 * limit),
                       bad = estimate(0.8 * limit, 0.01 * limit),
                       open = estimate(limit, 0.01 * limit);
  EXPECT_EQ(change(good, bad), ResultChange::broken);
  EXPECT_EQ(change(open, bad), ResultChange::broken);
  EXPECT_EQ(change(bad, good), ResultChange::fixed);
  EXPECT_EQ(change(good, open), ResultChange::unsure);
  EXPECT_EQ(change(good, estimate(1.1 * limit, 0.01 * limit)), ResultChange::worse);
  EXPECT_EQ(change(good, estimate(1.3 * limit, 0.01 * limit)), ResultChange::better);
  EXPECT_EQ(change(good, estimate(1.195 * limit, 0.01 * limit)), ResultChange::same);
  EXPECT_EQ(change(bad, estimate(0.7 * limit, 0.01 * limit)), ResultChange::worse);
}

// Of glare: no observer sees a luminaire, which is the same as before, or better than any rating.
TEST(Revise, NothingIsLessThanAnyRating) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  const auto change = [](const calc::Estimate& was, const calc::Estimate& is) {
    Document before = base();
    PlanePart& plane = before.projects[0].spaces[0].planes[0];
    plane.derived = calc::DerivedQuantity::ugr;
    finding(before).requirement.derived = plane.derived;
    finding(before).requirement.comparison = rules::Comparison::at_most;
    set_measured(finding(before), was);
    Document after = before;
    set_measured(finding(after), is);
    const Revision revision = revise(before, after, "main.json", kRegression);
    return revision.results.empty() ? ResultChange::same : revision.results[0].change;
  };
  const calc::Estimate nothing{-kOpen, -kOpen, -kOpen}, low = estimate(12, 0.1);
  EXPECT_EQ(change(nothing, nothing), ResultChange::same);
  EXPECT_EQ(change(nothing, low), ResultChange::worse);
  EXPECT_EQ(change(low, nothing), ResultChange::better);
  EXPECT_EQ(change(nothing, estimate(1e6, 1)), ResultChange::broken);
}

TEST(Revise, ReplicatesOfEqualSeedsShowWhatIntervalsHide) {
  Document before = base();
  const double limit = finding(before).requirement.limit;
  set_measured(finding(before), estimate(1.2 * limit, 0.05 * limit));
  for (const double noise : {-0.03, 0.02, 0.01, -0.01, 0.015, -0.005}) {
    finding(before).without_replicate.push_back((1.2 + noise) * limit);
  }
  Document after = before;
  set_measured(finding(after), estimate(1.188 * limit, 0.05 * limit));
  for (double& value : finding(after).without_replicate) value *= 0.99;
  const Revision paired = revise(before, after, "main.json", kRegression);
  ASSERT_EQ(paired.results.size(), 1u);
  EXPECT_TRUE(paired.results[0].is_paired);
  EXPECT_EQ(paired.results[0].change, ResultChange::worse);
  EXPECT_NEAR(paired.results[0].gain.value, -0.01, 1e-9);
  finding(after).without_replicate.clear();
  EXPECT_THAT(became(revise(before, after, "main.json", kRegression)), IsEmpty());
}

TEST(Revise, RoundingIsNoDifference) {
  Document before = base();
  const double limit = finding(before).requirement.limit;
  set_measured(finding(before), estimate(1.2 * limit, 0.0));
  Document after = before;
  set_measured(finding(after), estimate(1.2 * limit * (1.0 - 1e-14), 0.0));
  EXPECT_THAT(became(revise(before, after, "main.json", kRegression)), IsEmpty());
}

Document with_revision(const std::function<void(Document&)>& change_before,
                       const std::function<void(Document&)>& change_after, const Gate& gate) {
  Document before = base();
  change_before(before);
  Document after = before;
  change_after(after);
  after.revision = revise(before, after, "main.json", gate);
  return after;
}

void pass_all(Document& document) {
  for (rules::Finding& of : plane(document).findings) {
    const double limit = of.requirement.limit;
    const bool is_lower = rules::is_lower_limit(of.requirement.comparison);
    set_measured(of, estimate((is_lower ? 1.2 : 0.8) * limit, 0.001 * limit));
  }
}
TEST(Gate, KnownFailuresPassAGateForRegressionsOnly) {
  const auto known = [](Document& d) {
    pass_all(d);
    fail_first(d);
  };
  const auto nothing = [](Document&) {};
  EXPECT_EQ(gate_outcome(with_revision(known, nothing, kRegression)), rules::Outcome::pass);
  EXPECT_EQ(gate_outcome(with_revision(known, nothing, {})), rules::Outcome::fail);
  EXPECT_EQ(with_revision(known, nothing, kRegression).revision->known_failures, 1u);
}

TEST(Gate, StopsAtWhatIsBrokenAndAtWeakerQuestions) {
  EXPECT_EQ(gate_outcome(with_revision(pass_all, fail_first, kRegression)), rules::Outcome::fail);
  const auto weaker = [](Document& d) { finding(d).requirement.limit *= 0.9; };
  EXPECT_EQ(gate_outcome(with_revision(pass_all, weaker, kRegression)), rules::Outcome::fail);
  Gate accepting = kRegression;
  accepting.weaker_accepted_by = "agreed";
  EXPECT_EQ(gate_outcome(with_revision(pass_all, weaker, accepting)), rules::Outcome::pass);
}

TEST(Gate, LetsValuesFallByWhatIsAllowed) {
  const auto fall = [](Document& d) {
    rules::Finding& of = finding(d);
    set_measured(of, estimate(0.97 * of.measured.value, 0.0));
  };
  const auto exact = [](Document& d) {
    pass_all(d);
    finding(d).measured = estimate(finding(d).measured.value, 0.0);
  };
  EXPECT_EQ(gate_outcome(with_revision(exact, fall, kRegression)), rules::Outcome::fail);
  EXPECT_EQ(gate_outcome(with_revision(exact, fall, {GateMode::regression, 0.05, ""})),
            rules::Outcome::pass);
}

TEST(Gate, HeadBesideItselfIsNotJudged) {
  Document same = with_revision(
      pass_all, [](Document&) {}, kRegression);
  EXPECT_EQ(gate_outcome(same), rules::Outcome::pass);
  same.revision->is_of_itself = true;
  EXPECT_EQ(gate_outcome(same), rules::Outcome::not_judged);
  same.revision->gate.mode = GateMode::all;
  EXPECT_EQ(gate_outcome(same), rules::Outcome::pass);
}

// Who assumes less light asks more of a design: a loss of as much is let through, and no more.
TEST(Gate, ALowerMaintenanceFactorMayCostWhatItTakes) {
  const auto fall = [](double share, double dimmer, std::size_t types) {
    return [=](Document& d) {
      auto& rows = d.projects[0].luminaires;
      for (std::size_t k = 0; k < std::min(types, rows.size()); ++k) {
        rows[k].maintenance_factor *= dimmer;
      }
      set_measured(finding(d), estimate(share * finding(d).measured.value, 0.0));
    };
  };
  const auto exact = [](Document& d) {
    pass_all(d);
    auto& rows = d.projects[0].luminaires;
    if (rows.size() < 2) rows.push_back(rows[0]);
    rows[1].type_id = "another";
    auto& marks = d.projects[0].spaces[0].luminaires;
    marks.push_back(marks[0]);
    marks[1].type_id = "another";
    marks[1].position_m.x += 1;
    const double limit = finding(d).requirement.limit;
    set_measured(finding(d), estimate(2.0 * limit, 0.0));
  };
  const auto outcome = [&](double share, double dimmer, std::size_t types = 9) {
    return gate_outcome(with_revision(exact, fall(share, dimmer, types), kRegression));
  };
  EXPECT_EQ(outcome(0.875, 0.875), rules::Outcome::pass);
  EXPECT_EQ(outcome(0.85, 0.875), rules::Outcome::fail) << "something else was taken away, too";
  EXPECT_EQ(outcome(0.875, 1.0), rules::Outcome::fail);
  EXPECT_EQ(outcome(0.875, 0.875, 1), rules::Outcome::fail) << "another type is as it was";
  EXPECT_EQ(outcome(0.45, 0.45), rules::Outcome::fail) << "it does not pass any more";
  const auto failing = [&](Document& d) {
    exact(d);
    set_measured(finding(d), estimate(0.9 * finding(d).requirement.limit, 0.0));
  };
  EXPECT_EQ(gate_outcome(with_revision(failing, fall(0.875, 0.875, 9), kRegression)),
            rules::Outcome::fail)
      << "what fails and becomes worse is not excused";
  // What a maintenance factor does not scale is not excused by it.
  const auto of = [&](auto change) {
    const auto both = [&](auto first) {
      return [=](Document& d) {
        first(d);
        change(finding(d).requirement);
      };
    };
    return gate_outcome(with_revision(both(exact), both(fall(0.875, 0.875, 9)), kRegression));
  };
  EXPECT_EQ(of([](rules::Requirement&) {}), rules::Outcome::pass);
  EXPECT_EQ(of([](auto& r) { r.state = rules::LightState::initial; }), rules::Outcome::fail);
  EXPECT_EQ(of([](auto& r) { r.metric = rules::Metric::uniformity_min_avg; }),
            rules::Outcome::fail);
}

// The 2 x 1 cells become columns x rows; those that is_lost names are left out.
void regrid(Document& document, int columns, int rows,
            const std::function<bool(int column, int row)>& is_lost) {
  PlanePart& of = plane(document);
  of.grid.columns = columns;
  of.grid.rows = rows;
  of.grid.spacing_u_m = 3.0 / columns;
  of.grid.spacing_v_m = 1.5 / rows;
  of.points.clear();
  of.grid.dropped.clear();
  for (int k = 0; k < columns * rows; ++k) {
    const int column = k % columns, row = k / columns;
    const glm::dvec3 place_m{0.5 + 3.0 * (column + 0.5) / columns, 0.25 + 1.5 * (row + 0.5) / rows,
                             0.8};
    if (is_lost(column, row)) {
      of.grid.dropped.push_back({place_m, column, row, calc::DropReason::inside_solid, "desk"});
    } else {
      of.points.push_back(sample_point(column, row, place_m, estimate(600, 6), 500));
    }
  }
}

TEST(Gate, AFinerGridMayLeaveMoreOutOfTheSameRoom) {
  const auto left = [](int columns) {  // as the point that is lost before
    return [columns](int column, int) { return 2 * column < columns; };
  };
  const auto with_desk = [](Document& d) {
    pass_all(d);
    lose(d, 0);
  };
  const auto asked_by = [&](int columns, int rows, const auto& is_lost, const auto& change) {
    const auto both = [&](Document& d) {
      regrid(d, columns, rows, is_lost);
      change(d.projects[0].spaces[0]);
    };
    return asked(*with_revision(with_desk, both, kRegression).revision);
  };
  const auto nothing = [](SpacePart&) {};
  EXPECT_THAT(asked_by(4, 2, left(4), nothing), ElementsAre("stricter grid"));
  EXPECT_THAT(asked_by(4, 2, left(4), [](SpacePart& r) { r.scene_sha256 = "other light"; }),
              ElementsAre("weaker lost-points", "stricter grid"));
  EXPECT_THAT(asked_by(4, 2, left(4), [](SpacePart& r) { r.triangles = 12; }),
              ElementsAre("weaker lost-points", "stricter grid"));
  // Where there was a point there must be one of the finer grid.
  EXPECT_THAT(asked_by(
                  4, 2, [](int column, int) { return column > 1; }, nothing),
              ElementsAre("weaker lost-points", "stricter grid"));
  EXPECT_THAT(asked_by(
                  4, 2, [](int column, int) { return column != 2; }, nothing),
              ElementsAre("stricter grid"));
  // More cells, but in fewer columns: a row of points says nothing about what lies beside it.
  const auto first = [](int column, int row) { return column + row == 0; };
  EXPECT_THAT(asked_by(1, 9, first, nothing), ElementsAre("exchanged grid"));
  EXPECT_THAT(asked_by(
                  1, 1, [](int, int) { return false; }, nothing),
              ElementsAre("weaker grid", "stricter lost-points"));
  // The same cells along swapped axes are not finer.
  const auto turned = [&](int columns, int rows) {
    return asked_by(columns, rows, first, [](SpacePart& r) {
      calc::SensorGrid& grid = r.planes[0].grid;
      std::swap(grid.u, grid.v);
      for (glm::dvec2& corner : r.planes[0].outline_m) std::swap(corner.x, corner.y);
    });
  };
  EXPECT_THAT(turned(2, 3), ElementsAre("stricter grid"));
  EXPECT_THAT(turned(3, 1), ElementsAre("exchanged grid"));
  // Whichever points there are, they face as they did.
  const auto faces_down = [](SpacePart& r) {
    for (PointRow& point : r.planes[0].points) point.normal.z = -1;
  };
  EXPECT_THAT(asked_by(4, 2, left(4), faces_down),
              ElementsAre("weaker lost-points", "exchanged area", "stricter grid"));
}

TEST(Gate, AFinerGridMayBeWorseWhereNothingElseHasChanged) {
  const auto exact = [](Document& d) {
    pass_all(d);
    set_measured(finding(d), estimate(2.0 * finding(d).requirement.limit, 0.0));
    finding(d).requirement.scene = "night";
    d.projects[0].scenes = {{"night", {{"g", 0.5}}}};
  };
  const auto result = [&](double share, int columns, const std::function<void(Document&)>& change) {
    return with_revision(
        exact,
        [&](Document& d) {
          regrid(d, columns, 1, [](int, int) { return false; });
          set_measured(finding(d), estimate(share * finding(d).measured.value, 0.0));
          change(d);
        },
        kRegression);
  };
  const auto nothing = [](Document&) {};
  const Document excused = result(0.9, 4, nothing);
  EXPECT_EQ(gate_outcome(excused), rules::Outcome::pass);
  EXPECT_EQ(excused.revision->results.at(0).excused_by, QuestionPart::grid);
  EXPECT_THAT(revision_remarks(excused, Texts()), ::testing::Contains(HasSubstr("finer grid")));
  EXPECT_EQ(gate_outcome(result(0.9, 2, nothing)), rules::Outcome::fail);
  EXPECT_EQ(gate_outcome(result(0.4, 4, nothing)), rules::Outcome::fail) << "it fails now";
  const std::pair<const char*, std::function<void(Document&)>> changes[] = {
      {"luminaires", [](Document& d) { d.projects[0].spaces[0].luminaires.clear(); }},
      {"light", [](Document& d) { d.projects[0].spaces[0].scene_sha256 = "other light"; }},
      {"dimming", [](Document& d) { d.projects[0].scenes[0].level_of_group[0].second = 0.4; }},
      {"margin", [](Document& d) { plane(d).grid.margin_m = 0.1; }},
      {"facing",
       [](Document& d) {
         plane(d).points[1].normal = {0, 0, -1};
       }},
      {"a result of before", [](Document& d) { d.projects[0].spaces[0].scene_sha256.clear(); }}};
  for (const auto& [words, change] : changes) {
    EXPECT_EQ(gate_outcome(result(0.9, 4, change)), rules::Outcome::fail) << words;
  }
  // Two that ask more at once.
  const Document dimmer =
      result(0.9, 4, [](Document& d) { d.projects[0].luminaires[0].maintenance_factor *= 0.98; });
  EXPECT_EQ(gate_outcome(dimmer), rules::Outcome::pass);
  // No grid makes power more.
  const auto of_power = [](Document& d) {
    pass_all(d);
    finding(d).requirement.metric = rules::Metric::power_density;
    finding(d).requirement.comparison = rules::Comparison::at_most;
    set_measured(finding(d), estimate(0.5 * finding(d).requirement.limit, 0.0));
  };
  const auto more_power = [](Document& d) {
    regrid(d, 4, 1, [](int, int) { return false; });
    set_measured(finding(d), estimate(0.6 * finding(d).requirement.limit, 0.0));
  };
  EXPECT_EQ(gate_outcome(with_revision(of_power, more_power, kRegression)), rules::Outcome::fail);
}

// Of n rooms, each of its own id and place; all ask the same.
Document with_rooms(std::size_t count) {
  Document document = base();
  pass_all(document);
  const SpacePart first = document.projects[0].spaces[0];
  document.projects[0].spaces.clear();
  for (std::size_t k = 0; k < count; ++k) {
    SpacePart room = first;
    room.id = "r" + std::to_string(k + 1);
    for (glm::dvec2& corner : room.footprint_m) corner.x += 10.0 * static_cast<double>(k);
    document.projects[0].spaces.push_back(room);
  }
  return document;
}

// Room k of the first project becomes one of another project, which is made if it is none.
void move_room(Document& document, std::size_t k, const std::string& path) {
  ProjectPart& from = document.projects[0];
  const SpacePart room = from.spaces.at(k);
  from.spaces.erase(from.spaces.begin() + static_cast<std::ptrdiff_t>(k));
  auto& projects = document.projects;
  auto to = std::find_if(projects.begin(), projects.end(),
                         [&](const ProjectPart& one) { return one.path == path; });
  if (to == projects.end()) {
    ProjectPart added = from;
    added.path = added.name = path;
    added.spaces.clear();
    projects.push_back(added);
    to = projects.end() - 1;
  }
  to->spaces.push_back(room);
}

TEST(Revise, ADesignThatIsSplitOrMergedAsksForNothingLess) {
  const Document whole = with_rooms(3);
  Document split = whole;
  move_room(split, 2, "second.xml");
  Document renamed = split;
  renamed.projects[0].path = renamed.projects[0].name = "first.xml";
  for (const auto& [before, after] : {std::pair(whole, split), std::pair(split, whole),
                                      std::pair(whole, renamed), std::pair(renamed, whole)}) {
    const Revision revision = revise(before, after, "main.json", kRegression);
    EXPECT_THAT(asked(revision), IsEmpty());
    EXPECT_THAT(became(revision), IsEmpty());
    EXPECT_EQ(revision.same, 6u);
    EXPECT_THAT(revision.inputs, IsEmpty());
    EXPECT_THAT(calc::texts(revision.notes), ::testing::Contains(HasSubstr("r3")));
  }
}

TEST(Revise, WarningsOfBeforeAreKnownOneByOne) {
  const calc::DiagnosticId id = calc::DiagnosticId::mesh_bent_faces;
  Document before = base(), after = base();
  before.projects[0].diagnostics = {{id, {"office.xml", 3, 1}, "a"}};
  after.projects[0].diagnostics = {{id, {"office.xml", 4, 1}, "b"},
                                   {id, {"a.obj", 3, 1}, "a"},
                                   {id, {"office.xml", 5, 1}, "a"},
                                   {id, {"office.xml", 6, 1}, "a"}};
  const auto known = revise(before, after, "main.json", kRegression).known_warnings;
  ASSERT_EQ(known.size(), 1u);
  EXPECT_EQ(known[0].project, "office.xml");
  EXPECT_THAT(known[0].diagnostics, ElementsAre(2u));
  after.projects[0].strict_warnings = {id};
  EXPECT_THAT(revise(before, after, "main.json", kRegression).known_warnings, IsEmpty());
}

TEST(Revise, WhatIsLessInAMovedRoomIsSeen) {
  const Document whole = with_rooms(2);
  const auto after_split = [&](const std::function<void(ProjectPart&)>& change) {
    Document split = whole;
    move_room(split, 1, "second.xml");
    change(split.projects[1]);
    return asked(revise(whole, split, "main.json", kRegression));
  };
  const auto findings = [](ProjectPart& p) -> std::vector<rules::Finding>& {
    return p.spaces[0].planes[0].findings;
  };
  EXPECT_THAT(after_split([&](auto& p) { findings(p)[0].requirement.limit *= 0.5; }),
              ElementsAre("weaker limit"));
  EXPECT_THAT(after_split([&](auto& p) { findings(p).pop_back(); }),
              ElementsAre("weaker requirement"));
  EXPECT_THAT(after_split([](auto& p) { p.luminaires[0].maintenance_factor = 1.0; }),
              ElementsAre("weaker maintenance-factor"));
  EXPECT_THAT(after_split([](auto& p) { p.luminaires[0].flux_lm *= 1.1; }),
              ElementsAre("weaker flux"));
  // Another room in another project is no moved one.
  EXPECT_THAT(after_split([](auto& p) { p.spaces[0].footprint_m[0].x += 1; }),
              ElementsAre("weaker room", "stricter project"));
  EXPECT_THAT(after_split([](auto& p) { p.spaces[0].name = "Store"; }),
              ElementsAre("weaker room", "stricter project"));
  EXPECT_THAT(after_split([](auto& p) { p.is_judged = false; }),
              ElementsAre("weaker room", "stricter project"));
  // Two of one id and shape may be either.
  Document twice = whole;
  move_room(twice, 1, "second.xml");
  twice.projects.push_back(twice.projects[1]);
  twice.projects.back().path = twice.projects.back().name = "third.xml";
  EXPECT_THAT(asked(revise(whole, twice, "main.json", kRegression)),
              ElementsAre("weaker room", "stricter project", "stricter project"));
}

// What a project says by hand is held against what was said where the room was.
TEST(Revise, WhatIsSaidByHandIsKnownWhereARoomHasMoved) {
  Document before = with_rooms(2);
  before.projects[0].spaces[1].luminaires.clear();
  const auto after_move = [&](std::size_t moved, std::size_t changed, bool is_lit) {
    Document after = before;
    move_room(after, moved, "second.xml");
    LuminaireRow& row = after.projects[changed].luminaires[0];
    row.flux_lm *= 10;
    row.maintenance_factor = 1.0;
    if (is_lit) {
      after.projects[changed].spaces[0].luminaires = before.projects[0].spaces[0].luminaires;
    }
    return asked(revise(before, after, "main.json", kRegression));
  };
  EXPECT_THAT(after_move(0, 0, true), ElementsAre("weaker maintenance-factor", "weaker flux"))
      << "the lit room leaves, the dark one gets other light";
  EXPECT_THAT(after_move(1, 1, true), ElementsAre("weaker maintenance-factor", "weaker flux"))
      << "the dark room leaves, and gets other light";
}

TEST(Revise, ASceneThatMeansSomethingElseWhereARoomHasMovedIsExchanged) {
  Document before = with_rooms(2);
  before.projects[0].scenes = {{"night", {{"g", 1.0}}}};
  finding(before).requirement.scene = "night";
  Document after = before;
  move_room(after, 0, "second.xml");
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)), IsEmpty());
  Document other = before;
  other.projects.push_back(before.projects[0]);
  other.projects[1].path = other.projects[1].name = "second.xml";
  other.projects[1].spaces.clear();
  other.projects[1].scenes[0].level_of_group[0].second = 0.5;
  Document merged = other;
  move_room(merged, 0, "second.xml");
  EXPECT_THAT(asked(revise(other, merged, "main.json", kRegression)),
              ElementsAre("exchanged light"));
}

TEST(Revise, LuminairesOfOneNameStayApartWhereDesignsAreMerged) {
  Document before = with_rooms(2);
  move_room(before, 1, "second.xml");
  before.projects[1].luminaires[0].sha256 = "of the second";
  before.projects[1].luminaires[0].maintenance_factor = 0.7;
  Document after = with_rooms(2);
  LuminaireRow second = before.projects[1].luminaires[0];
  second.type_id = "panel-2";
  after.projects[0].luminaires.push_back(second);
  after.projects[0].spaces[1].luminaires[0].type_id = "panel-2";
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)), IsEmpty());
  after.projects[0].luminaires[1].maintenance_factor = 0.75;
  EXPECT_THAT(asked(revise(before, after, "main.json", kRegression)),
              ElementsAre("weaker maintenance-factor"));
}

TEST(Gate, WhatWaitsForAJudgementIsNoPass) {
  const auto open = [](Document& d) {
    rules::Finding& of = finding(d);
    set_measured(of, estimate(of.requirement.limit, 0.01 * of.requirement.limit));
  };
  EXPECT_EQ(gate_outcome(with_revision(pass_all, open, kRegression)), rules::Outcome::undecided);
  const auto failing_and_open = [&](Document& d) {
    pass_all(d);
    open(d);
    rules::Finding& other = finding(d, 1);
    const bool is_lower = rules::is_lower_limit(other.requirement.comparison);
    set_measured(other, estimate((is_lower ? 0.5 : 2.0) * other.requirement.limit, 0.0));
  };
  EXPECT_EQ(gate_outcome(with_revision(
                failing_and_open, [](Document&) {}, kRegression)),
            rules::Outcome::undecided);
}

TEST(Gate, FailuresOfAProjectThatCouldNotBeJudgedBeforeAreNotKnown) {
  Document before = base();
  ProjectPart unread;
  unread.path = before.projects[0].path;
  before.projects[0] = unread;
  Document after = base();
  pass_all(after);
  fail_first(after);
  after.revision = revise(before, after, "main.json", kRegression);
  EXPECT_EQ(after.revision->known_failures, 0u);
  EXPECT_EQ(gate_outcome(after), rules::Outcome::fail);
}

TEST(Revise, InputsAreNamed) {
  const Revision revision = revised([](Document& d) {
    d.projects[0].luminaires.at(0).sha256 = "other";
    d.projects[0].spaces[0].luminaires.at(0).position_m.x += 0.25;
  });
  std::vector<std::string> what;
  for (const ChangedInput& input : revision.inputs) what.push_back(input.what);
  EXPECT_THAT(what, ElementsAre("photometry", "luminaires"));
  EXPECT_THAT(revision.inputs[1].after, HasSubstr("1 moved, up to 0.25 m"));
}

TEST(Revise, AHousingThatGoesIsNamed) {
  Document before = base();
  before.projects[0].luminaires.at(0).housing_material = "grey";
  before.projects[0].luminaires.at(0).housing_depth_m = 0.08;
  const Document after = base();
  const Revision revision = revise(before, after, "main.json", kRegression);
  ASSERT_EQ(revision.inputs.size(), 1u);
  EXPECT_THAT(revision.inputs[0].before, HasSubstr("housing of grey 0.08 m deep"));
  EXPECT_THAT(revision.inputs[0].after, Not(HasSubstr("housing")));
}

TEST(Revise, WhatSaysWhatItWasIsTheSame) {
  const Revision renamed = revised([](Document& d) {
    SpacePart& room = d.projects[0].spaces[0];
    room.was = room.id;
    room.id = "hall";
    plane(d).was = plane(d).id;
    plane(d).id = "table";
    plane(d).space_id = "hall";
    finding(d).requirement.was = finding(d).requirement.id;
    finding(d).requirement.id = "mean";
  });
  EXPECT_THAT(asked(renamed), IsEmpty());
  EXPECT_THAT(became(renamed), IsEmpty());
  ASSERT_EQ(renamed.inputs.size(), 3u);
  EXPECT_EQ(renamed.inputs[1].what, "id of the plane");
  EXPECT_EQ(renamed.inputs[1].after, "table");

  const Revision easier = revised([](Document& d) {
    plane(d).was = plane(d).id;
    plane(d).id = "table";
    finding(d).requirement.limit *= 0.5;
  });
  EXPECT_THAT(asked(easier), ElementsAre("weaker limit"));
}

TEST(Revise, WasCountsOnlyForWhatIsGoneAndNewOtherwise) {
  // Left in a project after the renaming is in the baseline, too.
  const Revision stale = revised([](Document& d) { plane(d).was = "an old name"; });
  EXPECT_THAT(asked(stale), IsEmpty());
  EXPECT_THAT(stale.inputs, IsEmpty());
  // A plane that is still there is not taken from itself.
  const Revision taken = revised([](Document& d) {
    PlanePart copy = plane(d);
    copy.was = copy.id;
    copy.id = "copy";
    d.projects[0].spaces[0].planes.push_back(copy);
  });
  EXPECT_THAT(asked(taken), ElementsAre("stricter plane"));
}

TEST(Revise, ARenamedPlaneThatDoesNotSaySoIsPointedAt) {
  const Revision revision = revised([](Document& d) { plane(d).id = "table"; });
  EXPECT_THAT(asked(revision), ElementsAre("weaker plane", "stricter plane"));
  ASSERT_EQ(revision.notes.size(), 1u);
  EXPECT_THAT(revision.notes[0].english(), HasSubstr("was=\""));
}

TEST(Revise, DimmingLevelsAreInputs) {
  Document before = base();
  before.projects[0].scenes = {{"night", {{"window", 0.3}}}};
  Document after = before;
  after.projects[0].scenes[0].level_of_group[0].second = 0.2;
  const Revision revision = revise(before, after, "main.json", kRegression);
  ASSERT_EQ(revision.inputs.size(), 1u);
  EXPECT_EQ(revision.inputs[0].what, "scene");
  EXPECT_EQ(revision.inputs[0].before, "window 0.3");
  EXPECT_EQ(revision.inputs[0].after, "window 0.2");
}

TEST(Revise, ValuesOfChangedPlanesAreKeptPointByPoint) {
  const Document before = base();
  Document after = before;
  plane(after).points.back().measured.value += 1.0;
  const Revision revision = revise(before, after, "main.json", kRegression);
  ASSERT_EQ(revision.planes.size(), 1u);
  ASSERT_EQ(revision.planes[0].before_lx.size(), plane(after).points.size());
  EXPECT_EQ(revision.planes[0].before_lx.back(), plane(after).points.back().measured.value - 1.0);
  EXPECT_THAT(revise(before, before, "main.json", kRegression).planes, IsEmpty());
  plane(after).points.back().position_m.x += 0.01;
  EXPECT_THAT(revise(before, after, "main.json", kRegression).planes, IsEmpty());
}

TEST(RevisionTables, SayAgainstWhat) {
  Revision revision;
  revision.baseline = "main.json";
  EXPECT_EQ(baseline_words(revision), "main.json");
  revision.baseline = "main";
  revision.commits = {std::string(40, 'a'), std::string(40, 'b')};
  EXPECT_EQ(baseline_words(revision), "main (aaaaaaaaaa, bbbbbbbbbb)");
  revision.baseline = std::string(12, 'a');
  EXPECT_EQ(baseline_words(revision), std::string(12, 'a'));

  // Also where no table of results has it as its title.
  Document after = base();
  finding(after).requirement.limit = 250;
  revision = revise(base(), after, "main", kRegression);
  ASSERT_THAT(revision.results, IsEmpty());
  ASSERT_FALSE(revision.questions.empty());
  revision.commits = {std::string(40, 'a')};
  after.revision = revision;
  EXPECT_THAT(revision_remarks(after, {}).front(), HasSubstr("Compared with main (aaaaaaaaaa): "));
}

TEST(Revise, CommitsAreReadBackFromTheResultFile) {
  Document document = base();
  document.revision = revise(base(), document, "main", kRegression);
  document.revision->commits = {std::string(40, 'a')};
  const std::string bytes = rendered("json", document);
  std::string problem;
  const std::optional<Document> read = read_json(bytes, problem);
  ASSERT_TRUE(read) << problem;
  EXPECT_EQ(read->revision->commits, document.revision->commits);
  EXPECT_EQ(rendered("json", *read), bytes);
}

TEST(Revise, IsReadBackFromTheResultFile) {
  const Document document = with_revision(
      pass_all,
      [](Document& d) {
        fail_first(d);
        finding(d, 1).requirement.limit *= 0.5;
        judge_again(finding(d, 1));
        d.projects[0].luminaires.at(0).sha256 = "other";
      },
      kRegression);
  const std::string text = rendered("json", document);
  std::string problem;
  const std::optional<Document> read = read_json(text, problem);
  ASSERT_TRUE(read) << problem;
  ASSERT_TRUE(read->revision);
  EXPECT_EQ(rendered("json", *read), text);
  EXPECT_EQ(gate_outcome(*read), gate_outcome(document));
}

}  // namespace
}  // namespace report::revise_test
