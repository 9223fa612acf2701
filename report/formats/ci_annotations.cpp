#include "report/formats/ci_annotations.h"

#include "calc/base/file_hash.h"
#include "report/formats/ci_finding.h"
#include "report/formats/ci_revision.h"
#include "report/revision/revision_tables.h"
#include "report/stream/json_list.h"
#include "report/text/one_source_note.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

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
class UniqueFingerprints {
 public:
  std::string of(const std::string& text) {
    std::string fingerprint = calc::sha256_hex(text);
    for (int k = 2; !taken_.insert(half(fingerprint)).second; ++k) {
      fingerprint = calc::sha256_hex(fmt::format("{}#{}", text, k));
    }
    return fingerprint;
  }

 private:
  // One is kept for every problem of every project: half of its bits tell them apart, too.
  using Half = std::array<std::uint64_t, 2>;
  static Half half(const std::string& hex) {
    return {std::stoull(hex.substr(0, 16), nullptr, 16),
            std::stoull(hex.substr(16, 16), nullptr, 16)};
  }

  std::set<Half> taken_;
};

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

// As one message, so that doubts are there and do not push findings out: a line for each.
std::string joined_notes(const ProjectPart& project) {
  return fmt::format("{}", fmt::join(ci_notes(project), "\n"));
}

class GithubWriter : public FormatWriter {
 public:
  GithubWriter(const DocumentFrame& frame, const SpillPlace& place)
      : frame_(frame), findings_(frame), messages_(place), problems_(place) {}

  void add(const ProjectPart& project) override {
    const std::vector<std::size_t> known = known_warnings(project);
    known_warnings_ += known.size();
    for (std::size_t k = 0; k < project.diagnostics.size(); ++k) {
      if (std::binary_search(known.begin(), known.end(), k)) continue;
      const calc::Diagnostic& diagnostic = project.diagnostics[k];
      messages_.write(github_line(is_error(project, diagnostic) ? "error" : "warning",
                                  diagnostic.where,
                                  fmt::format("luxgate: {}", calc::diagnostic_name(diagnostic.id)),
                                  printable(diagnostic.message)));
    }
    for (const std::string& words : ci_left_out(project)) {
      messages_.write(github_line("notice", {project.path, 0, 0}, "luxgate: left out", words));
    }
    if (const std::string notes = joined_notes(project); !notes.empty()) {
      messages_.write(github_line("notice", {project.path, 0, 0}, "luxgate: notes", notes));
    }
    for (const CiFinding& entry : findings_.of(project)) {
      if (entry.verdict == rules::Verdict::pass || entry.is_known) continue;
      if (std::string_view(command_for(entry)) == "error") ++errors_;
      problems_.write(github_line(
          command_for(entry), entry.where,
          fmt::format("luxgate: {}: {}", rules::verdict_name(entry.verdict), entry.place),
          entry.message));
    }
  }

  void finish(const DocumentEnd& end, Sink& sink) override {
    messages_.copy_to(sink);
    problems_.copy_to(sink);
    std::string text;
    if (const std::string note = one_source_note({}, end.totals.one_source_rows); !note.empty())
      text += github_line("notice", {}, "luxgate: one-source", note);
    for (const calc::Diagnostic& error : document_errors(end)) {
      text += github_line("error", error.where,
                          fmt::format("luxgate: {}", calc::diagnostic_name(error.id)),
                          printable(error.message));
    }
    if (const Document* revised = frame_.revised) {
      for (const CiChange& change : ci_changes(*revised)) {
        text += github_line(change.stops ? "error" : "notice", change.where,
                            fmt::format("luxgate: {}", change.rule), change.message);
      }
      for (const std::string& remark : revision_remarks(*revised, {})) {
        text += "luxgate: " + printable(remark) + "\n";
      }
    }
    text += "luxgate: " + printable(summary_words(end.totals)) + "\n";
    if (const std::string words = provenance_remarks(end.provenance); !words.empty())
      text += "luxgate: " + words + "\n";
    if (known_warnings_ > 0) {
      text += fmt::format("luxgate: warnings that are not new, listed in the other reports: {}\n",
                          known_warnings_);
    }
    constexpr std::size_t kMostShown = 10;  // of each kind and step
    if (errors_ > kMostShown) {
      text += fmt::format(
          "luxgate: {} errors, of which GitHub shows {} beside the files; all are "
          "in this log and in the other reports\n",
          errors_, kMostShown);
    }
    sink.write(text);
  }

 private:
  // Whoever reads a request has not made them, and would learn to look away.
  std::vector<std::size_t> known_warnings(const ProjectPart& project) const {
    if (frame_.revised == nullptr || !frame_.revised->revision) return {};
    for (const KnownWarnings& known : frame_.revised->revision->known_warnings) {
      if (known.project == project.path) return known.diagnostics;
    }
    return {};
  }

  const DocumentFrame& frame_;
  CiFindings findings_;
  std::size_t errors_ = 0, known_warnings_ = 0;
  Spill messages_, problems_;  // of all projects
};

// Problems of all projects come before the messages of all projects. Their fingerprints are made of
// texts that are never equal, so that each kind has its own numbers.
class GitlabWriter : public FormatWriter {
 public:
  GitlabWriter(const DocumentFrame& frame, const SpillPlace& place)
      : paths_(frame.paths), findings_(frame), problems_(place, 0), messages_(place, 0) {
    if (frame.revised == nullptr) return;
    for (const CiChange& change : ci_changes(*frame.revised)) {
      problems_.add(gitlab_issue("luxgate/" + change.rule, change.message,
                                 of_problems_.of(change.fingerprint),
                                 change.stops ? "critical" : "info", change.where));
    }
  }

  void add(const ProjectPart& project) override {
    for (const CiFinding& entry : findings_.of(project)) {
      if (entry.verdict == rules::Verdict::pass || entry.is_known) continue;
      problems_.add(gitlab_issue(
          "luxgate/" + entry.rule,
          fmt::format("{}: {}: {}", rules::verdict_name(entry.verdict), entry.place, entry.message),
          of_problems_.of(entry.fingerprint),
          entry.counts ? gitlab_severity(entry.verdict) : "info", entry.where));
    }
    for (const calc::Diagnostic& diagnostic : project.diagnostics) {
      calc::SourceLocation where = diagnostic.where;
      if (where.file.empty()) where.file = project.path;
      const std::string name(calc::diagnostic_name(diagnostic.id));
      const std::string identity = project.path + "\n" + name + "\n" + diagnostic.message;
      messages_.add(gitlab_issue("luxgate/" + name, printable(diagnostic.message),
                                 of_messages_.of(identity),
                                 is_error(project, diagnostic) ? "blocker" : "info", where));
    }
    for (const std::string& words : ci_left_out(project)) {
      messages_.add(gitlab_issue("luxgate/left-out", words,
                                 of_messages_.of(project.path + "\nleft-out\n" + words), "info",
                                 {project.path, 0, 0}));
    }
    if (const std::string notes = joined_notes(project); !notes.empty()) {
      messages_.add(gitlab_issue("luxgate/notes", notes, of_messages_.of(project.path + "\nnotes"),
                                 "info", {project.path, 0, 0}));
    }
  }

  void finish(const DocumentEnd& end, Sink& sink) override {
    // An issue without a file is refused: it is that of the first project.
    const std::string file = paths_.empty() ? "" : paths_.front();
    if (const std::string note = one_source_note({}, end.totals.one_source_rows); !note.empty()) {
      messages_.add(gitlab_issue("luxgate/one-source", note, of_messages_.of("one-source"), "info",
                                 {file, 0, 0}));
    }
    for (const calc::Diagnostic& error : document_errors(end)) {
      const std::string name(calc::diagnostic_name(error.id));
      messages_.add(gitlab_issue("luxgate/" + name, printable(error.message),
                                 of_messages_.of(name + "\n" + error.message), "blocker",
                                 {file, 0, 0}));
    }
    problems_.copy_to(sink, &messages_);
    sink.write("\n");
  }

 private:
  const std::vector<std::string>& paths_;  // of the projects
  CiFindings findings_;
  UniqueFingerprints of_problems_, of_messages_;
  JsonList problems_, messages_;
};

}  // namespace

std::unique_ptr<FormatWriter> github_writer(const DocumentFrame& frame, const SpillPlace& place) {
  return std::make_unique<GithubWriter>(frame, place);
}

std::unique_ptr<FormatWriter> gitlab_writer(const DocumentFrame& frame, const SpillPlace& place) {
  return std::make_unique<GitlabWriter>(frame, place);
}

}  // namespace report
