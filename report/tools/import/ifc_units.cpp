#include "report/tools/import/ifc_units.h"

#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace cli {
namespace {

constexpr int kDeepestUnit = 4;  // a unit by a unit by a unit ...
constexpr double kSmallestLength = 1.0e-6, kLargestLength = 1.0e4;  // metres of a unit

struct Prefix {
  std::string_view name, symbol;
  double factor, divisor;  // one of them is 1
};
constexpr Prefix kPrefixes[] = {
    {"KILO", "k", 1.0e3, 1.0},  {"HECTO", "h", 1.0e2, 1.0}, {"DECA", "da", 1.0e1, 1.0},
    {"DECI", "d", 1.0, 1.0e1},  {"CENTI", "c", 1.0, 1.0e2}, {"MILLI", "m", 1.0, 1.0e3},
    {"MICRO", "u", 1.0, 1.0e6},
};

// Lengths that people know by name, as one unit has them.
struct NamedLength {
  std::string_view name;
  double metres;
};
constexpr NamedLength kNamedLengths[] = {
    {"FOOT", calc::kMetresPerFoot},
    {"FEET", calc::kMetresPerFoot},
    {"INCH", calc::kMetresPerInch},
    {"YARD", 3.0 * calc::kMetresPerFoot},
};

struct Unit {
  double factor = 1.0;  // metres or radians
  std::string name;
};

class UnitReader {
 public:
  UnitReader(const StepText& text, StepProblem& problem) : text_(text), problem_(problem) {}

  std::optional<IfcUnits> read() {
    const std::optional<std::uint32_t> assignment = find_assignment();
    if (!assignment) return std::nullopt;
    const std::vector<StepValue> arguments = text_.arguments(*assignment);
    std::optional<Unit> length, angle;
    if (!arguments.empty()) {
      for (const StepValue& value : arguments[0].items()) {
        const std::optional<std::uint32_t> unit = text_.find(value);
        if (!unit) continue;
        const std::string kind = kind_of(*unit);
        if (kind != "LENGTHUNIT" && kind != "PLANEANGLEUNIT") continue;
        const std::optional<Unit> read = unit_of(*unit, kind, 0);
        if (!read) return std::nullopt;
        std::optional<Unit>& place = kind == "LENGTHUNIT" ? length : angle;
        if (place && place->factor != read->factor) {
          return fail(*unit, fmt::format("the project has two units for {}", kind));
        }
        place = read;
      }
    }
    if (!length) {
      return fail(*assignment, "the project has no unit of length; state it");
    }
    if (!(length->factor >= kSmallestLength && length->factor <= kLargestLength)) {
      return fail(*assignment,
                  fmt::format("a unit of length of {:g} m is not plausible", length->factor));
    }
    set_length_unit(units_, length->factor);
    units_.name = length->name;
    units_.reason = "stated by the file";
    if (angle) {
      units_.has_angle = true;
      units_.radians = angle->factor;
    }
    return units_;
  }

 private:
  std::nullopt_t fail(std::uint32_t instance, std::string what) {
    problem_ = {text_.line(instance), fmt::format("#{}: {}", text_.number(instance), what)};
    return std::nullopt;
  }

  std::optional<std::uint32_t> find_assignment() {
    const auto projects = text_.of_name("IFCPROJECT");
    if (projects.size() > 1) return fail(projects[1], "a second IFCPROJECT; one is allowed");
    if (projects.size() == 1) {
      const std::vector<StepValue> arguments = text_.arguments(projects[0]);
      if (arguments.size() > 8) {
        const std::optional<std::uint32_t> assignment = text_.find(arguments[8]);
        if (assignment && text_.name(*assignment) == "IFCUNITASSIGNMENT") return assignment;
      }
      return fail(projects[0], "the project names no IFCUNITASSIGNMENT, so no unit of length");
    }
    problem_ = {0, "no IFCPROJECT in this file, so no unit of length"};
    return std::nullopt;
  }

  std::string kind_of(std::uint32_t unit) const {
    const std::string& name = text_.name(unit);
    if (name != "IFCSIUNIT" && !name.starts_with("IFCCONVERSIONBASEDUNIT")) return {};
    const std::vector<StepValue> arguments = text_.arguments(unit);
    return arguments.size() > 1 ? arguments[1].enumeration() : std::string();
  }

  std::optional<Unit> unit_of(std::uint32_t unit, const std::string& kind, int depth) {
    const std::vector<StepValue> a = text_.arguments(unit);
    if (depth > kDeepestUnit) return fail(unit, "its units are nested too deep");
    if (text_.name(unit) == "IFCSIUNIT" && a.size() > 3) return si_unit(unit, kind, a);
    if (text_.name(unit) != "IFCCONVERSIONBASEDUNIT" || a.size() < 4) {
      return fail(
          unit, fmt::format("{} is not a supported unit; IFCSIUNIT and IFCCONVERSIONBASEDUNIT are",
                            text_.name(unit)));
    }
    const std::optional<std::uint32_t> measure = text_.find(a[3]);
    std::vector<StepValue> m;
    if (measure) m = text_.arguments(*measure);
    if (m.size() < 2) m.assign(2, StepValue());
    const double factor = m[0].untyped().number().value_or(0.0);
    const std::optional<std::uint32_t> base = text_.find(m[1]);
    if (!base || !(factor > 0.0)) {
      return fail(unit, "a unit by conversion needs a factor > 0 and a unit");
    }
    if (kind_of(*base) != kind) return fail(unit, "a unit by conversion of another kind of unit");
    const std::optional<Unit> of_base = unit_of(*base, kind, depth + 1);
    if (!of_base) return std::nullopt;
    Unit result{factor * of_base->factor, calc::printable(a[2].text().value_or(""))};
    if (kind == "LENGTHUNIT") compare_with_name(result);
    return result;
  }

  std::optional<Unit> si_unit(std::uint32_t unit, const std::string& kind,
                              const std::vector<StepValue>& a) {
    const std::string prefix = a[2].enumeration(), name = a[3].enumeration();
    if (name != (kind == "LENGTHUNIT" ? "METRE" : "RADIAN")) {
      return fail(unit, fmt::format("the unit {} for {} is not supported", name, kind));
    }
    const std::string symbol = kind == "LENGTHUNIT" ? "m" : "rad";
    if (prefix.empty()) return Unit{1.0, symbol};
    for (const Prefix& known : kPrefixes) {
      if (prefix == known.name) {
        return Unit{known.factor / known.divisor, std::string(known.symbol) + symbol};
      }
    }
    return fail(unit, fmt::format("the prefix {} of a unit is not read", prefix));
  }

  void compare_with_name(const Unit& unit) {
    const std::string lower = calc::ascii_lowered(unit.name);
    for (const NamedLength& known : kNamedLengths) {
      if (lower != calc::ascii_lowered(known.name)) continue;
      if (std::fabs(unit.factor - known.metres) > 1.0e-4 * known.metres) {
        units_.doubt.push_back(fmt::format(
            "the unit {} has {:g} m in this file and {:g} m elsewhere; the file's value is taken",
            unit.name, unit.factor, known.metres));
      }
    }
  }

  const StepText& text_;
  StepProblem& problem_;
  IfcUnits units_;
};

}  // namespace

void set_length_unit(IfcUnits& units, double metres) {
  units.metres = metres;
  const double inverse = std::round(1.0 / metres);
  units.per_metre = inverse >= 1.0 && 1.0 / inverse == metres ? inverse : 0.0;
}

std::optional<IfcUnits> read_ifc_units(const StepText& text, StepProblem& problem) {
  return UnitReader(text, problem).read();
}

}  // namespace cli
