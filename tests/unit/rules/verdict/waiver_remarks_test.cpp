// What is told of waivers in time.

#include "rules/verdict/waiver_remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules::waiver_remarks_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Finding finding_of(Verdict verdict, const std::string& until = "2027-06-30", int line = 7) {
  Finding finding;
  finding.verdict = verdict;
  finding.requirement.plane_id = "p";
  finding.requirement.origin.check = "wall.Em";
  finding.requirement.waiver = Waiver{"spring", "J. Doe", until, {"p.xml", line, 3}};
  finding.is_waived = verdict == Verdict::fail || verdict == Verdict::undecided;
  return finding;
}

std::vector<std::string> told(const std::vector<std::vector<Finding>>& planes,
                              const std::string& today, const calc::Space& space = {}) {
  const calc::CalcPlane plane;
  std::vector<JudgedPlane> judged;
  for (const std::vector<Finding>& findings : planes) judged.push_back({&space, &plane, &findings});
  calc::Diagnostics diagnostics;
  warn_about_waivers(space, judged, today, diagnostics);
  std::vector<std::string> messages;
  for (const calc::Diagnostic& d : diagnostics.all()) messages.push_back(format_diagnostic(d));
  return messages;
}

TEST(WaiverRemarks, OfBuildingsAreTold) {
  AggregateFinding building;
  building.building_id = "tower";
  const auto said = [&](Verdict verdict) {
    building.sum = finding_of(verdict);
    building.sum->requirement.origin.check.clear();
    building.sum->requirement.id = "LENI";
    building.verdict = verdict;
    building.is_waived = building.sum->is_waived;
    calc::Diagnostics diagnostics;
    warn_about_waivers({building}, "2027-06-29", diagnostics);
    std::vector<std::string> messages;
    for (const calc::Diagnostic& d : diagnostics.all()) messages.push_back(format_diagnostic(d));
    return messages;
  };
  EXPECT_THAT(said(Verdict::pass),
              ElementsAre(HasSubstr("the waiver of 'LENI' by J. Doe, until 2027-06-30, is not "
                                    "needed: it passes for building 'tower'")));
  EXPECT_THAT(said(Verdict::fail), ElementsAre(HasSubstr("in 1 day")));
}

TEST(WaiverRemarks, WhatPassesNeedsNoWaiver) {
  EXPECT_THAT(told({{finding_of(Verdict::pass)}}, "2027-01-01"),
              ElementsAre("p.xml:7:3: warning[waiver-not-needed]: the waiver of 'wall.Em' by J. "
                          "Doe, until 2027-06-30, is not needed: it passes on plane 'p'"));
  // Also after its last day.
  EXPECT_THAT(told({{finding_of(Verdict::pass)}}, "2030-01-01"),
              ElementsAre(HasSubstr("not needed")));
  for (const Verdict verdict : {Verdict::fail, Verdict::undecided, Verdict::not_judged}) {
    EXPECT_THAT(told({{finding_of(verdict)}}, "2027-01-01"), IsEmpty());
  }
}

TEST(WaiverRemarks, OneOfSeveralPlanesThatDoesNotPassNeedsIt) {
  const Finding passes = finding_of(Verdict::pass);
  EXPECT_THAT(told({{passes}, {finding_of(Verdict::fail)}, {passes}}, "2027-01-01"), IsEmpty());
  EXPECT_THAT(told({{passes}, {finding_of(Verdict::not_judged)}}, "2027-01-01"), IsEmpty());
  EXPECT_THAT(told({{passes}, {passes}}, "2027-01-01"),
              ElementsAre(HasSubstr("it passes on all 2 planes")));
  // Another waiver, in another line, does not need that one.
  EXPECT_THAT(told({{passes}, {finding_of(Verdict::fail, "2027-06-30", 9)}}, "2027-01-01"),
              ElementsAre(HasSubstr("p.xml:7:3")));
}

TEST(WaiverRemarks, TheLastThirtyDaysAreToldOnce) {
  const std::vector<std::vector<Finding>> planes{{finding_of(Verdict::fail)},
                                                 {finding_of(Verdict::fail)}};
  EXPECT_THAT(told(planes, "2027-05-30"), IsEmpty());  // 31 days
  EXPECT_THAT(told(planes, "2027-05-31"),
              ElementsAre("p.xml:7:3: warning[waiver-ends-soon]: the waiver, by J. Doe, ends in 30 "
                          "days, on 2027-06-30: after that day the waived requirement counts"));
  EXPECT_THAT(told(planes, "2027-06-29"), ElementsAre(HasSubstr("ends in 1 day,")));
  EXPECT_THAT(told(planes, "2027-06-30"), ElementsAre(HasSubstr("ends today,")));
  EXPECT_THAT(told(planes, "2027-07-01"), IsEmpty());
}

TEST(WaiverRemarks, DeviationsAndZonesEndToo) {
  Finding deviating = finding_of(Verdict::pass);
  const Waiver by = *deviating.requirement.waiver;
  deviating.requirement.waiver.reset();
  deviating.requirement.deviations = {
      {FitAspect::grid, calc::Message::words("few points"), by, true}};
  EXPECT_THAT(told({{deviating}}, "2027-06-01"),
              ElementsAre(HasSubstr("the deviation, by J. Doe, ends in 29 days")));
  deviating.requirement.deviations[0].is_accepted = false;
  EXPECT_THAT(told({{deviating}}, "2027-06-01"), IsEmpty());
  calc::Space space;
  space.left_out = {{calc::CalcPlane{}, by}, {calc::CalcPlane{}, by}};
  EXPECT_THAT(told({}, "2027-06-01", space),
              ElementsAre(HasSubstr("leaving the zone out, by J. Doe, ends in 29 days, on "
                                    "2027-06-30: after that day it counts as not judged")));
}

}  // namespace
}  // namespace rules::waiver_remarks_test
