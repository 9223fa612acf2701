#include "calc/base/message.h"

#include "calc/base/sentences.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

namespace calc {
namespace {

// In the order of Sentence.
constexpr auto kIds = std::to_array<std::string_view>({
#define SENTENCE(id, text) #id,
#include "calc/base/sentences.def"
#undef SENTENCE
});

Message of_one(PartKind kind, std::string text) {
  Message message;
  if (!text.empty()) message.parts().push_back({kind, {}, std::move(text), {}});
  return message;
}

void add_english(const Message& message, std::string& text) {
  for (const MessagePart& part : message.parts()) {
    text += part.text;
    if (part.kind != PartKind::sentence) continue;
    const SentenceTemplate& own = english_template(part.id);
    text += own.literals.front();
    for (std::size_t i = 0; i < own.placeholders.size(); ++i) {
      add_english(part.arguments[own.placeholders[i].argument], text);
      text += own.literals[i + 1];
    }
  }
}

}  // namespace

std::string sentence_name(Sentence id) {
  std::string name(kIds[static_cast<std::size_t>(id)]);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::optional<Sentence> sentence_from_name(std::string_view name) {
  std::string id(name);
  std::replace(id.begin(), id.end(), '-', '_');
  const auto found = std::find(kIds.begin(), kIds.end(), id);
  if (found == kIds.end()) return std::nullopt;
  return static_cast<Sentence>(found - kIds.begin());
}

Message Message::number(std::string text) { return of_one(PartKind::number, std::move(text)); }
Message Message::path(std::string text) { return of_one(PartKind::path, std::move(text)); }
Message Message::words(std::string text) { return of_one(PartKind::words, std::move(text)); }

Message Message::of(Sentence id, std::vector<Message> arguments) {
  Message message;
  message.parts_.push_back({PartKind::sentence, id, {}, std::move(arguments)});
  return message;
}

Message& Message::operator+=(const Message& other) {
  const std::vector<MessagePart> added = other.parts_;  // it may be this one
  parts_.insert(parts_.end(), added.begin(), added.end());
  return *this;
}

Message& Message::operator+=(Glue glue) {
  parts_.push_back({PartKind::glue, {}, std::string(glue.text()), {}});
  return *this;
}

Message operator+(Glue a, const Message& b) {
  Message sum;
  sum += a;
  return sum += b;
}

std::string Message::english() const {
  std::string text;
  add_english(*this, text);
  return text;
}

std::strong_ordering operator<=>(const Message& a, const Message& b) {
  const auto compare = [](const MessagePart& x, const MessagePart& y) -> std::strong_ordering {
    return std::tie(x.kind, x.id, x.text, x.arguments) <=>
           std::tie(y.kind, y.id, y.text, y.arguments);
  };
  return std::lexicographical_compare_three_way(a.parts().begin(), a.parts().end(),
                                                b.parts().begin(), b.parts().end(), compare);
}

bool operator==(const Message& a, const Message& b) { return (a <=> b) == 0; }

bool says(const Message& message, Sentence id) {
  const auto is_it = [id](const MessagePart& part) {
    return part.kind == PartKind::sentence && part.id == id;
  };
  return std::any_of(message.parts().begin(), message.parts().end(), is_it);
}

void append(Message& to, const Message& next, Glue separator) {
  if (next.empty()) return;
  if (!to.empty()) to += separator;
  to += next;
}

Message joined(const std::vector<Message>& messages, Glue separator) {
  Message all;
  for (const Message& one : messages) append(all, one, separator);
  return all;
}

Message listed(const std::vector<Message>& messages, std::size_t most) {
  const std::size_t told = std::min(messages.size(), most);
  Message list;
  for (std::size_t i = 0; i < told; ++i) append(list, messages[i], ", ");
  return messages.size() > told ? say<Sentence::and_more>(list, messages.size() - told) : list;
}

Message names_message(const std::vector<std::string>& names, std::size_t most) {
  std::vector<Message> messages;
  std::transform(names.begin(), names.end(), std::back_inserter(messages), Message::words);
  return listed(messages, most);
}

SentenceTemplate sentence_template(std::string_view text) {
  SentenceTemplate parts;
  for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{')) {
    const std::size_t close = text.find('}', open);
    const std::string_view format = text.substr(open, close + 1 - open);
    std::size_t argument = parts.placeholders.size();
    if (format[1] >= '0' && format[1] <= '9') argument = static_cast<std::size_t>(format[1] - '0');
    parts.literals.push_back(text.substr(0, open));
    parts.placeholders.push_back({argument, format});
    text.remove_prefix(close + 1);
  }
  parts.literals.push_back(text);
  return parts;
}

const SentenceTemplate& english_template(Sentence id) {
  static const std::vector<SentenceTemplate> kTemplates = [] {
    std::vector<SentenceTemplate> all;
    std::transform(kSentences.begin(), kSentences.end(), std::back_inserter(all),
                   sentence_template);
    return all;
  }();
  return kTemplates[static_cast<std::size_t>(id)];
}

}  // namespace calc
