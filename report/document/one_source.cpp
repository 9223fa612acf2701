#include "report/document/one_source.h"

#include "calc/base/sentences.h"
#include "report/document/document.h"

#include <algorithm>
#include <string>
#include <utility>

namespace report {
namespace {

using calc::Sentence;

bool is_sentence(const calc::MessagePart& part, Sentence id) {
  return part.kind == calc::PartKind::sentence && part.id == id;
}

bool has_mark(const calc::Message& message) {
  return std::any_of(message.parts().begin(), message.parts().end(),
                     [](const calc::MessagePart& part) {
                       return is_sentence(part, Sentence::one_source) ||
                              is_sentence(part, Sentence::one_source_of) ||
                              std::any_of(part.arguments.begin(), part.arguments.end(), has_mark);
                     });
}

// Between two remarks.
bool separates(const calc::MessagePart& part) {
  return part.kind == calc::PartKind::glue && part.text == "; ";
}

void add_marked(const calc::Message& clause, const calc::Message& note, const std::string& id,
                std::vector<calc::Message>& rows) {
  if (!rests_on_one_source(clause, note)) return;
  calc::Message row = clause.empty() ? calc::Message::words(id) : without_one_source(clause);
  if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
}

}  // namespace

bool rests_on_one_source(const calc::Message& clause, const calc::Message& note) {
  return has_mark(clause) || has_mark(note);
}

calc::Message without_one_source(const calc::Message& message) {
  if (!has_mark(message)) return message;
  calc::Message rest;
  std::vector<calc::MessagePart>& parts = rest.parts();
  for (const calc::MessagePart& part : message.parts()) {
    if (is_sentence(part, Sentence::one_source)) {
      if (!parts.empty() && separates(parts.back())) parts.pop_back();
      continue;
    }
    if (separates(part) && parts.empty()) continue;
    if (is_sentence(part, Sentence::one_source_of)) {
      rest += without_one_source(part.arguments.front());
      continue;
    }
    calc::MessagePart own = part;
    for (calc::Message& argument : own.arguments) argument = without_one_source(argument);
    parts.push_back(std::move(own));
  }
  return rest;
}

void add_one_source_row(const rules::Requirement& requirement, std::vector<calc::Message>& rows) {
  if (requirement.severity == rules::Severity::advice) return;  // no verdict rests on it
  add_marked(requirement.clause, requirement.note, requirement.id, rows);
}

void add_one_source_rows(const ProjectPart& project, std::vector<calc::Message>& rows) {
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings)
        add_one_source_row(finding.requirement, rows);
    }
  }
  for (const rules::AggregateFinding& finding : project.aggregates) {
    if (finding.sum) {
      add_one_source_row(finding.sum->requirement, rows);
    } else {
      add_marked(finding.clause, finding.note, finding.id, rows);
    }
  }
}

std::vector<std::string> one_source_names(const Totals& totals) {
  std::vector<std::string> names;
  for (const calc::Message& row : totals.one_source_rows) names.push_back(row.english());
  return names;
}

}  // namespace report
