#pragma once
// A case of the selftest: a situation whose light is known independently of the program.

#include "report/tools/selftest/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace cli::selftest {

// A number with a known value.
struct Measured {
  std::string what;  // "A (0, 0, 0)"
  std::string unit = "lx";
  double exact = 0.0;
  double known_to = 0.0;           // absolute: as far as `exact` itself may be off
  std::vector<double> replicates;  // one: nothing was sampled, it must be exact
  // Half-width of the 95 % interval that is too vague, about twice the usual one: times |exact|, or
  // times `scale` if that is larger.
  double widest = 0.0;
  double scale = 0.0;  // 0 lx beside lit places is known as well as a hundredth of the brightest
  // The program's own interval at a confidence level; empty: Student's t of the replicates.
  std::function<calc::Estimate(double)> interval = {};
};

// An input that the program must refuse, and the error.
struct Refused {
  std::string what;
  std::string expected;  // part of the message
  std::string said;      // "" = it was computed
};

struct CaseResult {
  std::vector<Measured> measured;
  std::vector<Refused> refused;
  std::string problem;  // why the case could not be computed; "" = it was
  std::uint64_t rays = 0;

  // Compares every point's value. known_to: relative; widest: see Measured. With several sampled
  // points it also compares the mean of their ratios to the truth, which shows a bias that no
  // single point shows.
  void add_points(const Solution& solution, const std::vector<Point>& points,
                  const std::vector<double>& exact_lx, double known_to, double widest,
                  Part part = Part::total);
  // Compares a weighted sum over points.
  void add_sum(const Solution& solution, const std::string& what, const std::string& unit,
               const std::vector<double>& weights, double exact, double known_to, double widest,
               Part part = Part::total);
  void note(const Solution& solution);  // rays, and a problem

  // Names of points in the next add_points(), and the accuracy of each (relative, besides
  // known_to); missing ones: coordinates, 0.
  std::vector<std::string> labels;
  std::vector<double> known_each;
  std::vector<double> widest_each;  // in place of `widest`; too few, 0: `widest`
};

struct SelftestCase {
  std::string name;  // "cie171-5.2"
  std::string kind;  // one of kind_titles()
  std::string title;
  std::string source;  // where situation and formula are from
  std::function<CaseResult(const Effort&)> run;
};

struct Kind {
  std::string name, title;
};
const std::vector<Kind>& kinds();

// Returns all cases, in order of kinds().
std::vector<SelftestCase> all_cases();

std::vector<SelftestCase> point_cases();
std::vector<SelftestCase> area_cases();
std::vector<SelftestCase> flux_cases();
std::vector<SelftestCase> factor_cases();
std::vector<SelftestCase> reflection_cases();
std::vector<SelftestCase> shadow_cases();
std::vector<SelftestCase> room_cases();
std::vector<SelftestCase> extreme_cases();
std::vector<SelftestCase> files_cases();
std::vector<SelftestCase> refused_cases();

}  // namespace cli::selftest
