#include "report/tools/sweep/sweep_table.h"

#include "calc/base/text.h"
#include "report/text/number_format.h"
#include "report/text/shell_words.h"
#include "rules/catalogue/compare.h"
#include "rules/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace cli {
namespace {

// Sums have noise in their last digits: nobody wants to read it in a price, and it would make one
// of two equal prices, or margins, the lower one.
double without_noise(double sum) {
  return calc::parse_number(fmt::format("{:.12g}", sum)).value_or(sum);
}

// Relative to the limit; empty where there is no such thing.
std::optional<calc::Estimate> margin_of(const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const double limit = requirement.limit;
  if (!std::isfinite(limit)) return std::nullopt;
  if (std::isnan(rules::margin_of(requirement, finding.measured, finding.verdict))) {
    return std::nullopt;
  }
  const auto margin = [&](double value) {
    return without_noise(rules::margin(value, requirement.comparison, limit));
  };
  const double one = margin(finding.measured.low), other = margin(finding.measured.high);
  return calc::Estimate{margin(finding.measured.value), std::min(one, other), std::max(one, other)};
}

std::string reason_of(const report::ProjectPart& part) {
  for (const calc::Diagnostic& diagnostic : part.diagnostics) {
    if (diagnostic.severity() == calc::Severity::error) return diagnostic.message;
  }
  for (const report::SpacePart& space : part.spaces) {
    for (const report::PlanePart& plane : space.planes) {
      if (!plane.is_computed)
        return fmt::format("plane '{}': {}", plane.id, plane.reason.english());
      for (const rules::Finding& finding : plane.findings) {
        if (finding.verdict == rules::Verdict::not_judged) {
          return fmt::format("plane '{}': {}", plane.id, finding.reason.english());
        }
      }
    }
  }
  for (const rules::AggregateFinding& finding : part.aggregates) {
    if (finding.sum && finding.verdict == rules::Verdict::not_judged) {
      return fmt::format("building '{}': {}", finding.building_id, finding.reason.english());
    }
  }
  return "not judged";
}

// That the rows do not hang on the v-th path: those of equal other values are equal.
bool has_no_effect(const Sweep& sweep, std::size_t v) {
  if (sweep.vary[v].values.size() < 2 || sweep.rows.empty()) return false;
  std::map<std::vector<std::string>, const SweepRow*> first;  // by the other values
  return std::all_of(sweep.rows.begin(), sweep.rows.end(), [&](const SweepRow& row) {
    std::vector<std::string> others = row.values;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(v));
    const SweepRow& other = *first.try_emplace(std::move(others), &row).first->second;
    const auto ends = [](const SweepRow& one) {
      return one.margin ? std::array{one.margin->value, one.margin->low, one.margin->high}
                        : std::array<double, 3>{};
    };
    return row.outcome == other.outcome && row.margin.has_value() == other.margin.has_value() &&
           ends(row) == ends(other) && row.power_w == other.power_w &&
           row.without_power == other.without_power && row.price == other.price &&
           row.without_price == other.without_price;
  });
}

// Of a plane or a building.
void take_margin(const std::string& place, const rules::Finding& finding, SweepRow& row) {
  row.waived += finding.is_waived ? 1 : 0;
  if (!rules::counts(rules::outcome_of(finding)) || finding.verdict == rules::Verdict::not_judged) {
    return;
  }
  const std::optional<calc::Estimate> margin = margin_of(finding);
  if (!margin) {
    ++row.without_margin;
    return;
  }
  if (finding.verdict == rules::Verdict::pass && margin->value < 0.0) ++row.passed_beyond_limit;
  if (!row.margin || margin->value < row.margin->value) {
    row.plane = place;
    row.requirement = finding.requirement.id;
  }
  if (!row.margin) row.margin = margin;
  row.margin->value = std::min(row.margin->value, margin->value);
  row.margin->low = std::min(row.margin->low, margin->low);
  row.margin->high = std::min(row.margin->high, margin->high);
}

bool passes_with_margin(const SweepRow& row) {
  return row.outcome == rules::Outcome::pass && row.margin && std::isfinite(row.margin->value);
}

}  // namespace

SweepRow row_of(std::size_t variant, std::vector<std::string> values,
                const report::ProjectPart& part) {
  SweepRow row;
  row.variant = variant;
  row.values = std::move(values);
  row.outcome = report::outcome_of(part);
  report::Totals totals;
  totals.add(part);
  row.warnings = totals.warnings.all;
  row.rows_in_part = totals.rows_in_part;
  calc::InstalledPrice price;
  for (const report::SpacePart& space : part.spaces) {
    row.power_w += space.power.power_w;
    row.without_power += space.power.without_power;
    price.price += space.price.price;
    price.luminaires += space.price.luminaires;
    price.without_price += space.price.without_price;
    for (const report::PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) take_margin(plane.id, finding, row);
    }
  }
  row.power_w = without_noise(row.power_w);
  row.without_price = price.without_price;
  if (price.without_price < price.luminaires) row.price = without_noise(price.price);
  for (const rules::AggregateFinding& aggregate : part.aggregates) {
    if (aggregate.sum) {
      take_margin(aggregate.building_id, *aggregate.sum, row);
    } else {
      row.without_margin += rules::counts(rules::outcome_of(aggregate)) ? 1 : 0;
    }
  }
  if (row.outcome == rules::Outcome::not_judged) {
    row.margin.reset();
    row.plane.clear();
    row.requirement.clear();
    row.reason = reason_of(part);
  }
  return row;
}

std::optional<double> cost_of(const SweepRow& row, FrontOf front_of) {
  if (front_of == FrontOf::price) return row.without_price == 0 ? row.price : std::nullopt;
  return row.without_power == 0 ? std::optional(row.power_w) : std::nullopt;
}

bool has_prices(const Sweep& sweep) {
  return std::any_of(sweep.rows.begin(), sweep.rows.end(),
                     [](const SweepRow& row) { return row.price.has_value(); });
}

void find_front(std::vector<SweepRow>& rows, FrontOf front_of) {
  std::vector<SweepRow*> candidates;
  for (SweepRow& row : rows) {
    row.pareto = ParetoPlace::off;
    if (passes_with_margin(row) && cost_of(row, front_of)) candidates.push_back(&row);
  }
  const auto cost = [&](std::size_t i) { return *cost_of(*candidates[i], front_of); };
  std::stable_sort(candidates.begin(), candidates.end(), [&](const SweepRow* a, const SweepRow* b) {
    return *cost_of(*a, front_of) < *cost_of(*b, front_of);
  });
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  double best_value = kNone, best_low = kNone;  // of those that cost less
  // The same numbers are of the same light, which has no doubt of its own.
  using Ends = std::array<double, 3>;
  const auto ends_of = [](const SweepRow& row) {
    return Ends{row.margin->value, row.margin->low, row.margin->high};
  };
  std::set<Ends> cheaper;
  for (std::size_t begin = 0; begin < candidates.size();) {
    std::size_t end = begin;
    double value = kNone, low = kNone;  // of those that cost as much
    for (; end < candidates.size() && cost(end) == cost(begin); ++end) {
      value = std::max(value, candidates[end]->margin->value);
      low = std::max(low, candidates[end]->margin->low);
    }
    for (std::size_t i = begin; i < end; ++i) {
      const calc::Estimate& margin = *candidates[i]->margin;
      const bool is_beaten = best_value >= margin.value || value > margin.value;
      // Its own interval beats nobody's with the same ends.
      const bool is_surely_beaten =
          best_low >= margin.high || low > margin.high || cheaper.contains(ends_of(*candidates[i]));
      candidates[i]->pareto = !is_beaten          ? ParetoPlace::on
                              : !is_surely_beaten ? ParetoPlace::perhaps
                                                  : ParetoPlace::off;
    }
    for (std::size_t i = begin; i < end; ++i) cheaper.insert(ends_of(*candidates[i]));
    best_value = std::max(best_value, value);
    best_low = std::max(best_low, low);
    begin = end;
  }
}

void OutcomeCounts::add(rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::pass:
      ++pass;
      return;
    case rules::Outcome::fail:
      ++fail;
      return;
    case rules::Outcome::undecided:
      ++undecided;
      return;
    case rules::Outcome::not_judged:
      ++not_judged;
      return;
    default:
      ++others;
  }
}

std::string OutcomeCounts::words() const {
  return fmt::format(
      "{} pass, {} fail, {} undecided, {} not judged{}", pass, fail, undecided, not_judged,
      others > 0 ? fmt::format(", {} without a requirement that counts", others) : "");
}

OutcomeCounts count_outcomes(const std::vector<SweepRow>& rows) {
  OutcomeCounts counts;
  for (const SweepRow& row : rows) counts.add(row.outcome);
  return counts;
}

std::string margin_words(const SweepRow& row) {
  const std::string without =
      row.without_margin > 0 ? fmt::format(", {} without", row.without_margin) : "";
  if (!row.margin) return "–" + without;
  const calc::Estimate& margin = *row.margin;
  const std::string value = report::format_margin(margin.value);
  if (margin.low == margin.high) return value + without;
  const auto end = [](double margin_end) {
    return std::isfinite(margin_end) ? report::format_margin(margin_end) : std::string("open");
  };
  return fmt::format("{} ({} to {}){}", value, end(margin.low), end(margin.high), without);
}

std::string power_words(const SweepRow& row) {
  if (row.outcome == rules::Outcome::not_judged && row.power_w == 0.0) return "–";
  if (row.without_power > 0 && row.power_w == 0.0) return "not known";
  if (row.without_power == 0) return report::format_watts(row.power_w) + " W";
  return fmt::format("{} W and {} not known", report::format_watts(row.power_w), row.without_power);
}

std::string price_words(const SweepRow& row) {
  if (!row.price) return row.without_price > 0 ? "not known" : "–";
  const std::string sum = report::format_shortest(*row.price);
  return row.without_price == 0 ? sum : fmt::format("{} and {} not known", sum, row.without_price);
}

std::string requirement_words(const SweepRow& row) {
  return row.plane.empty() ? "–" : row.plane + ": " + row.requirement;
}

std::vector<std::string> sweep_notes(const Sweep& sweep) {
  std::vector<std::string> notes;
  for (std::size_t v = 0; v < sweep.vary.size(); ++v) {
    if (!has_no_effect(sweep, v)) continue;
    notes.push_back(fmt::format(
        "'{}' changes no verdict, margin, power or price: it may be overridden elsewhere",
        sweep.vary[v].path));
  }
  const auto without_cost =
      std::count_if(sweep.rows.begin(), sweep.rows.end(), [&](const SweepRow& row) {
        return passes_with_margin(row) && !cost_of(row, sweep.front_of);
      });
  if (without_cost > 0) {
    notes.push_back(fmt::format(
        "variants that pass and cannot be on the front, because the {} of luminaires is not known: "
        "{}",
        calc::name_of(sweep.front_of), without_cost));
  }
  const auto count = [&](int SweepRow::*member) {
    return std::count_if(sweep.rows.begin(), sweep.rows.end(),
                         [&](const SweepRow& row) { return row.*member > 0; });
  };
  if (const auto variants = count(&SweepRow::warnings); variants > 0) {
    notes.push_back(
        fmt::format("variants with warnings: {}; 'luxgate check' of each shows them", variants));
  }
  if (const auto variants = count(&SweepRow::rows_in_part); variants > 0) {
    notes.push_back(fmt::format(
        "variants in which a row of a standard is judged only in part: {}; a pass covers what was "
        "asked",
        variants));
  }
  if (const auto variants = count(&SweepRow::waived); variants > 0) {
    notes.push_back(fmt::format(
        "variants with waived requirements, which are not in the margin: {}", variants));
  }
  if (const auto variants = count(&SweepRow::passed_beyond_limit); variants > 0) {
    notes.push_back(
        fmt::format("variants in which a value beyond its limit passes by a tolerance or rounding "
                    "of its rule pack: {}",
                    variants));
  }
  return notes;
}

std::string check_command(const Sweep& sweep, const SweepRow& row) {
  std::string command = "luxgate check" + sweep.check_words;
  for (const check::SetValue& value : settings_of_variant(sweep.vary, row.values)) {
    command += " --set " + report::shell_quoted(value.words());
  }
  return command;
}

}  // namespace cli
