// The whole corpus of rule packs as results: what is judged there, alone and together, is read
// again from a result file, and nothing of it contradicts itself.

#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "report/result_file/read_json.h"
#include "rules/pack/evaluate.h"
#include "rules/verdict/judge_aggregates.h"
#include "tests/support/evaluated.h"
#include "tests/support/rendered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace report::corpus_results_test {
namespace {

using rules::Verdict;

std::string text_of(const calc::XmlElement& element, const char* name) {
  const calc::XmlAttribute* attribute = element.find(name);
  return attribute == nullptr ? "" : attribute->value;
}

calc::Estimate measured_of(const calc::XmlElement& element) {
  const auto number = [&](const char* name) {
    return calc::parse_number(text_of(element, name)).value_or(NAN);
  };
  return {number("value"), number("low"), number("high")};
}

Verdict verdict_of(rules::CheckStatus status) {
  switch (status) {
    case rules::CheckStatus::pass:
      return Verdict::pass;
    case rules::CheckStatus::fail:
      return Verdict::fail;
    case rules::CheckStatus::undecided:
      return Verdict::undecided;
    case rules::CheckStatus::not_applicable:
    case rules::CheckStatus::not_evaluated:
      break;
  }
  return Verdict::not_judged;
}

rules::Metric metric_of(const rules::RuleCheck& check) {
  switch (check.quantity->dimension) {
    case rules::Dimension::power_density:
      return rules::Metric::power_density;
    case rules::Dimension::energy_density:
      return rules::Metric::leni;
    default:
      return check.metric;
  }
}

// As a plane would have it, with the verdict of the pack's own evaluation.
rules::Finding finding_of(const rules::RulePack& pack, const rules::RuleCheck& check,
                          const std::string& row, rules::RowLevel level,
                          const calc::Estimate& measured) {
  const rules::Evidence evidence{pack, pack.find_row(row), level, {}, {{check.id, measured}}};
  const rules::Limit limit = limit_of(check, evidence);
  rules::Finding finding;
  rules::Requirement& requirement = finding.requirement;
  requirement.metric = metric_of(check);
  requirement.derived = check.quantity->derived;
  requirement.arguments = check.arguments_of(requirement.metric);
  requirement.comparison = check.comparison;
  requirement.limit = limit.value.value;
  requirement.policy = pack.policy;
  requirement.severity = check.severity;
  requirement.origin = {pack.full_id(), check.id, row, level, {}};
  finding.verdict = verdict_of(evaluate_check(check, evidence));
  if (finding.verdict == Verdict::not_judged) {
    finding.reason = limit.reason;
    return finding;
  }
  finding.measured = measured;
  // The pack alone knows other digits of modelling, and of what no plane measures.
  const bool is_measured =
      (check.quantity->kernel && requirement.derived != calc::DerivedQuantity::modelling) ||
      rules::is_of_space(requirement.metric);
  const rules::Decision decision = decision_of(check, evidence);
  finding.is_close =
      is_measured ? decision.is_close : rules::decide(requirement, measured).is_close;
  finding.by_tolerance = decision.by_tolerance;
  finding.margin = rules::margin_of(requirement, measured, finding.verdict);
  return finding;
}

// Every quantity has its own plane.
struct Room {
  calc::Space space;
  SpacePart part;
  std::deque<calc::CalcPlane> planes;

  Room() { space.id = part.id = "room"; }

  void add(const rules::RuleCheck& check, rules::Finding finding) {
    const calc::DerivedQuantity derived = finding.requirement.derived;
    const auto kernel = check.quantity->kernel.value_or(calc::ReceiverKernel::planar);
    auto own = std::find_if(part.planes.begin(), part.planes.end(), [&](const PlanePart& plane) {
      return plane.derived == derived && plane.kernel == kernel;
    });
    if (own == part.planes.end()) {
      PlanePart& plane = part.planes.emplace_back();
      plane.id = "plane " + std::to_string(part.planes.size());
      plane.is_computed = true;
      plane.derived = plane.grid.derived = derived;
      plane.kernel = plane.grid.kernel = kernel;
      planes.emplace_back().id = plane.id;
      own = std::prev(part.planes.end());
    }
    finding.requirement.plane_id = own->id;
    finding.requirement.id = std::to_string(own->findings.size());
    own->findings.push_back(std::move(finding));
  }

  std::vector<rules::JudgedPlane> judged() const {
    std::vector<rules::JudgedPlane> all;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      all.push_back({&space, &planes[i], &part.planes[i].findings});
    }
    return all;
  }
};

ProjectPart project_of(const std::string& path, const Room& room, const rules::RulePack& pack) {
  ProjectPart project;
  project.path = path;
  project.is_judged = true;
  project.spaces = {room.part};
  project.aggregates = judge_aggregates(room.judged(), {pack});
  return project;
}

struct Corpus {
  std::vector<ProjectPart> projects;
  std::set<Verdict> alone, together;
};

void add_file(const calc::XmlElement& root, const std::string& path, const rules::RulePack& pack,
              Corpus& corpus) {
  const rules::RuleCheck* check = pack.find_check(text_of(root, "check"));
  Room of_file;
  for (const calc::XmlElement& item : root.children) {
    const rules::RowLevel level = rules::level_named(text_of(item, "level"));
    const std::string row = text_of(item, "row");
    if (check != nullptr) {
      if (item.find("facts") != nullptr) continue;
      of_file.add(*check, finding_of(pack, *check, row, level, measured_of(item)));
      continue;
    }
    Room room;
    for (const calc::XmlElement& measured : item.children) {
      const rules::RuleCheck& own = *pack.find_check(text_of(measured, "check"));
      room.add(own, finding_of(pack, own, row, level, measured_of(measured)));
    }
    corpus.projects.push_back(project_of(path, room, pack));
  }
  if (check != nullptr) corpus.projects.push_back(project_of(path, of_file, pack));
}

Corpus whole_corpus() {
  Corpus corpus;
  const std::vector<rules::RulePack> packs = rules::builtin_rule_packs();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(LUXGATE_RULES_CORPUS)) {
    if (entry.path().extension() != ".xml") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    calc::Diagnostics diagnostics;
    const auto root = calc::parse_xml(bytes, entry.path().string(), diagnostics);
    for (const rules::RulePack& pack : packs) {
      if (root && pack.full_id() == text_of(*root, "pack")) {
        add_file(*root, entry.path().string(), pack, corpus);
      }
    }
  }
  for (const ProjectPart& project : corpus.projects) {
    for (const PlanePart& plane : project.spaces[0].planes) {
      for (const rules::Finding& finding : plane.findings) corpus.alone.insert(finding.verdict);
    }
    for (const auto& finding : project.aggregates) corpus.together.insert(finding.verdict);
  }
  return corpus;
}

TEST(CorpusResults, NoneOfThemContradictsItself) {
  const Corpus corpus = whole_corpus();
  EXPECT_GT(corpus.projects.size(), 90u);
  EXPECT_GE(corpus.alone.size(), 3u);
  EXPECT_EQ(corpus.together.size(), 4u);
  for (const ProjectPart& project : corpus.projects) {
    Document document;
    document.provenance.numbers_version = 1;
    document.projects = {project};
    const std::string bytes = rendered("json", document);
    std::string problem;
    const std::optional<Document> read = read_json(bytes, problem);
    EXPECT_TRUE(read) << problem;
    if (read) {
      EXPECT_EQ(rendered("json", *read), bytes);
    }
  }
}

}  // namespace
}  // namespace report::corpus_results_test
