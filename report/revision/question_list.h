#pragma once
// Shared by the comparisons of requirements.

#include "report/document/revision.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace report {

// Returns whether numbers are equal that were calculated, not written.
inline bool is_same_number(double a, double b) {
  constexpr double kSameShare = 1e-9;
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::abs(a - b) <= kSameShare * std::max(std::abs(a), std::abs(b));
}

// Changes of requirements at one place.
class QuestionList {
 public:
  explicit QuestionList(RevisionPlace place) : place_(std::move(place)) {}

  void add(QuestionChange change, QuestionPart part, std::string before, std::string after,
           const std::string& item = "") {
    ChangedQuestion question{change, part, place_, std::move(before), std::move(after)};
    if (!item.empty()) question.place.item = item;
    list_.push_back(std::move(question));
  }
  // Adds a change; nothing if both are equal.
  void exchange(QuestionPart part, const std::string& before, const std::string& after,
                const std::string& item = "") {
    if (before != after) add(QuestionChange::exchanged, part, before, after, item);
  }
  // Adds a change of a number; a larger number means a stricter requirement, or a weaker one.
  void compare(QuestionPart part, double before, double after, bool more_is_stricter,
               const std::string& before_words, const std::string& after_words,
               const std::string& item = "") {
    if (is_same_number(before, after)) return;
    const bool is_known = std::isfinite(before) && std::isfinite(after);
    const bool is_stricter = (after > before) == more_is_stricter;
    add(!is_known     ? QuestionChange::exchanged
        : is_stricter ? QuestionChange::stricter
                      : QuestionChange::weaker,
        part, before_words, after_words, item);
  }
  std::vector<ChangedQuestion> take() { return std::move(list_); }

 private:
  RevisionPlace place_;
  std::vector<ChangedQuestion> list_;
};

}  // namespace report
