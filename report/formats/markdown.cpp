#include "report/formats/markdown.h"

#include "report/formats/ci_finding.h"
#include "report/text/aggregate_words.h"
#include "report/text/plain_text.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostRows = 100;

// Text from files as plain text in a table cell: nothing in it is markup, a link or a mention.
std::string escape_markdown(std::string_view raw) {
  const std::string text = printable(raw);
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const std::string_view rest = std::string_view(text).substr(i);
    const bool is_markup = std::string_view("&<>@#\\`*_[]|~!").find(c) != std::string_view::npos;
    // Bare addresses become links.
    const bool is_address = rest.starts_with("://") || (c == '.' && escaped.ends_with("www"));
    escaped +=
        is_markup || is_address ? fmt::format("&#{};", static_cast<int>(c)) : std::string(1, c);
  }
  return escaped;
}

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
  if (is_waived(entry)) return t.say<Text::verdict_waived>(words);
  const bool is_member = entry.finding != nullptr &&
                         entry.finding->requirement.severity == rules::Severity::in_aggregate;
  return is_member ? t.say<Text::verdict_in_aggregate>(words) : t.say<Text::verdict_advice>(words);
}

std::string table(const Texts& t, const std::vector<CiFinding>& findings) {
  std::string text = t[Text::markdown_head];
  text += "\n| --- | --- | --- | ---: | ---: | ---: |\n";
  std::size_t rows = 0;
  for (const CiFinding& entry : findings) {
    if (++rows > kMostRows) break;
    text += fmt::format("| {} {} | {} | {} |\n", verdict_symbol(entry.verdict),
                        entry_words(t, entry), escape_markdown(entry.place), cells(t, entry));
  }
  if (findings.size() > kMostRows) {
    text += "\n" + t.say<Text::more_left_out>(findings.size() - kMostRows) + "\n";
  }
  return text;
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

std::string render_markdown(const Document& document, const Texts& t) {
  std::vector<CiFinding> passed, others;
  for (CiFinding& entry : ci_findings(document, t)) {
    (entry.verdict == rules::Verdict::pass ? passed : others).push_back(std::move(entry));
  }
  const rules::Outcome outcome = outcome_of(document);
  std::string text = fmt::format("### luxgate: {} {}\n\n{}\n", outcome_symbol(outcome),
                                 outcome_words(t, outcome), summary_words(t, document));
  if (!others.empty()) text += "\n" + table(t, others);
  for (const ProjectPart& project : document.projects) text += warnings(t, project);
  for (const ProjectPart& project : document.projects) {
    const std::vector<std::string> notes = ci_notes(project, t);
    if (notes.empty()) continue;
    text += "\n" + t.say<Text::notes_on>(escape_markdown(project.path)) + "\n\n";
    for (const std::string& note : notes) text += fmt::format("- {}\n", escape_markdown(note));
  }
  if (!passed.empty()) {
    text += fmt::format("\n<details>\n<summary>{}</summary>\n\n{}\n</details>\n",
                        t.say<Text::passed>(passed.size()), table(t, passed));
  }
  if (const std::string words = redaction_words(document, t); !words.empty())
    text += "\n" + words + "\n";
  return text;
}

}  // namespace report
