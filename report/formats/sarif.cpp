#include "report/formats/sarif.h"

#include "report/formats/ci_finding.h"
#include "report/formats/ci_revision.h"
#include "report/text/json_layout.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

// A path as a URI reference [RFC 3986]: what is neither unreserved nor '/' becomes %XX.
std::string uri_of(const std::string& path) {
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') ||
                          std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json artifact_location(const std::string& path) {
  Json json = {{"uri", uri_of(path)}};
  if (!path.starts_with('/')) json["uriBaseId"] = "%SRCROOT%";
  return json;
}

Json physical_location(const calc::SourceLocation& where) {
  Json json = {{"artifactLocation", artifact_location(where.file)}};
  if (where.line > 0) {
    json["region"] = {{"startLine", where.line}};
    if (where.column > 0) json["region"]["startColumn"] = where.column;
  }
  return json;
}

const char* kind_of(rules::Verdict verdict) {
  switch (verdict) {
    case rules::Verdict::pass:
      return "pass";
    case rules::Verdict::fail:
      return "fail";
    case rules::Verdict::undecided:
      return "review";
    case rules::Verdict::not_judged:
      break;
  }
  return "open";
}

const char* rule_words(std::string_view rule) {
  if (rule == "plane") return "Every calculation plane must be computed";
  if (rule == "project") return "Every project must be read and calculated";
  if (rule == "aggregate") return "Requirements that a rule pack takes together must be met";
  if (rule == "worse") return "A value must not become worse";
  if (rule == "weaker-question") return "A design must not be asked for less";
  if (rule == "class") return "A class of a rule pack should be reached";
  return "A required quantity of a calculation plane must meet its limit";
}

Json rules_json(const std::vector<CiFinding>& findings, const std::vector<CiChange>& changes,
                std::map<std::string, std::size_t>& index) {
  for (const CiFinding& entry : findings) index.emplace(entry.rule, 0);
  for (const CiChange& change : changes) index.emplace(change.rule, 0);
  Json array = Json::array();
  for (auto& [rule, place] : index) {
    place = array.size();
    array.push_back({{"id", rule}, {"shortDescription", {{"text", rule_words(rule)}}}});
  }
  return array;
}

// Who lives with it, until when and why.
std::string justification(const CiFinding& entry) {
  if (entry.aggregate != nullptr) return printable(entry.aggregate->reason);
  const std::optional<rules::Waiver>& waiver = entry.finding->requirement.waiver;
  if (!waiver) return printable(entry.finding->reason);
  return printable(
      fmt::format("{} (by {} until {})", waiver->reason, waiver->owner, waiver->until));
}

// Against the baseline.  [SARIF, 3.27.24]
const char* baseline_state(ResultChange change) {
  switch (change) {
    case ResultChange::new_failing:
    case ResultChange::added:
      return "new";
    case ResultChange::gone:
      return "absent";
    case ResultChange::same:
      return "unchanged";
    default:
      return "updated";
  }
}

Json result_json(const CiFinding& entry, std::size_t rule_index) {
  const bool is_fail = entry.verdict == rules::Verdict::fail;
  Json location = {{"physicalLocation", physical_location(entry.where)}};
  if (entry.plane != nullptr || entry.aggregate != nullptr) {
    location["logicalLocations"] =
        Json::array({{{"fullyQualifiedName", entry.key}, {"kind", "object"}}});
  }
  // Only what fails may have a level.  [SARIF, 3.27.10]
  const char* level = !is_fail ? "none" : entry.counts || is_waived(entry) ? "error" : "note";
  Json result = {{"ruleId", entry.rule},
                 {"ruleIndex", rule_index},
                 {"kind", kind_of(entry.verdict)},
                 {"level", level},
                 {"message", {{"text", entry.place + ": " + entry.message}}},
                 {"locations", Json::array({location})},
                 {"partialFingerprints", {{"luxgate/v1", entry.fingerprint}}}};
  if (entry.change) result["baselineState"] = baseline_state(*entry.change);
  if (is_waived(entry)) {
    result["suppressions"] = Json::array(
        {{{"kind", "external"}, {"status", "accepted"}, {"justification", justification(entry)}}});
  }
  return result;
}

Json change_json(const CiChange& change, std::size_t rule_index) {
  return {
      {"ruleId", change.rule},
      {"ruleIndex", rule_index},
      {"kind", "fail"},
      {"level", change.stops ? "error" : "note"},
      {"message", {{"text", change.message}}},
      {"locations",
       Json::array({{{"physicalLocation", physical_location(change.where)},
                     {"logicalLocations",
                      Json::array({{{"fullyQualifiedName", change.key}, {"kind", "object"}}})}}})},
      {"partialFingerprints", {{"luxgate/v1", change.fingerprint}}},
      {"baselineState", "new"}};
}

Json artifacts_json(const Document& document) {
  Json array = Json::array();
  std::set<std::pair<std::string, std::string>> listed;  // projects may share files
  for (const ProjectPart& project : document.projects) {
    for (const calc::InputFile& input : project.inputs) {
      if (!listed.emplace(input.path, input.sha256).second) continue;
      Json json = {{"location", artifact_location(input.path)}};
      if (!input.sha256.empty()) json["hashes"] = {{"sha-256", input.sha256}};
      array.push_back(std::move(json));
    }
  }
  return array;
}

Json notification_json(const ProjectPart& project, const calc::Diagnostic& diagnostic) {
  const bool is_error = !is_warning(diagnostic) || is_strict_warning(project, diagnostic);
  Json json = {{"descriptor", {{"id", calc::diagnostic_name(diagnostic.id)}}},
               {"level", is_error ? "error" : "warning"},
               {"message", {{"text", printable(diagnostic.message)}}}};
  if (!diagnostic.where.file.empty()) {
    json["locations"] = Json::array({{{"physicalLocation", physical_location(diagnostic.where)}}});
  }
  return json;
}

Json invocation_json(const Document& document) {
  Json notifications = Json::array();
  bool is_successful = true;
  for (const ProjectPart& project : document.projects) {
    is_successful = is_successful && project.is_judged;
    for (const calc::Diagnostic& diagnostic : project.diagnostics) {
      notifications.push_back(notification_json(project, diagnostic));
    }
    for (const std::string& words : ci_left_out(project)) {
      notifications.push_back({{"descriptor", {{"id", "left-out"}}},
                               {"level", "note"},
                               {"message", {{"text", words}}}});
    }
  }
  return {{"executionSuccessful", is_successful},
          {"commandLine", printable(document.provenance.command_line)},
          {"toolExecutionNotifications", std::move(notifications)}};
}

}  // namespace

std::string render_sarif(const Document& document, SarifContent content) {
  std::vector<CiFinding> findings = ci_findings(document);
  if (content == SarifContent::problems) {
    std::erase_if(findings,
                  [](const CiFinding& entry) { return entry.verdict == rules::Verdict::pass; });
  }
  std::map<std::string, std::size_t> index;
  const std::vector<CiChange> changes = ci_changes(document);
  Json rules = rules_json(findings, changes, index);
  Json results = Json::array();
  for (const CiFinding& entry : findings) {
    results.push_back(result_json(entry, index.at(entry.rule)));
  }
  for (const CiChange& change : changes) {
    results.push_back(change_json(change, index.at(change.rule)));
  }
  Json run = {{"tool",
               {{"driver",
                 {{"name", "luxgate"},
                  {"version", document.provenance.program_version},
                  {"rules", std::move(rules)}}}}},
              {"invocations", Json::array({invocation_json(document)})},
              {"artifacts", artifacts_json(document)},
              {"columnKind", "utf16CodeUnits"},
              {"results", std::move(results)}};
  if (const std::string words = redaction_words(document); !words.empty())
    run["properties"] = {{"redacted", words}};
  return json_layout({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({std::move(run)})}});
}

}  // namespace report
