#include "report/tools/check/changed_settings.h"

#include "calc/base/names.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace cli {
namespace {

using report::QuestionChange;
using report::QuestionPart;

// What more of a number asks for; words that are no numbers are only another question.
enum class More { asks_more, asks_less, is_other };

struct JudgingSetting {
  std::string_view name;
  QuestionPart part;
  More more;
  std::string_view strictest = "";  // of words
};
constexpr std::array kJudging = {
    JudgingSetting{"rules", QuestionPart::rule, More::is_other},
    JudgingSetting{"goal", QuestionPart::accuracy, More::is_other, "accuracy"},
    JudgingSetting{"tolerance", QuestionPart::accuracy, More::asks_less},
    JudgingSetting{"confidence", QuestionPart::confidence, More::asks_more},
    JudgingSetting{"seed", QuestionPart::accuracy, More::is_other},
    JudgingSetting{"replicates", QuestionPart::accuracy, More::asks_more},
    JudgingSetting{"max-paths", QuestionPart::accuracy, More::asks_more},
    JudgingSetting{"strict", QuestionPart::policy, More::is_other, "true"},
    JudgingSetting{"luxgate.toml", QuestionPart::policy, More::is_other}};

QuestionChange change_of(const SettingChange& change, const JudgingSetting& setting) {
  if (setting.more == More::is_other) {
    const bool is_strictest = !setting.strictest.empty() && change.after == setting.strictest;
    return is_strictest ? QuestionChange::stricter : QuestionChange::exchanged;
  }
  const std::optional<double> before = calc::parse_number(change.before);
  const std::optional<double> after = calc::parse_number(change.after);
  if (!before || !after) return QuestionChange::exchanged;  // one of them is the program's own
  const bool is_more = *after > *before;
  return is_more == (setting.more == More::asks_more) ? QuestionChange::stricter
                                                      : QuestionChange::weaker;
}

}  // namespace

void add_changed_settings(const std::vector<SettingChange>& changes, report::Revision& revision) {
  if (changes.empty()) return;
  std::vector<std::string> names;
  for (const SettingChange& change : changes) {
    names.push_back(change.name);
    for (const JudgingSetting& setting : kJudging) {
      if (setting.name != change.name) continue;
      const auto words = [&](const std::string& value) {
        return change.name + (value.empty() ? " as by default" : " " + value);
      };
      revision.questions.push_back({change_of(change, setting),
                                    setting.part,
                                    {},
                                    words(change.before),
                                    words(change.after)});
    }
  }
  std::stable_sort(revision.questions.begin(), revision.questions.end(),
                   [](const auto& a, const auto& b) { return a.change < b.change; });
  constexpr std::size_t kMostNamed = 20;
  revision.notes.push_back(
      calc::say<calc::Sentence::settings_of_revision>(calc::list_names(names, kMostNamed)));
}

}  // namespace cli
