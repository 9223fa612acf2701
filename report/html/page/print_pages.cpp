#include "report/html/page/print_pages.h"

#include "calc/base/utf8.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>

namespace report {
namespace {

// Heads and feet are one line.
constexpr std::size_t kLongestHead = 55, kLongestFoot = 90;

std::string line(std::string_view text, std::size_t most) {
  return css_string(calc::shorten_utf8(printable(text), most));
}

std::string box(const char* place, const std::string& content) {
  return fmt::format("@{} {{ content: {}; }}\n", place, content);
}

}  // namespace

std::string css_string(std::string_view text) {
  std::string safe = "\"";
  for (const char c : printable(text)) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == ' ' || c == '.' || c == ',' || c == '-' ||
                          static_cast<unsigned char>(c) >= 0x80U;
    // The blank belongs to the escape.
    safe += is_plain ? std::string(1, c)
                     : fmt::format("\\{:x} ", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return safe + "\"";
}

std::string page_rules(const Texts& t, Paper paper, const PageWords& words, bool has_cover) {
  std::string rules;
  // Lower than A4, and as many planes are to fit.
  if (paper == Paper::letter) {
    rules += "@media print { html { font-size: 10.8px; } .room img { max-height: 40mm; } }\n";
  }
  rules += "@page {\n";
  if (paper == Paper::letter) rules += "size: letter;\n";
  if (!words.head.empty()) rules += box("top-left", line(words.head, kLongestHead));
  if (!words.room.empty()) rules += box("top-right", line(words.room, kLongestHead));
  if (!words.foot.empty()) rules += box("bottom-left", line(words.foot, kLongestFoot));
  rules += box("bottom-right", css_string(std::string(t[Text::page_on_paper]) + " ") +
                                   " counter(page) \" / \" counter(pages)");
  rules += "}\n";
  if (has_cover) {
    rules += "@page :first {\n" + box("bottom-left", "none") + box("bottom-right", "none") + "}\n";
    if (paper == Paper::letter) rules += "@media print { .cover { min-height: 245mm; } }\n";
  }
  return rules;
}

std::string head_words(const Texts& t, const calc::AboutProject& about) {
  constexpr std::size_t kLongestCompany = 30;
  const std::string who = calc::shorten_utf8(printable(about.company), kLongestCompany);
  return (who.empty() ? "luxgate" : who) + " · " + t[Text::compliance_report];
}

std::string foot_words(const Texts& t, const ProjectPart& project) {
  constexpr std::size_t kLongestName = 40, kLongestPart = 24;  // what comes behind must fit, too
  const auto part = [](const std::string& text) {
    return calc::shorten_utf8(printable(text), kLongestPart);
  };
  std::string words =
      calc::shorten_utf8(printable(title_of(project.name, project.path)), kLongestName);
  const calc::AboutProject& about = project.about;
  if (!about.number.empty()) words += " · " + part(about.number);
  if (!about.revision.empty()) {
    words += std::string(" · ") + t[Text::about_revision] + " " + part(about.revision);
  }
  if (!about.date.empty()) words += " · " + about.date;
  return words;
}

std::vector<RoomRun> room_runs(const ProjectPart& project, std::size_t index) {
  // Planes: fewer fill so few pages that half an empty one is much.
  constexpr std::size_t kOwnPages = 24;
  std::vector<RoomRun> runs;
  std::size_t planes = 0;  // of all
  bool is_large = false;   // the last one
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const SpacePart& space = project.spaces[s];
    if (runs.empty() || is_large || space.planes.size() >= kOwnPages) {
      runs.push_back({fmt::format("p{}r{}", index + 1, runs.size() + 1),
                      std::string(title_of(space.name, space.id)), s});
    }
    RoomRun& run = runs.back();
    ++run.rooms;
    planes += space.planes.size();
    is_large = space.planes.size() >= kOwnPages;
  }
  if (runs.size() == 1) runs.front().is_all = runs.front().rooms > 1 || planes < kOwnPages;
  for (RoomRun& run : runs) {
    if (run.rooms == 1) continue;
    run.page.clear();
    run.head.clear();
  }
  return runs;
}

std::string run_rule(const RoomRun& run) {
  if (run.page.empty()) return {};
  return fmt::format("@page {} {{ {}}}\n", run.page,
                     box("top-right", line(run.head, kLongestHead)));
}

}  // namespace report
