// Real results in which one thing is changed: none of them may become a report.

#include "report/check/load_rules.h"
#include "report/check/run.h"
#include "report/result_file/read_json.h"
#include "rules/binding/judged_project.h"
#include "tests/support/rendered.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace report::contradiction_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kRoot = LUXGATE_SOURCE_DIR;
constexpr const char* kDay = "2026-12-31";  // the last but one of the waiver in golden/waived

std::vector<rules::RulePack> packs_with(const std::string& file) {
  const calc::DiskFileReader files;
  calc::Diagnostics diagnostics;
  std::vector<rules::RulePack> packs = check::load_rule_packs({file}, files, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  return packs;
}

// Waivers, aggregates, classes, rows, sampled planes with looks, a plane that was not computed.
Document real_document() {
  check::Settings settings;
  settings.today = kDay;
  settings.radiosity.max_paths = 4096;
  const check::Run run =
      check::Run(settings).with_packs(packs_with(kRoot + "/tests/golden/aggregates/own.xml"));
  Document document;
  document.provenance.program_version = "0.1.0";
  document.provenance.numbers_version = 1;
  document.provenance.judged_on = kDay;
  for (const char* path :
       {"tests/golden/aggregates/project.xml", "tests/golden/waived/project.xml",
        "tests/golden/plane-without-points/project.xml", "examples/09-office-by-row/project.xml",
        "examples/06-on-the-edge/project.xml", "tests/golden/building-sums/project.xml"}) {
    document.projects.push_back(run.check(kRoot + "/" + path));
  }
  return document;
}

const json& real_result() {
  static const json result = json::parse(rendered("json", real_document()));
  return result;
}

const json& flat_result() {
  static const json flat = real_result().flatten();
  return flat;
}

// "" if it is read.
std::string refusal(const json& result) {
  std::string problem;
  return read_json(result.dump(), problem) ? "" : problem;
}

std::string refusal_with(const std::string& pointer, const json& value) {
  json changed = real_result();
  changed[json::json_pointer(pointer)] = value;
  return refusal(changed);
}

// Pointers to every object that has the key `mark`, in a list with the name `list`.
std::vector<std::string> every(const char* list, const char* mark) {
  std::set<std::string> found;
  for (const auto& item : flat_result().items()) {
    const std::string end = std::string("/") + mark;
    const std::string& path = item.key();
    // Values are at the mark itself or below it; lists hold objects.
    for (std::size_t at = path.find(end); at != std::string::npos; at = path.find(end, at + 1)) {
      const json::json_pointer parent = json::json_pointer(path.substr(0, at)).parent_pointer();
      const std::size_t behind = at + end.size();
      const bool is_key = behind == path.size() || path[behind] == '/';
      if (is_key && !parent.empty() && parent.back() == list) found.insert(path.substr(0, at));
    }
  }
  return {found.begin(), found.end()};
}

const json& at(const std::string& pointer) { return real_result()[json::json_pointer(pointer)]; }

const std::vector<std::string> kVerdicts{"pass", "fail", "undecided", "not-judged"};

TEST(Contradiction, ARealResultIsRead) {
  EXPECT_EQ(refusal(real_result()), "");
  std::set<std::string> verdicts;
  for (const std::string& finding : every("findings", "requirement")) {
    verdicts.insert(at(finding + "/verdict"));
  }
  EXPECT_EQ(verdicts, std::set<std::string>(kVerdicts.begin(), kVerdicts.end()))
      << "the tests below need one of each";
}

TEST(Contradiction, NoFindingMayHaveAnotherVerdict) {
  for (const std::string& finding : every("findings", "requirement")) {
    for (const std::string& verdict : kVerdicts) {
      if (at(finding + "/verdict") == verdict) continue;
      EXPECT_NE(refusal_with(finding + "/verdict", verdict), "") << finding << " " << verdict;
    }
  }
}

TEST(Contradiction, NoLimitMayBeMovedOverTheInterval) {
  for (const std::string& finding : every("findings", "requirement")) {
    if (at(finding + "/verdict") == "not-judged") continue;
    const json measured = at(finding + "/measured");
    const double low = measured["low"], high = measured["high"];
    for (const double limit : {low - 1.0 - std::abs(low), high + 1.0 + std::abs(high)}) {
      // What was on this side of it stays so, but the margin tells.
      EXPECT_NE(refusal_with(finding + "/limit", limit), "") << finding << " " << limit;
    }
  }
}

TEST(Contradiction, MarksOfAFindingFollowToo) {
  for (const std::string& finding : every("findings", "requirement")) {
    for (const char* mark : {"/is_close", "/by_tolerance"}) {
      EXPECT_NE(refusal_with(finding + mark, !at(finding + mark).get<bool>()), "") << finding;
    }
    const bool is_judged = at(finding + "/verdict") != "not-judged";
    EXPECT_NE(refusal_with(finding + "/margin", 0.123), "") << finding;
    EXPECT_NE(refusal_with(finding + "/doubtful", true).empty(),
              at(finding + "/verdict") != "undecided" || at(finding + "/is_close") == true)
        << finding;
    if (is_judged) continue;
    EXPECT_THAT(refusal_with(finding + "/measured", {{"value", 1}, {"low", 1}, {"high", 1}}),
                HasSubstr("null is needed"));
  }
}

TEST(Contradiction, SaysWhereWhatAndWhatFollows) {
  std::string failing;
  for (const std::string& finding : every("findings", "requirement")) {
    const bool has_waiver = at(finding).contains("waiver");  // which a pass contradicts, too
    if (at(finding + "/verdict") == "fail" && !has_waiver) failing = finding;
  }
  const std::string words = refusal_with(failing + "/verdict", "pass");
  EXPECT_THAT(
      words,
      testing::StartsWith(
          failing + "/verdict: the file says 'pass', but its other values give 'fail' (project '"));
  EXPECT_THAT(words, HasSubstr(", plane '"));
  EXPECT_THAT(words,
              HasSubstr(", requirement '" + at(failing + "/requirement").get<std::string>()));
  EXPECT_THAT(words, HasSubstr(", required "));
}

TEST(Contradiction, WaiversLastUpToTheResultsOwnDay) {
  const std::vector<std::string> findings = every("findings", "requirement");
  int waivers = 0;
  for (const std::string& finding : findings) {
    if (!at(finding).contains("waiver")) continue;
    ++waivers;
    const std::string until = finding + "/waiver/until";
    const bool applies = at(finding + "/waiver/applies");
    EXPECT_NE(refusal_with(finding + "/waiver/applies", !applies), "");
    EXPECT_THAT(refusal_with(until, ""), HasSubstr("a day, YYYY-MM-DD, is needed"));
    EXPECT_THAT(refusal_with(until, "2026-13-01"), HasSubstr("a day, YYYY-MM-DD, is needed"));
    EXPECT_EQ(refusal_with(until, kDay), "") << "its last day";
    EXPECT_THAT(refusal_with(until, "2026-12-30"),
                HasSubstr("/waiver/applies: the file says true, but its other values give false"));
  }
  EXPECT_GE(waivers, 1);
  EXPECT_NE(refusal_with("/provenance/judged_on", "2027-01-02"), "");
  EXPECT_NE(refusal_with("/provenance/timestamp", "2026-12-30T00:00:00Z"), "");
  json without = real_result();
  without["provenance"].erase("judged_on");
  EXPECT_THAT(refusal(without), HasSubstr("/provenance/judged_on"));
}

TEST(Contradiction, NoNumberThatIsCountedMayBeAnother) {
  int changed = 0;
  for (const auto& item : flat_result().items()) {
    const std::string& path = item.key();
    const std::string parent = json::json_pointer(path).parent_pointer().to_string();
    const bool is_count = parent.ends_with("/counts") || parent.ends_with("/warnings");
    if (!is_count) continue;
    ++changed;
    EXPECT_THAT(refusal_with(path, item.value().get<int>() + 1),
                HasSubstr(path + ": the file says "))
        << path;
  }
  EXPECT_GE(changed, 6 * 8);
}

TEST(Contradiction, LooksSayWhatTheirIntervalsSay) {
  int judged = 0;
  for (const std::string& finding : every("findings", "measured")) {
    if (finding.find("/look_results/") == std::string::npos) continue;
    const std::string verdict = at(finding + "/verdict");
    for (const char* better : {"pass", "fail"}) {
      if (verdict == better || verdict == "not-judged") continue;
      ++judged;
      EXPECT_NE(refusal_with(finding + "/verdict", better), "") << finding;
    }
  }
  EXPECT_GT(judged, 3);
}

// Another number in the finding, with all that follows from it, is not the last look's.
TEST(Contradiction, TheLastLookIsTheResult) {
  int judged = 0;
  for (const std::string& plane : every("planes", "look_results")) {
    const json looks = at(plane + "/look_results");
    if (looks.empty()) continue;
    const std::size_t last = looks.size() - 1;
    for (std::size_t i = 0; i < looks[last]["findings"].size(); ++i) {
      if (looks[last]["findings"][i]["verdict"] == "not-judged") continue;
      const std::string own = plane + "/look_results/" + std::to_string(last) + "/findings/" +
                              std::to_string(i) + "/measured/value";
      const double value = at(own);
      EXPECT_THAT(refusal_with(own, value * (1.0 + 1e-12)),
                  HasSubstr("the last sampling round is the result"))
          << own;
      ++judged;
    }
  }
  EXPECT_GT(judged, 10);
}

TEST(Contradiction, AggregatesAndTheirMembersFollow) {
  int aggregates = 0, members = 0;
  for (const std::string& aggregate : every("aggregates", "kind")) {
    ++aggregates;
    for (const std::string& verdict : kVerdicts) {
      if (at(aggregate + "/verdict") == verdict) continue;
      EXPECT_NE(refusal_with(aggregate + "/verdict", verdict), "") << aggregate;
    }
    EXPECT_NE(refusal_with(aggregate + "/is_waived", !at(aggregate + "/is_waived").get<bool>()),
              "");
    EXPECT_NE(refusal_with(aggregate + "/members", json::array()), "");
  }
  for (const std::string& member : every("members", "area_m2")) {
    ++members;
    for (const std::string& verdict : kVerdicts) {
      if (at(member + "/verdict") == verdict) continue;
      EXPECT_NE(refusal_with(member + "/verdict", verdict), "") << member;
    }
    EXPECT_NE(refusal_with(member + "/is_waived", !at(member + "/is_waived").get<bool>()), "");
    EXPECT_NE(refusal_with(member + "/name", "another"), "") << member;
    const json nobody = json::array({{{"plane", "none"}, {"requirement", "none"}}});
    EXPECT_THAT(refusal_with(member + "/of", nobody), HasSubstr("has no requirement"));
    const bool is_room = at(member).contains("value");  // of a building: made of no requirement
    if (at(member + "/verdict") != "not-judged" && !is_room) {
      EXPECT_NE(refusal_with(member + "/of", json::array()), "") << member;
    }
  }
  EXPECT_GE(aggregates, 2);
  EXPECT_GE(members, 4);
}

TEST(Contradiction, SumsAreThoseOfTheRooms) {
  int sums = 0, rooms = 0;
  for (const std::string& building : every("aggregates", "sum")) {
    const std::string sum = building + "/sum";
    if (at(sum + "/measured").is_null()) continue;
    ++sums;
    for (const char* end : {"/measured/value", "/measured/low", "/measured/high"}) {
      const double value = at(sum + end);
      EXPECT_NE(refusal_with(sum + end, value * 1.001), "") << sum;
    }
  }
  for (const std::string& room : every("members", "value")) {
    ++rooms;
    for (const char* number : {"/value", "/area_m2"}) {
      const double value = at(room + number);
      EXPECT_THAT(refusal_with(room + number, value * 1.001), HasSubstr("from the room itself"));
    }
  }
  EXPECT_GE(sums, 3);
  EXPECT_GE(rooms, 6);
}

TEST(Contradiction, RolesOfARowFollow) {
  int roles = 0, rows = 0;
  for (const std::string& role : every("roles", "state")) {
    ++roles;
    for (const char* state : {"met", "failed", "undecided", "not-judged", "waived"}) {
      if (at(role + "/state") == state) continue;
      EXPECT_NE(refusal_with(role + "/state", state), "") << role << " " << state;
    }
  }
  for (const std::string& row : every("coverage", "is_met")) {
    ++rows;
    for (const char* mark : {"/is_met", "/is_whole"}) {
      EXPECT_THAT(refusal_with(row + mark, !at(row + mark).get<bool>()),
                  HasSubstr(row + mark + ": the file says"));
    }
  }
  EXPECT_GE(roles, 5);
  EXPECT_GE(rows, 1);
}

TEST(Contradiction, WhatWasNotComputedHasNoVerdict) {
  int planes = 0;
  for (const std::string& plane : every("planes", "is_computed")) {
    if (at(plane + "/is_computed") == true || at(plane + "/findings").empty()) continue;
    ++planes;
    json changed = real_result();
    json& finding = changed[json::json_pointer(plane + "/findings/0")];
    finding["verdict"] = "pass";
    finding["measured"] = {{"value", 1e9}, {"low", 1e9}, {"high", 1e9}};
    EXPECT_THAT(refusal(changed), HasSubstr("the plane was not computed"));
  }
  EXPECT_GE(planes, 1);
}

// A project with an error cannot be whole.
TEST(Contradiction, AnErrorCostsAVerdict) {
  json changed = real_result();
  json& project = changed["projects"][1];
  json error = changed["projects"][2]["diagnostics"][0];
  ASSERT_EQ(error["severity"], "error");
  project["diagnostics"].push_back(error);
  EXPECT_THAT(refusal(changed), HasSubstr("/projects/1/is_judged: the file says true"));
}

// What nobody accepts, and light that nobody says how it is maintained, is not judged.
TEST(Contradiction, APassNeedsAPlaneThatFits) {
  std::string standard;
  for (const std::string& finding : every("findings", "requirement")) {
    if (at(finding).contains("rule") && at(finding + "/verdict") == "pass") standard = finding;
  }
  ASSERT_NE(standard, "");
  const auto with = [&](json deviation) {
    return refusal_with(standard + "/deviations", json::array({std::move(deviation)}));
  };
  EXPECT_THAT(with({{"in", "height"}, {"words", "1 m"}, {"accepted", false}}),
              HasSubstr("the plane has a deviation that nobody accepts"));
  EXPECT_THAT(
      with({{"in", "height"}, {"words", "1 m"}, {"accepted", true}}),
      HasSubstr("/deviations/0/accepted: the file says true, but its other values give false"));
  const json stated = {{"reason", "r"}, {"owner", "o"}, {"until", "2026-12-30"}};
  EXPECT_THAT(
      with({{"in", "height"}, {"words", "1 m"}, {"accepted", true}, {"stated", stated}}),
      HasSubstr("/deviations/0/accepted: the file says true, but its other values give false"));
  json changed = real_result();
  const std::string project = standard.substr(0, standard.find("/spaces"));
  for (json& row : changed[json::json_pointer(project + "/luminaires")]) {
    row["maintenance_parts"]["stated"] = false;
  }
  EXPECT_THAT(refusal(changed), HasSubstr("a luminaire states no maintenance factor"));
}

}  // namespace
}  // namespace report::contradiction_test
