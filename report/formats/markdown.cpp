#include "report/formats/markdown.h"

#include "report/formats/ci_finding.h"
#include "report/revision/gate.h"
#include "report/revision/revision_tables.h"
#include "report/text/about_words.h"
#include "report/text/advice_words.h"
#include "report/text/aggregate_words.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/one_source_note.h"
#include "report/text/room_causes.h"
#include "report/text/room_notes.h"
#include "report/text/room_overview.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
    if (!aggregate->clause.empty()) words += ", " + clause_words(t, *aggregate);
    if (const std::string note = aggregate_note(t, *aggregate); !note.empty()) words += "; " + note;
    if (!aggregate->reason.empty()) words += "; " + sentence(t, aggregate->reason);
    const bool has_margin = aggregate->sum && aggregate->verdict != rules::Verdict::not_judged;
    return fmt::format("{} | {} | {} | {}", escape_markdown(words),
                       escape_markdown(aggregate_required(t, *aggregate)),
                       escape_markdown(aggregate_measured(t, *aggregate)),
                       has_margin ? format_margin(t, aggregate->sum->margin) : "");
  }
  if (finding == nullptr) return fmt::format("{} | | | ", escape_markdown(entry.message));
  const rules::Requirement& requirement = finding->requirement;
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  std::string quantity = escape_markdown(quantity_words(t, requirement, entry.plane->kernel) +
                                         scene_words(t, requirement));
  if (!requirement.clause.empty()) quantity += ", " + escape_markdown(clause_words(t, requirement));
  if (const std::string note = note_words(t, *finding); !note.empty()) {
    quantity += " (" + escape_markdown(note) + ")";
  }
  if (!finding->reason.empty()) quantity += ": " + escape_markdown(sentence(t, finding->reason));
  const bool is_judged = finding->verdict != rules::Verdict::not_judged;
  return fmt::format("{} | {} | {} | {}", quantity, format_required(t, threshold, unit),
                     is_judged ? measured_words(t, *finding) : "",
                     is_judged ? margin_words(t, *finding) : "");
}

// Advice that is not kept to is no failure, and must not look like one.
bool is_unkept_advice(const CiFinding& entry) {
  return entry.finding != nullptr && is_outside_advice(*entry.finding);
}

bool is_advice(const CiFinding& entry) {
  return entry.finding != nullptr && entry.finding->requirement.severity == rules::Severity::advice;
}

std::string entry_words(const Texts& t, const CiFinding& entry) {
  if (is_unkept_advice(entry)) return t[Text::advice_outside];
  const char* words = verdict_words(t, entry.verdict);
  if (entry.counts) return words;
  if (entry.is_known) return t.say<Text::verdict_known>(words);
  if (is_waived(entry)) return t.say<Text::verdict_waived>(words);
  const bool is_member = entry.finding != nullptr &&
                         entry.finding->requirement.severity == rules::Severity::in_aggregate;
  return is_member ? t.say<Text::verdict_in_aggregate>(words) : t.say<Text::verdict_advice>(words);
}

// Of findings, in the order that they come.
class Table {
 public:
  // has_projects: the first column says which project it is.
  Table(const Texts& t, bool has_projects) : t_(t), has_projects_(has_projects) {}

  void add(const CiFinding& entry) {
    if (++count_ > kMostRows) return;
    if (has_projects_) rows_ += fmt::format("| {} ", escape_markdown(entry.project->path));
    rows_ += fmt::format("| {} {} | {} | {} |\n",
                         is_unkept_advice(entry) ? outcome_symbol(rules::Outcome::nothing_asked)
                                                 : verdict_symbol(entry.verdict),
                         entry_words(t_, entry), escape_markdown(entry.place), cells(t_, entry));
  }

  std::size_t count() const { return count_; }

  std::string text() const {
    std::string text;
    if (has_projects_) text += std::string("| ") + t_[Text::markdown_project] + " ";
    text += std::string(t_[Text::markdown_head]) + "\n";
    text += has_projects_ ? "| --- " : "";
    text += "| --- | --- | --- | ---: | ---: | ---: |\n" + rows_;
    if (count_ > kMostRows) {
      text += "\n" + t_.say<Text::more_left_out>(count_ - kMostRows) + "\n";
    }
    return text;
  }

 private:
  Texts t_;
  bool has_projects_;
  std::size_t count_ = 0;
  std::string rows_;  // the first ones
};

// What a project came to: two variants of a design have the same rooms and planes.
std::string project_line(const Texts& t, const ProjectPart& project) {
  const rules::Outcome outcome = outcome_of(project);
  std::string text = fmt::format("- {} {}: {}", outcome_symbol(outcome), outcome_words(t, outcome),
                                 escape_markdown(project.path));
  if (!project.name.empty()) text += ", " + escape_markdown(project.name);
  const std::string about = about_line(t, project.about);
  if (!about.empty()) text += "; " + escape_markdown(about);
  return text + "\n";
}

// ": My first project (project.xml)"
std::string title_of(const ProjectPart& project) {
  const std::string path = escape_markdown(project.path);
  return project.name.empty() ? ": " + path
                              : fmt::format(": {} ({})", escape_markdown(project.name), path);
}

std::string details(const std::string& summary, const std::string& text) {
  return fmt::format("\n<details>\n<summary>{}</summary>\n\n{}\n</details>\n", summary, text);
}

// folds: of several rooms what is long waits behind its title and its number of lines.
std::string list_below(const std::string& title, std::size_t count, const std::string& text,
                       bool folds) {
  return folds ? details(fmt::format("{} {}", title, count), text) : "\n" + title + "\n\n" + text;
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
  const bool folds = has_overview(project) && project.strict_warnings.empty();
  return list_below(t.say<Text::warnings_on>(escape_markdown(project.path)), count, text, folds);
}

std::string notes(const Texts& t, const ProjectPart& project) {
  const std::vector<std::string> list = ci_notes(project, t);
  if (list.empty()) return {};
  std::string text;
  for (const std::string& note : list) text += fmt::format("- {}\n", escape_markdown(note));
  return list_below(t.say<Text::notes_on>(escape_markdown(project.path)), list.size(), text,
                    has_overview(project));
}

std::string advice_markdown(const Texts& t, const ProjectPart& project) {
  if (!has_advice(project)) return {};
  std::string text =
      fmt::format("\n**{}**: {}\n\n", t[Text::advice_title], escape_markdown(project.path));
  if (project.advice->empty()) text += std::string("- ") + t[Text::advice_nothing] + "\n";
  for (const LevelAdvice& advice : *project.advice) {
    text += fmt::format("- {}{}{}\n", escape_markdown(advice_scene(t, advice)), t[Text::colon],
                        escape_markdown(advice_outcome(t, advice)));
    for (const AdviceRow& row : advice_rows(t, advice)) {
      text += fmt::format("  - {}{}{} → {}\n", escape_markdown(row.group), t[Text::colon], row.now,
                          row.advised);
    }
    for (const AdviceList& list : advice_lists(t, project, advice)) {
      text += fmt::format("  - {}\n", list.title);
      for (const std::string& item : list.items) {
        text += fmt::format("    - {}\n", escape_markdown(item));
      }
    }
  }
  return text;
}

// Viewers cut blanks at the start of a cell.
constexpr const char* kAreaIndent = "&emsp;";

// The first rows of it, at most so many; no room without the lines of its tasks.
std::size_t rows_within(const RoomOverview& table, std::size_t most) {
  if (table.rows.size() <= most) return table.rows.size();
  std::size_t count = most;
  while (count > 0 && table.rows[count].is_area) --count;
  return count;
}

// "" = of a single room.
std::string overview_markdown(const Texts& t, const ProjectPart& project) {
  const RoomOverview table = room_overview(t, project);
  if (table.rows.empty()) return {};
  const auto line = [](const std::vector<std::string>& cells) {  // escaped
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::vector<std::string> head = table.head;
  for (std::string& cell : head) cell = escape_markdown(cell);
  std::string text = "\n" + line(head) + "|";
  for (std::size_t c = 0; c < table.head.size(); ++c)
    text += table.is_number(c) ? " ---: |" : " --- |";
  text += "\n";
  const std::size_t shown = rows_within(table, kMostRows);
  for (std::size_t k = 0; k < shown; ++k) {
    std::vector<std::string> cells = table.rows[k].cells;
    for (std::string& cell : cells) cell = escape_markdown(cell);
    if (table.rows[k].is_area) cells[1] = kAreaIndent + cells[1];
    text += line(cells);
  }
  const auto left_out =
      std::count_if(table.rows.begin() + static_cast<std::ptrdiff_t>(shown), table.rows.end(),
                    [](const RoomOverview::Row& row) { return !row.is_area; });
  if (left_out > 0) text += "\n" + t.say<Text::more_left_out>(left_out) + "\n";
  return text;
}

// Why rooms do not pass, each cause once.
std::string causes_markdown(const Texts& t, const ProjectPart& project) {
  std::string text;
  for (const CauseBlock& block : cause_blocks(t, project)) {
    text += fmt::format("\n**{}**\n\n", block.title);
    std::size_t count = 0;
    for (const CauseEntry& entry : block.entries) {
      if (++count > kMostRows) continue;
      text +=
          fmt::format("- {}\n", escape_markdown(fmt::format("{}", fmt::join(entry.rooms, ", "))));
      for (const CauseWords& cause : entry.causes) {
        text += fmt::format("  - {}", escape_markdown(cause.what));
        for (const std::string& more : cause.more) text += "; " + escape_markdown(more);
        text += "\n";
      }
    }
    if (count > kMostRows) text += "\n" + t.say<Text::more_left_out>(count - kMostRows) + "\n";
  }
  return text;
}

// What weakens results of several rooms; how they were come by is among the folded notes.
std::string doubts_markdown(const Texts& t, const ProjectPart& project) {
  std::string text;
  for (const RoomNote& note : room_notes(t, project, true)) {
    if (!note.is_method) text += fmt::format("- {}\n", escape_markdown(note_line(t, note)));
  }
  return text.empty() ? text : fmt::format("\n**{}**\n\n{}", t[Text::notes_once], text);
}

class MarkdownWriter : public FormatWriter {
 public:
  MarkdownWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t)
      : frame_(frame),
        t_(t),
        findings_(frame, t),
        passed_(t, has_projects()),
        others_(t, has_projects()),
        unkept_(t, has_projects()),
        causes_(place),
        advice_(place),
        warnings_(place),
        notes_(place) {}

  void add(const ProjectPart& project) override {
    for (const CiFinding& entry : findings_.of(project)) {
      Table& open = is_advice(entry) ? unkept_ : others_;
      (entry.verdict == rules::Verdict::pass ? passed_ : open).add(entry);
    }
    if (!has_projects()) {
      about_ = about_line(t_, project.about);
      title_ = title_of(project);
      overview_ = overview_markdown(t_, project);
    }
    if (has_overview(project)) causes_.write(causes(project));
    // Of many the passing ones are folded: what is left to do must not be looked for.
    const bool is_folded =
        frame_.paths.size() > kMostListed && outcome_of(project) == rules::Outcome::pass;
    Lines& lines = is_folded ? folded_lines_ : project_lines_;
    if (lines.count++ < kMostProjects) lines.text += project_line(t_, project);
    advice_.write(advice_markdown(t_, project));
    warnings_.write(warnings(t_, project));
    notes_.write(notes(t_, project));
  }

  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  static constexpr std::size_t kMostListed = 10, kMostProjects = 50;
  // Of the first ones.
  struct Lines {
    std::string text;
    std::size_t count = 0;

    std::string with_rest(const Texts& t) const {
      if (count <= kMostProjects) return text;
      return text + "\n" + t.say<Text::more_left_out>(count - kMostProjects) + "\n";
    }
  };
  bool has_projects() const { return frame_.paths.size() > 1; }

  // Of several rooms.
  std::string causes(const ProjectPart& project) const {
    const std::string text = causes_markdown(t_, project) + doubts_markdown(t_, project);
    if (!has_projects() || text.empty()) return text;
    return "\n#### " + escape_markdown(project.path) + "\n" + text;
  }

  const DocumentFrame& frame_;
  Texts t_;
  CiFindings findings_;
  Table passed_, others_, unkept_;  // unkept: advice that does not pass
  Lines project_lines_, folded_lines_;
  std::string title_, about_, overview_;      // of the only one
  Spill causes_, advice_, warnings_, notes_;  // of all projects
};

void MarkdownWriter::finish(const DocumentEnd& end, Sink& sink) {
  const rules::Outcome outcome =
      frame_.revised == nullptr ? end.totals.outcome : gate_outcome(*frame_.revised);
  std::string text = fmt::format("### luxgate: {} {}{}\n\n{}\n", outcome_symbol(outcome),
                                 outcome_words(t_, outcome), title_, summary_words(t_, end.totals));
  Provenance remarked = end.provenance;
  if (const std::string part = selection_words(remarked, t_); !part.empty()) {
    text += "\n**" + escape_markdown(part) + "**\n";
    remarked.selection.clear();
  }
  for (const calc::Diagnostic& error : document_errors(end)) {
    text += "\n**" + escape_markdown(calc::format_diagnostic(error)) + "**\n";
  }
  if (!about_.empty()) text += "\n" + escape_markdown(about_) + "\n";
  if (frame_.revised != nullptr) text += render_revision_markdown(t_, *frame_.revised);
  text += overview_;
  if (has_projects() && project_lines_.count > 0) text += "\n" + project_lines_.with_rest(t_);
  sink.write(text);
  causes_.copy_to(sink);
  text.clear();
  if (others_.count() > 0) {
    text += overview_.empty()
                ? "\n" + others_.text()
                : details(t_.say<Text::unmet_one_by_one>(others_.count()), others_.text());
  }
  if (unkept_.count() > 0)
    text += details(t_.say<Text::advice_one_by_one>(unkept_.count()), unkept_.text());
  sink.write(text);
  advice_.copy_to(sink);
  warnings_.copy_to(sink);
  notes_.copy_to(sink);
  text.clear();
  if (passed_.count() > 0) {
    const std::string folded =
        folded_lines_.count > 0 ? folded_lines_.with_rest(t_) + "\n" : std::string();
    text += details(t_.say<Text::passed>(passed_.count()), folded + passed_.text());
  }
  if (const std::string note = one_source_note(t_, end.totals.one_source_rows); !note.empty())
    text += "\n" + escape_markdown(note) + "\n";
  if (const std::string words = provenance_remarks(remarked, t_); !words.empty())
    text += "\n" + words + "\n";
  sink.write(text);
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

std::unique_ptr<FormatWriter> markdown_writer(const DocumentFrame& frame, const SpillPlace& place,
                                              const Texts& t) {
  return std::make_unique<MarkdownWriter>(frame, place, t);
}

}  // namespace report
