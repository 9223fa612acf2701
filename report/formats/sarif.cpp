#include "report/formats/sarif.h"

#include "calc/base/diagnostic_ids.h"
#include "report/formats/ci_finding.h"
#include "report/formats/ci_revision.h"
#include "report/stream/json_list.h"
#include "report/text/json_layout.h"
#include "report/text/one_source_note.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
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
  if (rule == "building") return "What is required of rooms together must be met";
  if (rule == "worse") return "A value must not become worse";
  if (rule == "weaker-question") return "A design must not be asked for less";
  if (rule == "class") return "A class of a rule pack should be reached";
  return "A required quantity of a calculation plane must meet its limit";
}

// Who lives with it, until when and why.
std::string justification(const CiFinding& entry) {
  if (entry.aggregate != nullptr) return printable(entry.aggregate->reason.english());
  const std::optional<rules::Waiver>& waiver = entry.finding->requirement.waiver;
  if (!waiver) return printable(entry.finding->reason.english());
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

// What is found, with a gap for the place of its rule among all rules.
Json result_json(const CiFinding& entry) {
  const bool is_fail = entry.verdict == rules::Verdict::fail;
  Json location = {{"physicalLocation", physical_location(entry.where)}};
  if (entry.plane != nullptr || entry.aggregate != nullptr) {
    location["logicalLocations"] =
        Json::array({{{"fullyQualifiedName", entry.key}, {"kind", "object"}}});
  }
  // Only what fails may have a level.  [SARIF, 3.27.10]
  const char* level = !is_fail ? "none" : entry.counts || is_waived(entry) ? "error" : "note";
  Json result = {{"ruleId", entry.rule},
                 {"ruleIndex", json_gap()},
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

Json change_json(const CiChange& change) {
  return {
      {"ruleId", change.rule},
      {"ruleIndex", json_gap()},
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

Json artifact_json(const calc::InputFile& input) {
  Json json = {{"location", artifact_location(input.path)}};
  if (!input.sha256.empty()) json["hashes"] = {{"sha-256", input.sha256}};
  return json;
}

Json notification_json(const calc::Diagnostic& diagnostic, bool is_error) {
  Json json = {{"descriptor", {{"id", calc::diagnostic_name(diagnostic.id)}}},
               {"level", is_error ? "error" : "warning"},
               {"message", {{"text", printable(diagnostic.message)}}}};
  if (!diagnostic.where.file.empty()) {
    json["locations"] = Json::array({{{"physicalLocation", physical_location(diagnostic.where)}}});
  }
  return json;
}

// How many lists and objects of the file something stands in.
constexpr std::size_t kInRun = 3, kInInvocation = 5;

// Results, and the rules that occur in them: which place a rule has among all is known at the end.
class Results {
 public:
  explicit Results(const SpillPlace& place) : text_(place) {}

  // result: with one gap.
  void add(const Json& result, const std::string& rule) {
    const std::vector<std::string> pieces = json_layout_around_gaps(result, kInRun + 1);
    text_.write((text_.is_empty() ? "[\n" : ",\n") + std::string(kInRun + 1, ' ') + pieces.at(0));
    const auto found = rules_.try_emplace(rule, rules_.size()).first;
    gaps_.push_back({text_.size(), found->second});
    text_.write(pieces.at(1));
  }

  Json rules() const {
    Json array = Json::array();
    for (const auto& rule : rules_) {
      array.push_back(
          {{"id", rule.first}, {"shortDescription", {{"text", rule_words(rule.first)}}}});
    }
    return array;
  }

  void copy_to(Sink& sink) const {
    if (text_.is_empty()) return sink.write("[]");
    std::vector<std::string> places(rules_.size());  // by number
    for (std::size_t place = 0; const auto& rule : rules_) {
      places[rule.second] = std::to_string(place++);
    }
    std::uint64_t at = 0;
    const auto copy_up_to = [&](std::uint64_t end) {
      sink.write(text_.read(at, static_cast<std::size_t>(end - at)));
      at = end;
    };
    for (const Gap& gap : gaps_) {
      copy_up_to(gap.at);
      sink.write(places[gap.rule]);
    }
    copy_up_to(text_.size());
    sink.write("\n" + std::string(kInRun, ' ') + "]");
  }

 private:
  struct Gap {
    std::uint64_t at = 0;  // in the text
    std::size_t rule = 0;
  };

  std::map<std::string, std::size_t> rules_;  // in the file's order; numbered as they came
  std::vector<Gap> gaps_;
  Spill text_;
};

class SarifWriter : public FormatWriter {
 public:
  SarifWriter(const DocumentFrame& frame, const SpillPlace& place, SarifContent content)
      : frame_(frame),
        content_(content),
        findings_(frame),
        notifications_(place, kInInvocation),
        artifacts_(place, kInRun),
        results_(place) {}

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  const DocumentFrame& frame_;
  SarifContent content_;
  CiFindings findings_;
  JsonList notifications_, artifacts_;
  std::set<std::pair<std::string, std::string>> listed_;  // artifacts: projects may share files
  Results results_;
};

void SarifWriter::add(const ProjectPart& project) {
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    notifications_.add(notification_json(
        diagnostic, !is_warning(diagnostic) || is_strict_warning(project, diagnostic)));
  }
  for (const std::string& words : ci_left_out(project)) {
    notifications_.add(
        {{"descriptor", {{"id", "left-out"}}}, {"level", "note"}, {"message", {{"text", words}}}});
  }
  for (const std::string& words : ci_notes(project)) {
    notifications_.add(
        {{"descriptor", {{"id", "note"}}}, {"level", "note"}, {"message", {{"text", words}}}});
  }
  for (const calc::InputFile& input : project.inputs) {
    if (listed_.emplace(input.path, input.sha256).second) artifacts_.add(artifact_json(input));
  }
  for (const CiFinding& entry : findings_.of(project)) {
    if (content_ == SarifContent::problems && entry.verdict == rules::Verdict::pass) continue;
    results_.add(result_json(entry), entry.rule);
  }
}

void SarifWriter::finish(const DocumentEnd& end, Sink& sink) {
  if (frame_.revised != nullptr) {
    for (const CiChange& change : ci_changes(*frame_.revised)) {
      results_.add(change_json(change), change.rule);
    }
  }
  if (const std::string note = one_source_note({}, end.totals.one_source_rows); !note.empty()) {
    const std::string id = calc::diagnostic_name(calc::DiagnosticId::one_source);
    notifications_.add(
        {{"descriptor", {{"id", id}}}, {"level", "note"}, {"message", {{"text", note}}}});
  }
  const std::vector<calc::Diagnostic> errors = document_errors(end);
  for (const calc::Diagnostic& error : errors) notifications_.add(notification_json(error, true));
  const bool is_successful = end.totals.projects_not_judged == 0 && errors.empty();
  const Json invocation = {{"executionSuccessful", is_successful},
                           {"commandLine", printable(end.provenance.command_line)},
                           {"toolExecutionNotifications", json_gap()}};
  Json run = {{"tool",
               {{"driver",
                 {{"name", "luxgate"},
                  {"version", end.provenance.program_version},
                  {"rules", results_.rules()}}}}},
              {"invocations", Json::array({invocation})},
              {"artifacts", json_gap()},
              {"columnKind", "utf16CodeUnits"},
              {"results", json_gap()}};
  if (const std::string words = redaction_words(end.provenance); !words.empty())
    run["properties"]["redacted"] = words;
  if (const std::string words = policy_words(end.provenance); !words.empty())
    run["properties"]["policy"] = words;
  const std::vector<std::string> pieces =
      json_layout_around_gaps({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                               {"version", "2.1.0"},
                               {"runs", Json::array({std::move(run)})}},
                              0);
  sink.write(pieces.at(0));
  notifications_.copy_to(sink);
  sink.write(pieces.at(1));
  artifacts_.copy_to(sink);
  sink.write(pieces.at(2));
  results_.copy_to(sink);
  sink.write(pieces.at(3) + "\n");
}

}  // namespace

std::unique_ptr<FormatWriter> sarif_writer(const DocumentFrame& frame, const SpillPlace& place,
                                           SarifContent content) {
  return std::make_unique<SarifWriter>(frame, place, content);
}

}  // namespace report
