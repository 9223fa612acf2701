#include "report/formats/markdown.h"

#include "report/formats/ci_finding.h"
#include "report/revision/gate.h"
#include "report/revision/revision_tables.h"
#include "report/text/aggregate_words.h"
#include "report/text/markup.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostRows = 100;

std::string cells(const Texts& t, const CiFinding& entry) {
  const rules::Finding* finding = entry.finding;
  if (const rules::AggregateFinding* aggregate = entry.aggregate) {
    std::string words = aggregate_title(t, *aggregate);
    if (!aggregate->clause.empty()) words += ", " + aggregate->clause;
    if (const std::string note = aggregate_note(t, *aggregate); !note.empty()) words += "; " + note;
    if (!aggregate->reason.empty()) words += "; " + aggregate->reason;
    return fmt::format("{} | {} | {} | ", escape_markdown(words),
                       escape_markdown(aggregate_required(t, *aggregate)),
                       escape_markdown(aggregate_measured(t, *aggregate)));
  }
  if (finding == nullptr) return fmt::format("{} | | | ", escape_markdown(entry.message));
  const rules::Requirement& requirement = finding->requirement;
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  std::string quantity = escape_markdown(quantity_words(t, requirement, entry.plane->kernel) +
                                         scene_words(t, requirement));
  if (!requirement.clause.empty()) quantity += ", " + escape_markdown(requirement.clause);
  if (const std::string note = note_words(t, *finding); !note.empty()) {
    quantity += " (" + escape_markdown(note) + ")";
  }
  if (!finding->reason.empty()) quantity += ": " + escape_markdown(finding->reason);
  const bool is_judged = finding->verdict != rules::Verdict::not_judged;
  return fmt::format("{} | {} | {} | {}", quantity, format_required(t, threshold, unit),
                     is_judged ? format_measured(t, finding->measured, unit, threshold) : "",
                     is_judged ? format_margin(t, finding->margin) : "");
}

std::string entry_words(const Texts& t, const CiFinding& entry) {
  const char* words = verdict_words(t, entry.verdict);
  if (entry.counts) return words;
  if (entry.is_known) return t.say<Text::verdict_known>(words);
  if (is_waived(entry)) return t.say<Text::verdict_waived>(words);
  const bool is_member = entry.finding != nullptr &&
                         entry.finding->requirement.severity == rules::Severity::in_aggregate;
  return is_member ? t.say<Text::verdict_in_aggregate>(words) : t.say<Text::verdict_advice>(words);
}

// has_projects: the first column says which project it is.
std::string table(const Texts& t, const std::vector<CiFinding>& findings, bool has_projects) {
  std::string text;
  if (has_projects) text += std::string("| ") + t[Text::markdown_project] + " ";
  text += std::string(t[Text::markdown_head]) + "\n";
  text += has_projects ? "| --- " : "";
  text += "| --- | --- | --- | ---: | ---: | ---: |\n";
  std::size_t rows = 0;
  for (const CiFinding& entry : findings) {
    if (++rows > kMostRows) break;
    if (has_projects) text += fmt::format("| {} ", escape_markdown(entry.project->path));
    text += fmt::format("| {} {} | {} | {} |\n", verdict_symbol(entry.verdict),
                        entry_words(t, entry), escape_markdown(entry.place), cells(t, entry));
  }
  if (findings.size() > kMostRows) {
    text += "\n" + t.say<Text::more_left_out>(findings.size() - kMostRows) + "\n";
  }
  return text;
}

// What each of them came to: two variants of a design have the same rooms and planes.
std::string projects(const Texts& t, const Document& document) {
  constexpr std::size_t kMost = 50;
  std::string text = "\n";
  for (std::size_t p = 0; p < std::min(document.projects.size(), kMost); ++p) {
    const ProjectPart& project = document.projects[p];
    const rules::Outcome outcome = outcome_of(project);
    text += fmt::format("- {} {}: {}", outcome_symbol(outcome), outcome_words(t, outcome),
                        escape_markdown(project.path));
    if (!project.name.empty()) text += ", " + escape_markdown(project.name);
    text += "\n";
  }
  if (document.projects.size() <= kMost) return text;
  return text + "\n" + t.say<Text::more_left_out>(document.projects.size() - kMost) + "\n";
}

std::string warnings(const Texts& t, const ProjectPart& project) {
  constexpr std::size_t kMost = 20;
  std::string text;
  std::size_t count = 0;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    if (!is_warning(diagnostic) || ++count > kMost) continue;
    const bool counts = is_strict_warning(project, diagnostic);
    text +=
        fmt::format("- {}{}\n", counts ? std::string("**") + t[Text::warning_counts] + "** " : "",
                    escape_markdown(calc::format_diagnostic(diagnostic)));
  }
  if (count == 0) return {};
  if (count > kMost) text += "\n" + t.say<Text::more_left_out>(count - kMost) + "\n";
  return "\n" + t.say<Text::warnings_on>(escape_markdown(project.path)) + "\n\n" + text;
}

}  // namespace

// What a reviewer wants first. Inputs are folded.
std::string render_revision_markdown(const Texts& t, const Document& document) {
  std::string text;
  for (const RevisionTable& table : revision_tables(document, t, kMostRows)) {
    const auto line = [](const std::vector<std::string>& cells) {
      std::string row = "|";
      for (const std::string& cell : cells) row += " " + escape_markdown(cell) + " |";
      return row + "\n";
    };
    std::string rule = "|";
    for (std::size_t c = 0; c < table.head.size(); ++c) rule += " --- |";
    std::string rows = line(table.head) + rule + "\n";
    for (const std::vector<std::string>& row : table.rows) rows += line(row);
    if (table.left_out > 0) rows += "\n" + t.say<Text::more_left_out>(table.left_out) + "\n";
    const std::string title = escape_markdown(table.title);
    text += table.title == t[Text::revision_inputs]
                ? fmt::format("\n<details>\n<summary>{}</summary>\n\n{}\n</details>\n", title, rows)
                : fmt::format("\n**{}**\n\n{}", title, rows);
  }
  const std::vector<std::string> remarks = revision_remarks(document, t);
  if (!remarks.empty()) text += "\n";
  for (const std::string& remark : remarks) text += fmt::format("- {}\n", escape_markdown(remark));
  return text;
}

std::string render_markdown(const Document& document, const Texts& t) {
  std::vector<CiFinding> passed, others;
  for (CiFinding& entry : ci_findings(document, t)) {
    (entry.verdict == rules::Verdict::pass ? passed : others).push_back(std::move(entry));
  }
  const rules::Outcome outcome = gate_outcome(document);
  std::string text = fmt::format("### luxgate: {} {}\n\n{}\n", outcome_symbol(outcome),
                                 outcome_words(t, outcome), summary_words(t, document));
  const bool has_projects = document.projects.size() > 1;
  text += render_revision_markdown(t, document);
  if (has_projects) text += projects(t, document);
  if (!others.empty()) text += "\n" + table(t, others, has_projects);
  for (const ProjectPart& project : document.projects) text += warnings(t, project);
  for (const ProjectPart& project : document.projects) {
    const std::vector<std::string> notes = ci_notes(project, t);
    if (notes.empty()) continue;
    text += "\n" + t.say<Text::notes_on>(escape_markdown(project.path)) + "\n\n";
    for (const std::string& note : notes) text += fmt::format("- {}\n", escape_markdown(note));
  }
  if (!passed.empty()) {
    text += fmt::format("\n<details>\n<summary>{}</summary>\n\n{}\n</details>\n",
                        t.say<Text::passed>(passed.size()), table(t, passed, has_projects));
  }
  if (const std::string words = redaction_words(document, t); !words.empty())
    text += "\n" + words + "\n";
  return text;
}

}  // namespace report
