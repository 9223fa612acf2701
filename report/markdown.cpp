#include "report/markdown.h"

#include "report/ci_finding.h"
#include "report/number_format.h"
#include "report/plain_text.h"
#include "report/redact.h"
#include "report/words.h"

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

std::string cells(const CiFinding& entry) {
  const rules::Finding* finding = entry.finding;
  if (finding == nullptr) return fmt::format("{} | | | ", escape_markdown(entry.message));
  const rules::Requirement& requirement = finding->requirement;
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  std::string quantity = escape_markdown(quantity_words(requirement, entry.plane->kernel));
  if (!requirement.clause.empty()) quantity += ", " + escape_markdown(requirement.clause);
  const bool is_judged = finding->verdict != rules::Verdict::not_judged;
  return fmt::format("{} | {} | {} | {}", quantity, format_required(threshold, unit),
                     is_judged ? format_measured(finding->measured, unit, threshold) : "",
                     is_judged ? format_margin(finding->margin) : "");
}

std::string verdict_words(const CiFinding& entry) {
  const std::string words = rules::verdict_name(entry.verdict);
  if (entry.counts) return words;
  return words + (entry.finding->is_waived ? ", waived" : ", advice");
}

std::string table(const std::vector<CiFinding>& findings) {
  std::string text =
      "| verdict | where | quantity | required | measured | margin |\n"
      "| --- | --- | --- | ---: | ---: | ---: |\n";
  std::size_t rows = 0;
  for (const CiFinding& entry : findings) {
    if (++rows > kMostRows) break;
    text += fmt::format("| {} {} | {} | {} |\n", verdict_symbol(entry.verdict),
                        verdict_words(entry), escape_markdown(entry.place), cells(entry));
  }
  if (findings.size() > kMostRows) {
    text += fmt::format("\n{} more are left out here.\n", findings.size() - kMostRows);
  }
  return text;
}

}  // namespace

std::string render_markdown(const Document& document) {
  std::vector<CiFinding> passed, others;
  for (CiFinding& entry : ci_findings(document)) {
    (entry.verdict == rules::Verdict::pass ? passed : others).push_back(std::move(entry));
  }
  const rules::Verdict overall = overall_verdict(document);
  std::string text = fmt::format("### luxgate: {} {}\n\n{}\n", verdict_symbol(overall),
                                 outcome_words(document), summary_words(document));
  if (!others.empty()) text += "\n" + table(others);
  for (const ProjectPart& project : document.projects) {
    const std::vector<std::string> notes = ci_notes(project);
    if (notes.empty()) continue;
    text += fmt::format("\nNotes on {}:\n\n", escape_markdown(project.path));
    for (const std::string& note : notes) text += fmt::format("- {}\n", escape_markdown(note));
  }
  if (!passed.empty()) {
    text += fmt::format("\n<details>\n<summary>{} passed</summary>\n\n{}\n</details>\n",
                        passed.size(), table(passed));
  }
  if (const std::string words = redaction_words(document); !words.empty())
    text += "\n" + words + "\n";
  return text;
}

}  // namespace report
