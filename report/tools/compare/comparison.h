#pragma once
// Compares two sets of illuminances at the same points.

#include "report/document/document.h"
#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace report {

// A value and the half-width of its interval; 0 = exact.
struct ComparedValue {
  double lx = 0.0, half_width_lx = 0.0;
};

struct ComparedPoint {
  glm::dvec3 position_m{0.0};
  int column = 0, row = 0;
  ComparedValue a, b;

  double difference_lx() const { return a.lx - b.lx; }
  double interval_lx() const;  // half-width of the difference's interval, both errors combined
};

struct ComparedPlane {
  std::string id;
  std::vector<ComparedPoint> points;  // >= 1
  // Half-widths of the averages' intervals, which are no sum of the points': errors of points may
  // be correlated. The average is judged only with both.
  std::optional<double> average_half_width_a_lx = {}, average_half_width_b_lx = {};

  // Filled by compare_points().
  double average_a_lx = 0.0, average_b_lx = 0.0;
  double uo_a = 0.0, uo_b = 0.0;  // minimum / average
  double bias = 0.0, rms = 0.0;   // mean and root mean square difference, over B's average
  std::size_t held = 0;           // points whose combined interval holds the difference
  std::size_t beyond = 0;         // points beyond `allowed`, see Comparison
  bool is_average_beyond = false;

  // Returns the half-width of the interval of the averages' difference; empty: not known, not
  // judged.
  std::optional<double> average_interval_lx() const;
};

struct Comparison {
  std::string name_a, name_b;
  double confidence = 0.95;  // of A's intervals, taken for B's too
  double tolerance = 0.0;    // share of B
  int replicates = 16;       // of A
  std::vector<ComparedPlane> planes;
  std::vector<std::string> notes;  // what was not compared, and why
  std::size_t lacks = 0;           // planes and points that only one result has
  // The revision from A's document to B's, if both are results: requirements, verdicts and inputs.
  std::optional<Document> revised = {};

  // Factor on intervals. A point or average is beyond if the difference exceeds tolerance x B plus
  // the combined interval times this factor: by chance this happens in 1 of 20 comparisons.
  double widening = 1.0;

  std::size_t points() const;
  std::size_t beyond() const;  // points
  std::size_t averages_judged() const;
  std::size_t averages_beyond() const;
  bool are_values_alike() const { return beyond() == 0 && averages_beyond() == 0 && lacks == 0; }
  // Returns whether all values are alike and everything is required and judged as before.
  bool is_alike() const;
};

// Sets all values that follow from the points. Two values that are both not a number are alike, a
// single one is not.
void compare_points(Comparison& comparison);

// Returns indices of the `count` points with the largest difference relative to their uncertainty,
// worst first.
std::vector<std::size_t> worst_points(const ComparedPlane& plane, std::size_t count);

// Returns "+2.50 %"; "–" if not finite.
std::string signed_percent(double share);

// Returns "Alike", or how it differs.
std::string comparison_headline(const Comparison& comparison);

std::string render_comparison_text(const Comparison& comparison, std::size_t worst);
// Returns planes as a table, followed by the points with the largest difference if `worst` is not
// 0.
std::string render_comparison_markdown(const Comparison& comparison, std::size_t worst);
std::string render_comparison_csv(const Comparison& comparison);
std::string render_comparison_json(const Comparison& comparison);
// Returns the page in the reader's language; notes stay English and are marked so.
std::string render_comparison_html(const Comparison& comparison, std::size_t worst,
                                   const Texts& t = {}, Paper paper = Paper::a4);

}  // namespace report
