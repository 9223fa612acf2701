#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/advise/advice.h"
#include "report/tools/advise/advice_words.h"

#include <fmt/format.h>

namespace cli {
namespace {

std::string light_words(const PackageLight& light) {
  return fmt::format(
      "{}{} lm, {}", light.article.empty() ? "" : report::printable(light.article) + ": ",
      report::format_lumens(light.flux_lm),
      light.power_w > 0.0 ? report::format_watts(light.power_w) + " W" : "power not known");
}

std::string type_words(const AdvisedPackage& type) {
  const bool stays = type.now.article == type.advised.article;
  const std::string elsewhere =
      type.where_nothing_is_asked == 0 || stays
          ? ""
          : fmt::format(" ({} of them in rooms without requirements)", type.where_nothing_is_asked);
  return fmt::format("    {}, {} luminaire{}{}: {}{}\n", report::printable(type.type),
                     type.luminaires, type.luminaires == 1 ? "" : "s", elsewhere,
                     light_words(type.advised),
                     stays ? ", as now" : " instead of " + light_words(type.now));
}

// What is known of the combinations that take less.
std::string others_words(const PackageAdvice& advice) {
  if (advice.not_excluded == 0) {
    return fmt::format("{} combinations were compared; none that needs less is sufficient.",
                       advice.combinations);
  }
  return fmt::format(
      "{} combinations were compared; {} that need less are undecided. A smaller --tolerance or "
      "other levels may decide.",
      advice.combinations, advice.not_excluded);
}

std::string scene_levels(const SceneAdvice& scene) {
  std::string words;
  for (const AdvisedGroup& group : scene.groups) {
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", name_of_group(group.group),
                         level_words(group.level));
  }
  return fmt::format("    {}: {}\n", scene_words(scene.scene), words);
}

}  // namespace

std::string render_package_advice_text(const PackageAdvice& advice) {
  std::string text = "Lamp packages that are sufficient\n";
  if (!advice.problem.empty()) {
    return text + fmt::format("  No advice: {}\n", report::printable(advice.problem));
  }
  const auto cost = [&](double sum) { return cost_words(sum, advice.is_by_flux); };
  text += fmt::format(
      "  {}{} installed, now {}; checked with other random numbers, {} of {} requirements of all\n"
      "  rooms and scenes pass, now {}.\n  {}\n",
      advice.is_as_now() ? "The current ones: " : "", cost(advice.advised), cost(advice.now),
      advice.passing, advice.asked, advice.passing_now, others_words(advice));
  for (const std::string& one : advice.not_met) {
    text += fmt::format("  Not met with them: {}\n", report::printable(one));
  }
  if (advice.is_by_flux) text += std::string("  ") + kByFlux + "\n";
  for (const AdvisedPackage& type : advice.types) text += type_words(type);
  if (!advice.scenes.empty()) text += "  With these levels:\n";
  for (const SceneAdvice& scene : advice.scenes) text += scene_levels(scene);
  if (!advice.next_below.empty()) {
    text += fmt::format("  The next one below, with the current levels: {}\n",
                        report::printable(advice.next_below));
  }
  return text;
}

}  // namespace cli
