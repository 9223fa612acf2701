#include "report/result_file/message_json.h"

#include "calc/base/names.h"
#include "calc/base/sentences.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace calc {

template <>
struct EnumNames<PartKind> {
  static constexpr EnumName<PartKind> list[] = {{PartKind::glue, "glue"},
                                                {PartKind::sentence, "id"},
                                                {PartKind::number, "number"},
                                                {PartKind::path, "path"},
                                                {PartKind::words, "words"}};
};

}  // namespace calc

namespace report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepest = 32;  // messages in messages; a file must not end the program

// Empty: it is of a later version of the program.
std::optional<calc::Message> read_parts(const JsonCursor& at, int depth);

std::optional<calc::MessagePart> read_part(const JsonCursor& at, int depth) {
  for (const auto& kind : calc::EnumNames<calc::PartKind>::list) {
    const std::optional<JsonCursor> text = at.find(kind.name);
    if (!text) continue;
    calc::MessagePart part;
    part.kind = kind.value;
    if (part.kind != calc::PartKind::sentence) {
      part.text = text->text();
      return part;
    }
    const std::optional<calc::Sentence> id = calc::sentence_from_name(text->text());
    if (!id) return std::nullopt;
    part.id = *id;
    const JsonCursor arguments = at["arguments"];
    for (const JsonCursor& argument : arguments.items()) {
      std::optional<calc::Message> one = read_parts(argument, depth + 1);
      if (!one) return std::nullopt;
      part.arguments.push_back(std::move(*one));
    }
    // Another version may say the same of other things.
    if (part.arguments.size() != calc::english_template(*id).placeholders.size())
      return std::nullopt;
    return part;
  }
  return std::nullopt;
}

std::optional<calc::Message> read_parts(const JsonCursor& at, int depth) {
  if (depth > kDeepest) at.refuse("the message is too deep");
  calc::Message message;
  for (const JsonCursor& item : at.items()) {
    std::optional<calc::MessagePart> part = read_part(item, depth);
    if (!part) return std::nullopt;
    message.parts().push_back(std::move(*part));
  }
  return message;
}

}  // namespace

bool has_parts(const calc::Message& message) {
  return std::any_of(
      message.parts().begin(), message.parts().end(),
      [](const calc::MessagePart& part) { return part.kind != calc::PartKind::words; });
}

bool has_parts(const std::vector<calc::Message>& messages) {
  return std::any_of(messages.begin(), messages.end(),
                     [](const calc::Message& message) { return has_parts(message); });
}

Json message_json(const calc::Message& message) {
  Json parts = Json::array();
  for (const calc::MessagePart& part : message.parts()) {
    const bool is_sentence = part.kind == calc::PartKind::sentence;
    Json json = {
        {calc::name_of(part.kind), is_sentence ? calc::sentence_name(part.id) : part.text}};
    if (is_sentence) json["arguments"] = message_json(part.arguments);
    parts.push_back(std::move(json));
  }
  return parts;
}

Json message_json(const std::vector<calc::Message>& messages) {
  Json list = Json::array();
  for (const calc::Message& message : messages) list.push_back(message_json(message));
  return list;
}

calc::Message read_message(const JsonCursor& at, const std::optional<JsonCursor>& parts) {
  const std::string text = at.text();
  std::optional<calc::Message> message;
  if (parts) message = read_parts(*parts, 0);
  // Who has edited the text, or reads it after another wording, must find it.
  const std::string said = message ? message->english() : "";
  return message && said == text ? *std::move(message) : calc::Message::words(text);
}

std::vector<calc::Message> read_messages(const JsonCursor& at,
                                         const std::optional<JsonCursor>& parts) {
  std::vector<calc::Message> messages;
  const std::vector<JsonCursor> texts = at.items();
  std::vector<JsonCursor> all;
  if (parts) all = parts->items();
  const bool is_of_each = all.size() == texts.size();  // else somebody has edited the texts
  for (std::size_t i = 0; i < texts.size(); ++i) {
    messages.push_back(read_message(texts[i], is_of_each ? std::optional(all[i]) : std::nullopt));
  }
  return messages;
}

Json message_part_schema() {
  const Json message = {{"type", "array"}, {"items", {{"$ref", "#/definitions/message_part"}}}};
  Json properties = Json::object();
  for (const auto& kind : calc::EnumNames<calc::PartKind>::list)
    properties[std::string(kind.name)] = {{"type", "string"}};
  properties["arguments"] = {{"type", "array"}, {"items", message}};
  return {{"type", "object"},
          {"description",
           "One key and its text: the id of a sentence of the program, with arguments that are "
           "messages, punctuation between sentences, a number with its unit, a path, or words of "
           "people."},
          {"properties", properties}};
}

}  // namespace report
