// Every check of every shipped pack, judged from given results:
// tests/rules_corpus/<pack>/<check>.xml holds what was measured and, beside it, the limit and the
// status that must come out, worked out without luxgate. Numbers are in base units.

#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "rules/pack/evaluate.h"
#include "tests/support/evaluated.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rules::rule_corpus_test {
namespace {

const std::filesystem::path kCorpus = LUXGATE_RULES_CORPUS;

std::string text_of(const calc::XmlElement& element, const char* name) {
  const calc::XmlAttribute* attribute = element.find(name);
  return attribute == nullptr ? "" : attribute->value;
}

double number_of(const calc::XmlElement& element, const char* name) {
  const std::optional<double> number = calc::parse_number(text_of(element, name));
  EXPECT_TRUE(number.has_value()) << name << " in line " << element.where.line;
  return number.value_or(0.0);
}

std::map<std::string, double> facts_of(const calc::XmlElement& element) {
  const std::string text = text_of(element, "facts");
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {};
  return {{text.substr(0, equals), calc::parse_number(text.substr(equals + 1)).value()}};
}

const RulePack* pack_named(const std::vector<RulePack>& packs, const std::string& id) {
  for (const RulePack& pack : packs) {
    if (pack.full_id() == id) return &pack;
  }
  return nullptr;
}

// Returns the status that was expected.
std::string expect_case(const calc::XmlElement& item, const RulePack& pack,
                        const RuleCheck& check) {
  const std::string ref = text_of(item, "row");
  const RowLevel level =
      item.find("level") == nullptr ? RowLevel::required : level_named(text_of(item, "level"));
  Evidence evidence{pack, pack.find_row(ref), level, facts_of(item)};
  evidence.special =
      calc::find_value<calc::SpecialPlace>(text_of(item, "place")).value_or(evidence.special);
  EXPECT_EQ(evidence.row == nullptr, ref.empty()) << "row " << ref;
  evidence.measured[check.id] = {number_of(item, "value"), number_of(item, "low"),
                                 number_of(item, "high")};
  const std::string expected = text_of(item, "expect");
  EXPECT_EQ(name_of_status(evaluate_check(check, evidence)), expected)
      << "line " << item.where.line;
  if (item.find("limit") != nullptr) {
    const double limit = number_of(item, "limit");
    EXPECT_NEAR(limit_of(check, evidence).value.value, limit, 1e-9 * limit)
        << "line " << item.where.line;
  }
  return expected;
}

std::optional<calc::XmlElement> read_xml(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  calc::Diagnostics diagnostics;
  std::optional<calc::XmlElement> root = calc::parse_xml(bytes, path.string(), diagnostics);
  for (const calc::Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
  return root;
}

TEST(RuleCorpus, EveryFileIsAsExpectedAndEveryCheckHasOne) {
  const std::vector<RulePack> packs = builtin_rule_packs();
  std::set<std::string> missing;
  for (const RulePack& pack : packs) {
    for (const RuleCheck& check : pack.checks) missing.insert(pack.full_id() + " " + check.id);
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kCorpus)) {
    if (entry.path().extension() != ".xml") continue;
    // Aggregates and classes: see aggregate_corpus_test.cpp.
    if (entry.path().filename().string().starts_with("together.")) continue;
    SCOPED_TRACE(entry.path().string());
    const std::optional<calc::XmlElement> root = read_xml(entry.path());
    ASSERT_TRUE(root.has_value());
    const RulePack* pack = pack_named(packs, text_of(*root, "pack"));
    ASSERT_NE(pack, nullptr);
    const RuleCheck* check = pack->find_check(text_of(*root, "check"));
    ASSERT_NE(check, nullptr);
    std::set<std::string> seen;
    for (const calc::XmlElement& item : root->children)
      seen.insert(expect_case(item, *pack, *check));
    EXPECT_TRUE(seen.contains("pass") && seen.contains("fail") && seen.contains("undecided"))
        << "a check needs a case of each";
    EXPECT_EQ(missing.erase(pack->full_id() + " " + check->id), 1u) << "two files for one check";
  }
  EXPECT_TRUE(missing.empty()) << "no case for " << *missing.begin();
}

}  // namespace
}  // namespace rules::rule_corpus_test
