// Every aggregate and class of every shipped pack, judged from given results:
// tests/rules_corpus/<pack>/together.<id>.xml holds what was measured and, beside it, what must
// come out. Numbers are in base units.
#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "tests/support/evaluated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace rules::aggregate_corpus_test {
namespace {

std::string text_of(const calc::XmlElement& element, const char* name) {
  const calc::XmlAttribute* attribute = element.find(name);
  return attribute == nullptr ? "" : attribute->value;
}

double number_of(const calc::XmlElement& element, const char* name) {
  return calc::parse_number(text_of(element, name)).value();
}

Evidence evidence_of(const calc::XmlElement& item, const RulePack& pack) {
  Evidence evidence{pack, pack.find_row(text_of(item, "row"))};
  for (const calc::XmlElement& measured : item.children) {
    const std::string check = text_of(measured, "check");
    EXPECT_NE(pack.find_check(check), nullptr) << check;
    evidence.measured[check] = {number_of(measured, "value"), number_of(measured, "low"),
                                number_of(measured, "high")};
  }
  return evidence;
}

// What comes out: a status, or "P2 of P1" for the class reached and the one possible.
std::string outcome(const calc::XmlElement& item, const RulePack& pack, const std::string& id) {
  const Evidence evidence = evidence_of(item, pack);
  for (const RuleAggregate& aggregate : pack.aggregates) {
    if (aggregate.id == id) return name_of_status(evaluate_aggregate(aggregate, evidence));
  }
  for (const RuleClass& candidate : pack.classes) {
    if (candidate.id != id) continue;
    const ClassResult result = evaluate_class(candidate, evidence);
    const std::string reached = result.reached == nullptr ? "none" : result.reached->ref;
    const std::string possible = result.possible == nullptr ? "none" : result.possible->ref;
    return reached == possible ? reached : reached + " or " + possible;
  }
  return "no such aggregate or class";
}

// pass, fail or undecided.
std::string kind_of(const std::string& expected) {
  if (expected == "none") return "fail";
  if (expected.find(" or ") != std::string::npos) return "undecided";
  return expected == "fail" || expected == "undecided" ? expected : "pass";
}

std::set<std::string> everything_shipped(const std::vector<RulePack>& packs) {
  std::set<std::string> ids;
  for (const RulePack& pack : packs) {
    for (const RuleAggregate& aggregate : pack.aggregates) {
      ids.insert(pack.full_id() + " " + aggregate.id);
    }
    for (const RuleClass& item : pack.classes) ids.insert(pack.full_id() + " " + item.id);
  }
  return ids;
}

TEST(AggregateCorpus, EveryFileIsAsExpectedAndEveryAggregateAndClassHasOne) {
  const std::vector<RulePack> packs = builtin_rule_packs();
  std::set<std::string> missing = everything_shipped(packs);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(LUXGATE_RULES_CORPUS)) {
    if (!entry.path().filename().string().starts_with("together.")) continue;
    SCOPED_TRACE(entry.path().string());
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    calc::Diagnostics diagnostics;
    const auto root = calc::parse_xml(bytes, entry.path().string(), diagnostics);
    ASSERT_TRUE(root.has_value());
    const auto pack = std::find_if(packs.begin(), packs.end(), [&](const RulePack& candidate) {
      return candidate.full_id() == text_of(*root, "pack");
    });
    ASSERT_NE(pack, packs.end());
    const std::string id = text_of(*root, "id");
    std::set<std::string> seen;
    for (const calc::XmlElement& item : root->children) {
      const std::string expected = text_of(item, "expect");
      EXPECT_EQ(outcome(item, *pack, id), expected) << "line " << item.where.line;
      seen.insert(kind_of(expected));
    }
    EXPECT_EQ(seen.size(), 3u) << "a pass, a fail and an undecided case are needed";
    EXPECT_EQ(missing.erase(pack->full_id() + " " + id), 1u);
  }
  EXPECT_TRUE(missing.empty()) << "no case for " << *missing.begin();
}

}  // namespace
}  // namespace rules::aggregate_corpus_test
