#pragma once
// The results of a sweep, independent of the format.

#include "calc/base/field.h"
#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/tools/sweep/vary.h"
#include "rules/verdict/outcome.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// The cost of a variant that the front compares with its margin.
enum class FrontOf { power, price };

// on: no other passing variant has at most its cost and at least its margin, one of them strictly
// better, by the values. perhaps: by the values there is such a variant, but none with its whole
// interval or with equal numbers. off: all others, variants that do not pass, and unknown cost or
// margin.
enum class ParetoPlace { off, perhaps, on };

struct SweepRow {
  std::size_t variant = 0;          // from 0
  std::vector<std::string> values;  // of each path
  rules::Outcome outcome = rules::Outcome::not_judged;
  // Relative to the limit, > 0 is good: the smallest over all requirements that count, for each end
  // separately: if all intervals hold, so does this one. Empty: something is not judged, or no
  // requirement has a limit other than 0.
  std::optional<calc::Estimate> margin;
  std::string plane, requirement;  // whose value is the smallest; plane: or building
  // Number of requirements that count without a margin: limits of 0, aggregates and classes. The
  // margin does not include them.
  int without_margin = 0;
  double power_w = 0.0;   // installed, of luminaires whose power is known
  int without_power = 0;  // luminaires whose power is not
  // Total of all luminaires that state a price, in the project's own currency; empty: none does.
  std::optional<double> price;
  int without_price = 0;  // luminaires that state none
  // Further messages of its check, which that check shows in full.
  int warnings = 0, rows_in_part = 0;
  // Numbers of waived requirements, and of requirements that pass with a value beyond their limit,
  // by a pack's tolerance or rounding. Their margins are below 0.
  int waived = 0, passed_beyond_limit = 0;
  ParetoPlace pareto = ParetoPlace::off;
  std::string reason;  // why it is not judged; "" = it is
};

struct Sweep {
  std::string project;
  std::vector<Vary> vary;
  std::vector<check::SetValue> set;  // in all variants
  report::Provenance provenance;
  std::string check_words;  // options of `luxgate check` that check one of the variants alike
  std::vector<SweepRow> rows;
  FrontOf front_of = FrontOf::power;
};

// Returns the row without its place on the front, which find_front() sets.
SweepRow row_of(std::size_t variant, std::vector<std::string> values,
                const report::ProjectPart& part);
void find_front(std::vector<SweepRow>& rows, FrontOf front_of);
// Returns the cost; empty: it is not known for every luminaire.
std::optional<double> cost_of(const SweepRow& row, FrontOf front_of);
// Returns whether any luminaire of any variant has a price.
bool has_prices(const Sweep& sweep);

// Counts in a fixed order: pass, fail, undecided, not judged, and variants in which nothing counts.
struct OutcomeCounts {
  std::size_t pass = 0, fail = 0, undecided = 0, not_judged = 0, others = 0;

  void add(rules::Outcome outcome);
  // Returns "3 pass, 2 fail, 0 undecided, 0 not judged".
  std::string words() const;
};
OutcomeCounts count_outcomes(const std::vector<SweepRow>& rows);

// Returns "+3.2 % (+1.0 % to +5.0 %)", "–"; with the number of results without a margin.
std::string margin_words(const SweepRow& row);
// Returns "540.0 W", with the unknown part.
std::string power_words(const SweepRow& row);
// Returns "1078.8", with the number of luminaires that state no price.
std::string price_words(const SweepRow& row);
// Returns "desk: Uo".
std::string requirement_words(const SweepRow& row);
// Returns notes on all variants for every format: paths whose values change nothing, variants that
// cannot be on the front because their cost is not known, warnings, rows of standards that are only
// partly required. rows: all variants.
std::vector<std::string> sweep_notes(const Sweep& sweep);
// Returns a command that gives the variant's numbers again.
std::string check_command(const Sweep& sweep, const SweepRow& row);

std::string render_sweep_text(const Sweep& sweep);
std::string render_sweep_csv(const Sweep& sweep);
std::string render_sweep_json(const Sweep& sweep);
std::string render_sweep_html(const Sweep& sweep);
// Returns the JSON Schema (draft 7) of render_sweep_json(), made of the same keys.
// sweep.schema.json is its last written version; a test compares them.
std::string sweep_schema();

}  // namespace cli

template <>
struct calc::EnumNames<cli::FrontOf> {
  static constexpr EnumName<cli::FrontOf> list[] = {{cli::FrontOf::power, "power"},
                                                    {cli::FrontOf::price, "price"}};
};

template <>
struct calc::EnumNames<cli::ParetoPlace> {
  static constexpr EnumName<cli::ParetoPlace> list[] = {{cli::ParetoPlace::on, "on"},
                                                        {cli::ParetoPlace::perhaps, "perhaps"},
                                                        {cli::ParetoPlace::off, "off"}};
};
