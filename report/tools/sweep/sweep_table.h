#pragma once
// What came out of a sweep, in no particular format.

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

// What margins are held against on the front: the cost of a variant.
enum class FrontOf { power, price };

// on: no other variant that passes has less or as much cost and a larger or as large margin, one of
// both strictly; by the values. perhaps: some has by its value, none with its whole interval or
// with the very same numbers. off: all others, and variants that do not pass or of which cost or
// margin is not known.
enum class ParetoPlace { off, perhaps, on };

struct SweepRow {
  std::size_t variant = 0;          // from 0
  std::vector<std::string> values;  // of each path
  rules::Outcome outcome = rules::Outcome::not_judged;
  // Relative to the limit, > 0 is good: the smallest over all requirements that count, each end on
  // its own: if all intervals hold this one does. Empty: something is not judged, or no requirement
  // has a limit other than 0.
  std::optional<calc::Estimate> margin;
  std::string plane, requirement;  // whose value is the smallest; plane: or building
  // What counts and has no such number: limits of 0, aggregates and classes. Nothing of it is in
  // the margin.
  int without_margin = 0;
  double power_w = 0.0;   // installed, of luminaires whose power is known
  int without_power = 0;  // luminaires whose power is not
  // Of all luminaires that state one, in the project's own currency; empty: none does.
  std::optional<double> price;
  int without_price = 0;  // luminaires that state none
  // What a check of it has to say besides; told whole by that check.
  int warnings = 0, rows_in_part = 0;
  // Requirements that do not count since they are waived, and those that pass with a value beyond
  // their limit, by a pack's tolerance or rounding. Their margins are below 0.
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

// All but its place on the front, which find_front() knows.
SweepRow row_of(std::size_t variant, std::vector<std::string> values,
                const report::ProjectPart& part);
void find_front(std::vector<SweepRow>& rows, FrontOf front_of);
// Empty: it is not known of every luminaire.
std::optional<double> cost_of(const SweepRow& row, FrontOf front_of);
// Whether any luminaire of any variant has one.
bool has_prices(const Sweep& sweep);

// In this order in every count: pass, fail, undecided, not judged, and where nothing counts.
struct OutcomeCounts {
  std::size_t pass = 0, fail = 0, undecided = 0, not_judged = 0, others = 0;

  void add(rules::Outcome outcome);
  // "3 pass, 2 fail, 0 undecided, 0 not judged".
  std::string words() const;
};
OutcomeCounts count_outcomes(const std::vector<SweepRow>& rows);

// "+3.2 % (+1.0 % to +5.0 %)", "–"; with how many results have none.
std::string margin_words(const SweepRow& row);
// "540.0 W", with what is not known.
std::string power_words(const SweepRow& row);
// "1078.8", with how many luminaires state no power.
std::string price_words(const SweepRow& row);
// "desk: Uo"
std::string requirement_words(const SweepRow& row);
// What every format has to say of all variants: paths whose values change nothing, those that
// cannot be on the front since their cost is not known, warnings, rows of standards that are asked
// in part only. rows: all variants.
std::vector<std::string> sweep_notes(const Sweep& sweep);
// That gives the same numbers as the variant had.
std::string check_command(const Sweep& sweep, const SweepRow& row);

std::string render_sweep_text(const Sweep& sweep);
std::string render_sweep_csv(const Sweep& sweep);
std::string render_sweep_json(const Sweep& sweep);
std::string render_sweep_html(const Sweep& sweep);
// JSON Schema (draft 7) of render_sweep_json(), made of the same keys. sweep.schema.json is what it
// was when that file was written last; a test compares them.
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
