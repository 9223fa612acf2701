#include "report/html/page/html_footnotes.h"

#include "calc/base/sentences.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace report {
namespace {

constexpr std::size_t kMostRooms = 12;  // that a footnote names

// Of "EN 12464-1:2021 [one public source]": what its remark would say; nothing of all else.
std::optional<calc::Sentence> source_behind(const calc::MessagePart& part) {
  if (part.kind != calc::PartKind::sentence || part.arguments.empty()) return {};
  if (part.id == calc::Sentence::one_source_of) return calc::Sentence::one_source;
  if (part.id == calc::Sentence::unverified_of) return calc::Sentence::unverified;
  return {};
}

NoteItem item_of(const Texts& t, const calc::Message& message) {
  NoteItem item{sentence_html(t, message)};
  const calc::MessagePart& first = message.parts().front();
  const bool is_source =
      first.kind == calc::PartKind::sentence &&
      (first.id == calc::Sentence::one_source || first.id == calc::Sentence::unverified);
  if (is_source && message.parts().size() == 1) item.source = first.id;
  return item;
}

struct NamedSource {
  calc::Sentence source;
  calc::Message name;
};

void add_sources(const calc::Message& message, std::vector<NamedSource>& sources) {
  for (const calc::MessagePart& part : message.parts()) {
    if (const auto source = source_behind(part))
      sources.push_back({*source, part.arguments.front()});
    for (const calc::Message& argument : part.arguments) add_sources(argument, sources);
  }
}

std::vector<NamedSource> sources_of(const calc::Message& message) {
  std::vector<NamedSource> sources;
  add_sources(message, sources);
  return sources;
}

void add_new(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

}  // namespace

std::vector<RoomPlane> planes_of(const ProjectPart& project) {
  std::vector<RoomPlane> planes;
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) planes.push_back({&space, &plane});
  }
  return planes;
}

std::vector<NoteItem> note_items(const Texts& t, const calc::Message& message) {
  std::vector<NoteItem> items;
  calc::Message one;
  const auto add = [&] {
    if (!one.empty()) items.push_back(item_of(t, one));
    one = {};
  };
  for (const calc::MessagePart& part : message.parts()) {
    if (part.kind == calc::PartKind::glue && part.text == "; ") {
      add();
    } else {
      one.parts().push_back(part);
    }
  }
  add();
  return items;
}

std::vector<NoteItem> note_items(const Texts& t, const rules::Finding& finding) {
  std::vector<NoteItem> items;
  for (const NotePart& part : note_parts(t, finding)) {
    if (part.is_mask) {
      const rules::Requirement& of = finding.requirement;
      std::string html = escape_html(t.say<Text::note_mask>(mask_name(t, of.mask.id)));
      if (!of.mask_words.empty()) html += t[Text::colon] + sentence_html(t, of.mask_words);
      items.push_back({std::move(html)});
    } else if (part.message.empty()) {
      items.push_back({escape_html(part.text)});
    } else {
      const std::vector<NoteItem> own = note_items(t, part.message);
      items.insert(items.end(), own.begin(), own.end());
    }
  }
  return items;
}

calc::Message without_source(const calc::Message& message) {
  calc::Message plain;
  for (const calc::MessagePart& part : message.parts()) {
    if (source_behind(part)) {
      plain += without_source(part.arguments.front());
      continue;
    }
    calc::MessagePart own = part;
    for (calc::Message& argument : own.arguments) argument = without_source(argument);
    plain.parts().push_back(std::move(own));
  }
  return plain;
}

std::vector<NoteItem> source_items(const Texts& t, const calc::Message& message) {
  std::vector<NoteItem> items;
  for (const NamedSource& of : sources_of(message))
    items.push_back(item_of(t, calc::Message::of(of.source, {})));
  return items;
}

void Footnotes::use(const NoteItem& item, const std::string& place, Uses& uses,
                    std::vector<std::string>& order) const {
  Use& known = uses[item.html];
  if (known.times++ == 0) {
    known.note.item = item;
    order.push_back(item.html);
  }
  add_new(known.note.places, place);
}

void Footnotes::add(const std::vector<RoomPlane>& planes) {
  Uses uses;
  std::vector<std::string> order;
  for (const RoomPlane& of : planes) {
    const std::string room = escape_html(title_of(of.space->name, of.space->id));
    for (const rules::Finding& finding : of.plane->findings) {
      const std::string clause =
          escape_html(sentence(t_, without_source(finding.requirement.clause)));
      for (const NoteItem& item : note_items(t_, finding)) {
        use(item, item.source ? clause : room, uses, order);
      }
    }
    for (const calc::Message& remark : of.plane->remarks) {
      for (const NoteItem& item : note_items(t_, remark)) use(item, room, uses, order);
    }
    for (const NamedSource& source : sources_of(of.plane->grid.rule)) {
      use(item_of(t_, calc::Message::of(source.source, {})),
          t_.say<Text::source_of_grid>(escape_html(sentence(t_, source.name))), uses, order);
    }
  }
  for (const std::string& html : order) {
    Use& one = uses[html];
    const auto known = numbers_.find(html);
    if (known == numbers_.end() && one.times < 2) continue;
    if (known == numbers_.end()) {
      numbers_[html] = notes_.size();
      notes_.push_back(std::move(one.note));
    } else {
      Note& note = notes_[known->second];
      for (const std::string& place : one.note.places) add_new(note.places, place);
    }
  }
}

std::string Footnotes::inline_html(const std::vector<NoteItem>& items) const {
  std::string html;
  for (const NoteItem& item : items) {
    if (!has(item)) html += (html.empty() ? "" : "; ") + item.html;
  }
  return html;
}

std::string Footnotes::marks(const std::vector<NoteItem>& items) const {
  std::vector<std::size_t> numbers;
  for (const NoteItem& item : items) {
    if (const auto known = numbers_.find(item.html); known != numbers_.end())
      numbers.push_back(known->second + 1);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::string html;
  for (const std::size_t number : numbers)
    html += fmt::format("{}<a href=\"#note{}\">{}</a>", html.empty() ? "" : " ", number, number);
  return html.empty() ? "" : "<sup class=\"marks\">" + html + "</sup>";
}

std::string Footnotes::list() const {
  if (notes_.empty()) return {};
  std::string items;
  for (std::size_t i = 0; i < notes_.size(); ++i) {
    const Note& note = notes_[i];
    std::string words = note.item.html;
    if (note.item.source) {
      const std::string places = fmt::format("{}", fmt::join(note.places, ", "));
      words = *note.item.source == calc::Sentence::one_source ? t_.say<Text::one_source_is>(places)
                                                              : t_.say<Text::unverified_is>(places);
    } else if (note.places.size() <= kMostRooms) {
      words += fmt::format(" <span class=\"quiet\">({})</span>", fmt::join(note.places, ", "));
    }
    items += fmt::format("<li id=\"note{}\">{}</li>\n", i + 1, words);
  }
  return fmt::format("<h3 id=\"notes\">{}</h3>\n<ol class=\"footnotes\">\n{}</ol>\n",
                     t_[Text::footnotes], items);
}

}  // namespace report
