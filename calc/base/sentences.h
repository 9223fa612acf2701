#pragma once
// The sentences of messages, see message.h: all text that is translated comes from this table.

#include "calc/base/message.h"

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace calc {

enum class Sentence : std::uint16_t {
#define SENTENCE(id, text) id,
#include "calc/base/sentences.def"
#undef SENTENCE
};

// English texts in the order of Sentence. No std::array{...}: see report/text/texts.h.
inline constexpr auto kSentences = std::to_array<std::string_view>({
#define SENTENCE(id, text) text,
#include "calc/base/sentences.def"
#undef SENTENCE
});

// Return "one-source" for one_source, as in result files, and the inverse; empty for unknown names.
std::string sentence_name(Sentence id);
std::optional<Sentence> sentence_from_name(std::string_view name);

// The text of a sentence around its placeholders: one literal more than placeholders.
struct SentenceTemplate {
  struct Placeholder {
    std::size_t argument = 0;  // in the order of the English text
    std::string_view format;   // "{:.4g}"
  };
  std::vector<std::string_view> literals;
  std::vector<Placeholder> placeholders;
};
// Splits a text with the placeholders of fmt: {} in their order or {1} by their number.
SentenceTemplate sentence_template(std::string_view text);
const SentenceTemplate& english_template(Sentence id);

namespace message_detail {

// The type as which fmt checks an argument against the text.
template <class T>
using Checked = std::conditional_t<std::is_arithmetic_v<T>, T, std::string_view>;

template <class T>
Message argument(Sentence id, std::size_t place, const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return Message::number(fmt::vformat(english_template(id).placeholders[place].format,
                                        fmt::make_format_args(value)));
  } else if constexpr (std::same_as<T, Message>) {
    return value;
  } else {
    return Message::words(std::string(value));
  }
}

template <class... Args, std::size_t... Places>
Message say(Sentence id, std::index_sequence<Places...>, const Args&... args) {
  return Message::of(id, {argument(id, Places, args)...});
}

}  // namespace message_detail

// Returns a sentence with its placeholders filled in: with numbers, in the format of the English
// text, with names or texts of users, and with messages. The compiler checks the arguments against
// the English text.
template <Sentence id, class... Args>
Message say(const Args&... args) {
  static_cast<void>(fmt::format_string<const message_detail::Checked<std::decay_t<Args>>&...>(
      kSentences[static_cast<std::size_t>(id)]));
  return message_detail::say(id, std::index_sequence_for<Args...>(), args...);
}

}  // namespace calc
