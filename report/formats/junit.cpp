#include "report/formats/junit.h"

#include "report/formats/ci_finding.h"
#include "report/formats/ci_revision.h"
#include "report/revision/revision_tables.h"
#include "report/text/one_source_note.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <pugixml.hpp>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace report {
namespace {

enum class CaseResult { passed, skipped, error, failure };

CaseResult result_of(const CiFinding& entry) {
  if (entry.verdict == rules::Verdict::pass) return CaseResult::passed;
  if (!entry.counts) return CaseResult::skipped;
  return entry.verdict == rules::Verdict::not_judged ? CaseResult::error : CaseResult::failure;
}

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;

  void add(CaseResult result) {
    ++tests;
    skipped += result == CaseResult::skipped ? 1 : 0;
    errors += result == CaseResult::error ? 1 : 0;
    failures += result == CaseResult::failure ? 1 : 0;
  }
  // Schemas of others know no "skipped" of all suites together.
  void write_to(pugi::xml_node node, bool is_suite) const {
    node.append_attribute("tests") = tests;
    node.append_attribute("failures") = failures;
    node.append_attribute("errors") = errors;
    if (is_suite) node.append_attribute("skipped") = skipped;
  }
};

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name) = value.c_str();
}

std::string case_name(const CiFinding& entry) {
  if (entry.aggregate != nullptr) return entry.key;
  if (entry.plane == nullptr) return "project";
  const std::string plane = printable(entry.plane->id);
  return entry.finding == nullptr ? plane
                                  : plane + " / " + printable(entry.finding->requirement.id);
}

std::string class_name(const CiFinding& entry) {
  const std::string project = printable(entry.project->path);
  return entry.space == nullptr ? project : project + "." + printable(entry.space->id);
}

void add_case(pugi::xml_node suite, const CiFinding& entry) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", class_name(entry));
  set(test, "name", case_name(entry));
  set(test, "file", printable(entry.where.file));
  if (entry.where.line > 0) test.append_attribute("line") = entry.where.line;
  const std::string words =
      entry.place + ": " + entry.message + (entry.is_known ? " (failed before the revision)" : "");
  const CaseResult result = result_of(entry);
  if (result == CaseResult::passed) {
    test.append_child("system-out").text() = words.c_str();
    return;
  }
  if (result == CaseResult::skipped) {
    set(test.append_child("skipped"), "message", words);
    return;
  }
  pugi::xml_node problem = test.append_child(result == CaseResult::error ? "error" : "failure");
  set(problem, "type", calc::name_of(entry.verdict).data());
  set(problem, "message", words);
  problem.text() = words.c_str();
}

// A warning is a case of its own, since nobody looks at the output of cases that pass: skipped, as
// all that does not count, or a failure if it counts.
CaseResult result_of(const ProjectPart& project, const calc::Diagnostic& warning) {
  return is_strict_warning(project, warning) ? CaseResult::failure : CaseResult::skipped;
}

template <class Visit>
void for_each_warning(const ProjectPart& project, Visit visit) {
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    if (is_warning(diagnostic)) visit(diagnostic);
  }
}

// number: how many of that id the project has had so far, with this one.
void add_warning_case(pugi::xml_node suite, const ProjectPart& project,
                      const calc::Diagnostic& warning, int number) {
  pugi::xml_node test = suite.append_child("testcase");
  const std::string id = calc::diagnostic_name(warning.id);
  set(test, "classname", printable(project.path));
  set(test, "name", "warning / " + id + (number > 1 ? "-" + std::to_string(number) : ""));
  set(test, "file", printable(warning.where.file.empty() ? project.path : warning.where.file));
  if (warning.where.line > 0) test.append_attribute("line") = warning.where.line;
  const std::string words = printable(warning.message);
  if (result_of(project, warning) == CaseResult::skipped) {
    set(test.append_child("skipped"), "message", words);
    return;
  }
  pugi::xml_node problem = test.append_child("failure");
  set(problem, "type", "warning");
  set(problem, "message", words);
  problem.text() = words.c_str();
}

CaseResult result_of(const CiChange& change) {
  return change.stops ? CaseResult::failure : CaseResult::skipped;
}

// A suite of its own, whose cases are what became worse and what is asked for less.
void add_revision_suite(pugi::xml_node root, const Document& document,
                        const std::vector<CiChange>& changes) {
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", "revision");
  Counts counts;
  for (const CiChange& change : changes) counts.add(result_of(change));
  counts.write_to(suite, true);
  for (const CiChange& change : changes) {
    pugi::xml_node test = suite.append_child("testcase");
    set(test, "classname", change.project.empty() ? "luxgate" : printable(change.project));
    set(test, "name", change.rule + " / " + change.key);
    set(test, "file", printable(change.where.file));
    if (change.where.line > 0) test.append_attribute("line") = change.where.line;
    pugi::xml_node outcome = test.append_child(change.stops ? "failure" : "skipped");
    if (change.stops) set(outcome, "type", change.rule);
    set(outcome, "message", change.message);
    if (change.stops) outcome.text() = change.message.c_str();
  }
  std::string words;
  for (const std::string& remark : revision_remarks(document, {})) {
    words += printable(remark) + "\n";
  }
  if (!words.empty()) suite.append_child("system-out").text() = words.c_str();
}

// A suite of its own: errors of no single project, and what is said once of all of them.
void add_document_suite(pugi::xml_node root, const std::vector<calc::Diagnostic>& errors,
                        const std::string& note) {
  pugi::xml_node suite = root.append_child("testsuite");
  set(suite, "name", "luxgate");
  Counts counts;
  for (std::size_t i = 0; i < errors.size(); ++i) counts.add(CaseResult::error);
  counts.write_to(suite, true);
  for (const calc::Diagnostic& error : errors) {
    pugi::xml_node test = suite.append_child("testcase");
    const std::string id = calc::diagnostic_name(error.id), words = printable(error.message);
    set(test, "classname", "luxgate");
    set(test, "name", "error / " + id);
    pugi::xml_node problem = test.append_child("error");
    set(problem, "type", id);
    set(problem, "message", words);
    problem.text() = words.c_str();
  }
  if (!note.empty()) suite.append_child("system-out").text() = (note + "\n").c_str();
}

// A suite as it stands in the file, one level deep.
std::string suite_text(const pugi::xml_document& xml) {
  std::ostringstream out;
  xml.first_child().print(out, "  ", pugi::format_default, pugi::encoding_utf8, 1);
  return out.str();
}

class JunitWriter : public FormatWriter {
 public:
  JunitWriter(const DocumentFrame& frame, const SpillPlace& place)
      : frame_(frame), findings_(frame), suites_(place) {}

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  const DocumentFrame& frame_;
  CiFindings findings_;
  Counts all_;
  Spill suites_;
};

void JunitWriter::add(const ProjectPart& project) {
  const std::vector<CiFinding> findings = findings_.of(project);
  pugi::xml_document xml;
  pugi::xml_node suite = xml.append_child("testsuite");
  set(suite, "name", printable(project.path));
  Counts counts;
  const auto count = [&](CaseResult result) {
    counts.add(result);
    all_.add(result);
  };
  for (const CiFinding& entry : findings) count(result_of(entry));
  for_each_warning(project,
                   [&](const calc::Diagnostic& warning) { count(result_of(project, warning)); });
  counts.write_to(suite, true);
  for (const CiFinding& entry : findings) add_case(suite, entry);
  std::map<calc::DiagnosticId, int> number;
  for_each_warning(project, [&](const calc::Diagnostic& warning) {
    add_warning_case(suite, project, warning, ++number[warning.id]);
  });
  std::string notes;
  // A suite of which nothing is required has no failure either: it must not look like a pass.
  if (const rules::Outcome outcome = outcome_of(project);
      outcome == rules::Outcome::nothing_asked) {
    notes += std::string(outcome_words(outcome)) + "\n";
  }
  for (const std::string& note : ci_notes(project)) notes += note + "\n";
  const std::string words = provenance_remarks(frame_.provenance);
  if (!words.empty() && suites_.is_empty()) notes += words + "\n";
  if (!notes.empty()) suite.append_child("system-out").text() = notes.c_str();
  suites_.write(suite_text(xml));
}

void JunitWriter::finish(const DocumentEnd& end, Sink& sink) {
  const std::vector<calc::Diagnostic> errors = document_errors(end);
  for (std::size_t i = 0; i < errors.size(); ++i) all_.add(CaseResult::error);
  const std::string note = one_source_note({}, end.totals.one_source_rows);
  if (!errors.empty() || !note.empty()) {
    pugi::xml_document xml;
    add_document_suite(xml, errors, note);
    suites_.write(suite_text(xml));
  }
  if (const Document* revised = frame_.revised) {
    const std::vector<CiChange> changes = ci_changes(*revised);
    for (const CiChange& change : changes) all_.add(result_of(change));
    pugi::xml_document xml;
    add_revision_suite(xml, *revised, changes);
    suites_.write(suite_text(xml));
  }
  pugi::xml_document xml;
  pugi::xml_node declaration = xml.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = xml.append_child("testsuites");
  set(root, "name", "luxgate");
  all_.write_to(root, false);
  // Stands for the suites, on a line of its own.
  if (!suites_.is_empty()) root.append_child("suites");
  std::ostringstream out;
  xml.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
  const std::string text = out.str(), gap = "  <suites />\n";
  const std::size_t at = text.find(gap);
  sink.write(text.substr(0, at));
  suites_.copy_to(sink);
  if (at != std::string::npos) sink.write(text.substr(at + gap.size()));
}

}  // namespace

std::unique_ptr<FormatWriter> junit_writer(const DocumentFrame& frame, const SpillPlace& place) {
  return std::make_unique<JunitWriter>(frame, place);
}

}  // namespace report
