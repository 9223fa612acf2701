#include "report/text/about_words.h"

#include "report/text/plain_text.h"

#include <array>
#include <cstddef>

namespace report {
namespace {

// In the order of the texts.
constexpr std::array kNames{Text::about_client,  Text::about_number, Text::about_revision,
                            Text::about_date,    Text::about_author, Text::about_company,
                            Text::about_address, Text::about_note};
static_assert(kNames.size() == calc::kAboutTexts.size());

}  // namespace

std::vector<AboutWords> about_words(const Texts& t, const calc::AboutProject& about) {
  std::vector<AboutWords> said;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const std::string& text = about.*calc::kAboutTexts[i].text;
    if (!text.empty()) said.push_back({t[kNames[i]], printable(text)});
  }
  return said;
}

std::string about_line(const Texts& t, const calc::AboutProject& about) {
  std::string line;
  for (const AboutWords& one : about_words(t, about)) {
    line += (line.empty() ? "" : " · ") + std::string(one.name) + t[Text::colon] + one.words;
  }
  return line;
}

}  // namespace report
