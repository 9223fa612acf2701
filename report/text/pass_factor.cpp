#include "report/text/pass_factor.h"

#include "calc/base/elementary.h"
#include "report/text/text_numbers.h"
#include "rules/verdict/outcome.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {

bool is_strict(rules::Comparison comparison) {
  return comparison == rules::Comparison::more_than || comparison == rules::Comparison::less_than;
}

// 1e-6: 1.09 must not become 1.10 because of its last bit.
double up(double factor, int decimals) {
  const double scale = calc::pow(10.0, decimals);
  return std::ceil(factor * scale - 1e-6) / scale;
}
double down(double factor, int decimals) {
  const double scale = calc::pow(10.0, decimals);
  return std::floor(factor * scale + 1e-6) / scale;
}

// Two, or as many as tell the ends of the interval apart.
int decimals_of(const calc::Estimate& factor) {
  int decimals = 2;
  const double width = factor.high - factor.low;
  while (decimals < 5 && width > 0.0 && width < 2.0 * calc::pow(10.0, -decimals)) ++decimals;
  return decimals;
}

bool is_uniformity(rules::Metric metric) {
  return metric == rules::Metric::uniformity_min_avg ||
         metric == rules::Metric::uniformity_min_max || metric == rules::Metric::road_uniformity ||
         metric == rules::Metric::road_lengthwise;
}

bool is_glare(const rules::Requirement& requirement) {
  return requirement.metric == rules::Metric::ugr_table ||
         (requirement.derived == calc::DerivedQuantity::ugr &&
          !rules::is_lower_limit(requirement.comparison));
}

// What fails that more light does not mend.
struct Failures {
  bool of_uniformity = false, of_glare = false;
};

Failures failures_beside(const SpacePart& space, const std::string& scene) {
  Failures failures;
  for (const PlanePart& plane : space.planes) {
    for (const rules::Finding& finding : plane.findings) {
      const rules::Requirement& asked = finding.requirement;
      if (rules::outcome_of(finding) != rules::Outcome::fail || asked.scene != scene) continue;
      failures.of_uniformity |= is_uniformity(asked.metric);
      failures.of_glare |= is_glare(asked);
    }
  }
  return failures;
}

}  // namespace

std::optional<calc::Estimate> pass_factor(const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const calc::Estimate& measured = finding.measured;
  // Ratings and ratios do not grow with the light.
  if (calc::is_plain_number(requirement.derived)) return std::nullopt;
  // Where it fails for a reason, such as light that is missing, a factor would not mend that.
  if (!finding.reason.empty()) return std::nullopt;
  if (finding.verdict != rules::Verdict::fail || is_strict(requirement.comparison) ||
      !rules::metric_row(requirement.metric).is_linear || !requirement.policy.is_default() ||
      !(requirement.limit > 0.0) || !(measured.low > 0.0) || !std::isfinite(measured.high)) {
    return std::nullopt;
  }
  return calc::Estimate{requirement.limit / measured.value, requirement.limit / measured.high,
                        requirement.limit / measured.low};
}

std::optional<double> group_pass_factor(const rules::Finding& finding, const PlanePart& plane,
                                        const GroupShare& share) {
  const rules::Requirement& requirement = finding.requirement;
  const bool is_about_average =
      requirement.metric == rules::Metric::average && !calc::is_plain_number(requirement.derived) &&
      requirement.comparison == rules::Comparison::at_least &&
      requirement.state == rules::LightState::maintained && requirement.scene.empty() &&
      requirement.mask.operations.empty() && requirement.mask.id.empty() &&
      !requirement.direct_only && requirement.policy.is_default();
  if (finding.verdict != rules::Verdict::fail || !is_about_average || !(share.average_lx.low > 0.0))
    return std::nullopt;
  const double missing = requirement.limit - plane.average.low;
  if (!(missing > 0.0) || !std::isfinite(missing)) return std::nullopt;
  return 1.0 + missing / share.average_lx.low;
}

std::string factor_text(const Texts& t, double factor) {
  return "×" + format_fixed(t, up(factor, 2), 2);
}

std::string pass_factor_words(const Texts& t, const rules::Finding& finding) {
  const std::optional<calc::Estimate> factor = pass_factor(finding);
  if (!factor) return {};
  const int digits = decimals_of(*factor);
  if (rules::is_lower_limit(finding.requirement.comparison))
    return t.say<Text::reaches_limit>(format_fixed(t, up(factor->high, digits), digits));
  return t.say<Text::comes_down_to_limit>(format_fixed(t, down(factor->low, digits), digits));
}

std::string remedy_words(const Texts& t, const SpacePart& space, const rules::Finding& finding) {
  std::string factor = pass_factor_words(t, finding);
  if (factor.empty() || !rules::is_lower_limit(finding.requirement.comparison)) return factor;
  const Failures failures = failures_beside(space, finding.requirement.scene);
  if (failures.of_uniformity && failures.of_glare) return t[Text::light_mends_no_uniformity_glare];
  if (failures.of_uniformity) return t[Text::light_mends_no_uniformity];
  return failures.of_glare ? t[Text::light_mends_no_glare] : factor;
}

}  // namespace report
