#pragma once
// What results say in words: why a verdict, how a grid, from where a plane. In English wherever
// data are kept; report/text/sentences.h has them in the reader's language, so what is to be
// translated is said with these templates and in no other way.

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace calc {

enum class Sentence : std::uint16_t {
#define SENTENCE(id, text) id,
#include "calc/base/sentences.def"
#undef SENTENCE
};

// In the order of Sentence. No std::array{...}: see report/text/texts.h.
inline constexpr auto kSentences = std::to_array<std::string_view>({
#define SENTENCE(id, text) text,
#include "calc/base/sentences.def"
#undef SENTENCE
});

// Its placeholders filled in. The compiler holds the text against the arguments.
template <Sentence id, class... Args>
std::string say(const Args&... args) {
  return fmt::format(fmt::format_string<const Args&...>(kSentences[static_cast<std::size_t>(id)]),
                     args...);
}

}  // namespace calc
