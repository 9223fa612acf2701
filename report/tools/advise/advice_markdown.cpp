#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/words.h"
#include "report/tools/advise/advice.h"
#include "report/tools/advise/advice_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace cli {
namespace {

using report::escape_markdown;

std::string groups(const SceneAdvice& advice) {
  std::string text = "| group | luminaires | now | advised |\n|---|--:|--:|--:|\n";
  for (const AdvisedGroup& group : advice.groups) {
    text += fmt::format("| {} | {} | {} | {} |\n", escape_markdown(name_of_group(group.group)),
                        group.luminaires, level_words(group.now), level_words(group.level));
  }
  return text;
}

// All, as a table folds; those that are not met say why.
std::string requirements(const SceneAdvice& advice) {
  std::string text = "| requirement | now | with these levels | verdict |\n|---|--:|--:|---|\n";
  for (const AdvisedRequirement& one : advice.requirements) {
    text += fmt::format(
        "| {} | {} | {} | {}{} |\n", escape_markdown(requirement_words(one)),
        escape_markdown(value_words(one.before)), escape_markdown(value_words(one.after)),
        verdict_words(advice, one),
        one.not_searched.empty() ? "" : "; " + escape_markdown(one.not_searched.english()));
  }
  return fmt::format("<details><summary>{}</summary>\n\n{}\n</details>\n",
                     requirement_count(advice), text);
}

std::string limits(const SceneAdvice& advice) {
  if (advice.limits.empty()) return "";
  std::string text = "\nLimits that decide, and what each would save if 1 % looser:\n\n";
  for (const AdvisedLimit& limit : advice.limits) {
    const AdvisedRequirement& one = advice.requirements[limit.requirement];
    const std::string shares = share_words(advice, limit);
    text += fmt::format(
        "- {}: {}{}{}\n", escape_markdown(requirement_words(one)),
        cost_words(limit.cost_per_percent, advice.unit),
        limit.place_m ? "; least room at " + report::format_position(*limit.place_m) : "",
        shares.empty() ? "" : "; " + escape_markdown(shares));
  }
  return text;
}

std::string found(const SceneAdvice& advice) {
  std::string text = fmt::format("\n{}\n\n{}", cost_sentence(advice), groups(advice));
  if (const std::string note = unit_note(advice.unit); !note.empty()) {
    text += fmt::format("\n{}\n", note);
  }
  if (!advice.raised_for.empty()) {
    text += fmt::format("\n{}\n\n", kRaised);
    for (const std::size_t i : advice.raised_for) {
      text += "- " + escape_markdown(requirement_words(advice.requirements[i])) + "\n";
    }
  }
  if (const std::string words = left_alone_words(advice); !words.empty()) {
    text += "\n" + escape_markdown(words) + "\n";
  }
  for (const std::string& one : advice.aggregates_not_met) {
    text += fmt::format("\nNot met with these levels: {}\n", escape_markdown(one));
  }
  return text + limits(advice) + "\n" + requirements(advice);
}

std::string scene(const SceneAdvice& advice) {
  std::string text = fmt::format("\n### {}\n\n{}\n", escape_markdown(scene_words(advice.scene)),
                                 escape_markdown(outcome_words(advice)));
  if (advice.has_levels()) text += found(advice);
  if (advice.contradicting.empty()) return text;
  text += "\n" + contradiction_words(advice) + ":\n\n";
  for (const std::size_t i : advice.contradicting) {
    text +=
        fmt::format("- {}: {} now\n", escape_markdown(requirement_words(advice.requirements[i])),
                    escape_markdown(value_words(advice.requirements[i].before)));
  }
  return text;
}

// Tables of blanks stay tables, and nothing in them is markup: the fence is longer than any in the
// text.
std::string as_code(const std::string& text) {
  if (text.empty()) return "";
  std::size_t longest = 2, run = 0;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  const std::size_t begin = text.find_first_not_of('\n');
  return "\n" + fence + "text\n" + text.substr(begin) + fence + "\n";
}

}  // namespace

std::string render_advice_markdown(const Advice& advice) {
  std::string text = fmt::format("## Levels for {}\n", escape_markdown(advice.project));
  for (const SceneAdvice& one : advice.scenes) text += scene(one);
  if (!advice.not_met_besides.empty()) text += "\nNot met, whatever the levels:\n\n";
  for (const std::string& one : advice.not_met_besides) {
    text += "- " + escape_markdown(one) + "\n";
  }
  if (advice.packages) text += as_code(render_package_advice_text(*advice.packages));
  text += as_code(render_room_advice_text(advice.rooms));
  return advice.written ? text + "\nWritten:\n" + as_code(written_words(*advice.written)) : text;
}

}  // namespace cli
