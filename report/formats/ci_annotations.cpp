#include "report/formats/ci_annotations.h"

#include "calc/base/file_hash.h"
#include "report/formats/ci_finding.h"
#include "report/formats/ci_revision.h"
#include "report/revision/revision_tables.h"
#include "report/text/json_layout.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string_view>
#include <utility>

namespace report {
namespace {

using Json = nlohmann::ordered_json;

// Values of workflow commands are percent-encoded; in properties ':' and ',' are, too.
std::string github_escape(std::string_view text, bool is_property) {
  std::string escaped;
  for (const char c : text) {
    const bool is_special =
        c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ','));
    escaped +=
        is_special ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return escaped;
}

std::string github_line(std::string_view command, const calc::SourceLocation& where,
                        std::string_view title, std::string_view message) {
  std::string line = fmt::format("::{} ", command);
  if (!where.file.empty()) {
    line += "file=" + github_escape(printable(where.file), true) + ",";
    if (where.line > 0) line += fmt::format("line={},", where.line);
    if (where.line > 0 && where.column > 0) line += fmt::format("col={},", where.column);
  }
  return line + "title=" + github_escape(title, true) + "::" + github_escape(message, false) + "\n";
}

// Or a warning that counts like one.
bool is_error(const ProjectPart& project, const calc::Diagnostic& diagnostic) {
  return !is_warning(diagnostic) || is_strict_warning(project, diagnostic);
}

const char* gitlab_severity(rules::Verdict verdict) {
  switch (verdict) {
    case rules::Verdict::fail:
      return "critical";
    case rules::Verdict::undecided:
      return "major";
    case rules::Verdict::pass:
      return "info";
    case rules::Verdict::not_judged:
      break;
  }
  return "blocker";
}

// GitLab keeps the first of equal fingerprints: repeats are numbered.
std::string unique_fingerprint(const std::string& text, std::set<std::string>& taken) {
  std::string fingerprint = calc::sha256_hex(text);
  for (int k = 2; !taken.insert(fingerprint).second; ++k) {
    fingerprint = calc::sha256_hex(fmt::format("{}#{}", text, k));
  }
  return fingerprint;
}

Json gitlab_issue(const std::string& check, const std::string& description,
                  const std::string& fingerprint, const char* severity,
                  const calc::SourceLocation& where) {
  return {
      {"description", description},
      {"check_name", check},
      {"fingerprint", fingerprint},
      {"severity", severity},
      // Lines count from 1; a whole file is its first line.
      {"location",
       {{"path", printable(where.file)}, {"lines", {{"begin", where.line > 0 ? where.line : 1}}}}}};
}

const char* command_for(const CiFinding& entry) {
  if (!entry.counts) return "notice";
  return entry.verdict == rules::Verdict::undecided ? "warning" : "error";
}

}  // namespace

std::string render_github(const Document& document) {
  std::string text;
  for (const ProjectPart& project : document.projects) {
    for (const calc::Diagnostic& diagnostic : project.diagnostics) {
      text += github_line(is_error(project, diagnostic) ? "error" : "warning", diagnostic.where,
                          fmt::format("luxgate: {}", calc::diagnostic_name(diagnostic.id)),
                          printable(diagnostic.message));
    }
    for (const std::string& words : ci_left_out(project)) {
      text += github_line("notice", {project.path, 0, 0}, "luxgate: left out", words);
    }
  }
  for (const CiFinding& entry : ci_findings(document)) {
    if (entry.verdict == rules::Verdict::pass || entry.is_known) continue;
    text +=
        github_line(command_for(entry), entry.where,
                    fmt::format("luxgate: {}: {}", rules::verdict_name(entry.verdict), entry.place),
                    entry.message);
  }
  for (const CiChange& change : ci_changes(document)) {
    text += github_line(change.stops ? "error" : "notice", change.where,
                        fmt::format("luxgate: {}", change.rule), change.message);
  }
  for (const std::string& remark : revision_remarks(document, {})) {
    text += "luxgate: " + printable(remark) + "\n";
  }
  text += "luxgate: " + printable(summary_words(document)) + "\n";
  if (const std::string words = redaction_words(document); !words.empty())
    text += "luxgate: " + words + "\n";
  return text;
}

std::string render_gitlab(const Document& document) {
  Json issues = Json::array();
  std::set<std::string> taken;
  for (const CiChange& change : ci_changes(document)) {
    issues.push_back(gitlab_issue("luxgate/" + change.rule, change.message,
                                  unique_fingerprint(change.fingerprint, taken),
                                  change.stops ? "critical" : "info", change.where));
  }
  for (const CiFinding& entry : ci_findings(document)) {
    if (entry.verdict == rules::Verdict::pass || entry.is_known) continue;
    issues.push_back(gitlab_issue(
        "luxgate/" + entry.rule,
        fmt::format("{}: {}: {}", rules::verdict_name(entry.verdict), entry.place, entry.message),
        unique_fingerprint(entry.fingerprint, taken),
        entry.counts ? gitlab_severity(entry.verdict) : "info", entry.where));
  }
  for (const ProjectPart& project : document.projects) {
    for (const calc::Diagnostic& diagnostic : project.diagnostics) {
      calc::SourceLocation where = diagnostic.where;
      if (where.file.empty()) where.file = project.path;
      const std::string name(calc::diagnostic_name(diagnostic.id));
      const std::string identity = project.path + "\n" + name + "\n" + diagnostic.message;
      issues.push_back(gitlab_issue("luxgate/" + name, printable(diagnostic.message),
                                    unique_fingerprint(identity, taken),
                                    is_error(project, diagnostic) ? "blocker" : "info", where));
    }
    for (const std::string& words : ci_left_out(project)) {
      issues.push_back(
          gitlab_issue("luxgate/left-out", words,
                       unique_fingerprint(project.path + "\nleft-out\n" + words, taken), "info",
                       {project.path, 0, 0}));
    }
  }
  return json_layout(issues);
}

}  // namespace report
