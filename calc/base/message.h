#pragma once
// Texts of results: the reason of a verdict, the origin of a grid or plane. A message is kept as
// its parts: sentences by their ids with their arguments, numbers, names, paths and texts of users.
// It becomes text only for a reader, in English here and in other languages by
// report/text/sentences.h. Code that makes messages includes calc/base/sentences.h.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace calc {

enum class Sentence : std::uint16_t;  // see calc/base/sentences.h

// Punctuation that joins messages: "; ", ", ", " (", ")". The compiler refuses letters and digits,
// so that all words come from sentences.def.
class Glue {
 public:
  template <std::size_t N>
  consteval Glue(const char (&text)[N]) : text_(text, N - 1) {  // not explicit: a literal is one
    for (const char c : text_) {
      const bool is_word =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (is_word) throw "words are said with sentences.def";
    }
  }
  std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

// Kinds of the parts of a message.
enum class PartKind : std::uint8_t {
  glue,      // text: punctuation
  sentence,  // id and arguments
  number,    // text: numbers with units and signs, with decimal points
  path,      // text: of a file or folder
  words,     // text: names, and what people have written, to the letter
};

struct MessagePart;

// A text as a value; it may be empty. Members that need complete parts are defined below them.
class Message {
 public:
  Message();
  Message(const Message& other);
  Message(Message&& other) noexcept;
  Message& operator=(const Message& other);
  Message& operator=(Message&& other) noexcept;
  ~Message();
  static Message number(std::string text);
  static Message path(std::string text);
  static Message words(std::string text);  // "" is an empty message
  static Message of(Sentence id, std::vector<Message> arguments);

  bool empty() const;
  const std::vector<MessagePart>& parts() const { return parts_; }
  std::vector<MessagePart>& parts() { return parts_; }

  Message& operator+=(const Message& other);
  Message& operator+=(Glue glue);
  friend Message operator+(Message a, const Message& b) { return std::move(a += b); }
  friend Message operator+(Message a, Glue b) { return std::move(a += b); }
  friend Message operator+(Glue a, const Message& b);

  // Returns the text in English, for reports in that language and for logs.
  std::string english() const;

 private:
  std::vector<MessagePart> parts_;
};

struct MessagePart {
  PartKind kind = PartKind::words;
  Sentence id{};     // of a sentence
  std::string text;  // of all others
  std::vector<Message> arguments;
};

inline Message::Message() = default;
inline Message::Message(const Message& other) = default;
inline Message::Message(Message&& other) noexcept = default;
inline Message& Message::operator=(const Message& other) = default;
inline Message& Message::operator=(Message&& other) noexcept = default;
inline Message::~Message() = default;
inline bool Message::empty() const { return parts_.empty(); }

// Orders messages by their content; the order itself has no meaning.
std::strong_ordering operator<=>(const Message& a, const Message& b);
bool operator==(const Message& a, const Message& b);

// Returns whether a sentence of the message itself, not of an argument, has this id.
bool says(const Message& message, Sentence id);

// Appends `next`, after the separator where `to` is not empty. An empty `next` adds nothing.
void append(Message& to, const Message& next, Glue separator = "; ");
// Joins all messages that are not empty.
Message joined(const std::vector<Message>& messages, Glue separator);
// Returns "a, b, c and 3 more" with at most `most` messages.
Message listed(const std::vector<Message>& messages, std::size_t most);
Message names_message(const std::vector<std::string>& names, std::size_t most);

}  // namespace calc
