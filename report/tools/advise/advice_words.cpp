#include "report/tools/advise/advice_words.h"

#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cli {
namespace {

// " (-36.0 %)" of what is needed now; "" where that is nothing.
std::string saving_words(const SceneAdvice& advice) {
  if (!(advice.now > 0.0)) return "";
  const double share = advice.advised / advice.now - 1.0;
  return fmt::format(" ({}{:.1f} %)", share > 0.0 ? "+" : "", 100.0 * share);
}

}  // namespace

std::string cost_words(double cost, CostUnit unit) {
  switch (unit) {
    case CostUnit::watt:
      return report::format_watts(cost) + " W";
    case CostUnit::lumen:
      return report::format_lumens(cost) + " lm";
    case CostUnit::kilowatt_hour:
      break;
  }
  return report::format_watts(cost) + " kWh a year";
}

std::string cost_words(double cost, bool is_by_flux) {
  return cost_words(cost, is_by_flux ? CostUnit::lumen : CostUnit::watt);
}

std::string level_words(double level) { return fmt::format("{:.4g} %", 100.0 * level); }

std::string name_of_group(const std::string& group) {
  return group.empty() ? "(without a group)" : report::printable(group);
}

std::string asked_words(const rules::Requirement& requirement) {
  return fmt::format("{} {} {}", report::quantity_words(requirement),
                     rules::comparison_name(requirement.comparison),
                     report::format_limit(requirement.limit, rules::unit_of(requirement)));
}

std::string requirement_words(const AdvisedRequirement& one) {
  return fmt::format("{}, {}: {}", report::printable(one.space), report::printable(one.plane),
                     asked_words(one.before.requirement));
}

std::string value_words(const rules::Finding& finding) {
  if (finding.verdict == rules::Verdict::not_judged) return "not judged";
  return report::format_measured(finding.measured, rules::unit_of(finding.requirement));
}

std::string written_words(const WrittenAdvice& written) {
  std::string text =
      fmt::format("{}: {}; {} of {} requirements pass in it\n", report::printable(written.file),
                  written.what, written.passing, written.asked);
  for (const std::string& one : written.not_met) {
    text += fmt::format("  not met: {}\n", report::printable(one));
  }
  return text;
}

std::string verdict_words(const SceneAdvice& advice, const AdvisedRequirement& one) {
  const std::string name(calc::name_of(one.after.verdict));
  return advice.outcome == AdviceOutcome::more_light && one.after.verdict == rules::Verdict::pass
             ? "would pass"
             : name;
}

std::string cost_sentence(const SceneAdvice& advice) {
  const auto words = [&](double cost) { return cost_words(cost, advice.unit); };
  return fmt::format(
      "{} with these levels; now {}{}. No levels that meet the conditions need less than {}.",
      words(advice.advised), words(advice.now), saving_words(advice), words(advice.least));
}

std::string share_words(const SceneAdvice& advice, const AdvisedLimit& limit) {
  constexpr std::size_t kMostShares = 3;
  double sum = 0.0;
  std::vector<std::pair<double, std::string>> shares;
  for (std::size_t i = 0; i < limit.lx.size(); ++i) {
    sum += limit.lx[i];
    if (!(limit.lx[i] > 0.0)) continue;
    shares.emplace_back(-limit.lx[i], i < advice.groups.size()
                                          ? name_of_group(advice.groups[i].group)
                                          : "light that no level changes");
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (shares.size() < 2) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostShares, shares.size()); ++i) {
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", shares[i].second,
                        -100.0 * shares[i].first / sum);
  }
  return fmt::format("light {}: {}", limit.place_m ? "there" : "on average", text);
}

std::string scene_words(const std::string& scene) {
  return scene.empty() ? "Full output" : fmt::format("Scene '{}'", report::printable(scene));
}

std::string requirement_count(const SceneAdvice& advice) {
  const std::size_t count = advice.requirements.size();
  return fmt::format("{} requirement{}", count, count == 1 ? "" : "s");
}

std::string left_alone_words(const SceneAdvice& advice) {
  std::string names;
  for (const std::string& one : advice.left_alone) {
    names += (names.empty() ? "" : ", ") + name_of_group(one);
  }
  return names.empty() ? "" : "These light no requirement and keep their levels: " + names;
}

std::string contradiction_words(const SceneAdvice& advice) {
  return advice.contradicting.size() == 1
             ? "No dimming levels meet this requirement; there may be others"
             : "No dimming levels meet all of these together, but they do without any one of them; "
               "there may be other such sets";
}

std::string outcome_words(const SceneAdvice& advice) {
  switch (advice.outcome) {
    case AdviceOutcome::levels: {
      const auto met = std::count_if(
          advice.requirements.begin(), advice.requirements.end(),
          [](const AdvisedRequirement& one) { return one.after.verdict == rules::Verdict::pass; });
      return fmt::format(
          "levels found; checked with other random numbers, {} of {} requirements pass", met,
          advice.requirements.size());
    }
    case AdviceOutcome::more_light:
      return "no levels up to full output meet all conditions; with more light these would (100 % "
             "is the light that the luminaires have)";
    case AdviceOutcome::contradiction:
      return fmt::format("no levels meet all conditions, even with up to {:g} times the light",
                         kMostAdvisedLight);
    case AdviceOutcome::too_uncertain:
      return "the intervals are too wide to find levels; a smaller --tolerance helps";
    case AdviceOutcome::none_found:
      break;
  }
  return "no levels: " + report::printable(advice.reason.english());
}

}  // namespace cli
