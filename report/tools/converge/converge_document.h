#pragma once
// The measurements of `luxgate converge`, for its formats.

#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Relative errors: RMS and maximum over points, of the plane average, of its Uo (minimum to
// average).
enum class ConvergeMetric { rms, maximum, average, uniformity };
inline constexpr std::size_t kConvergeMetrics = 4;
inline constexpr std::array<ConvergeMetric, kConvergeMetrics> kAllConvergeMetrics{
    ConvergeMetric::rms, ConvergeMetric::maximum, ConvergeMetric::average,
    ConvergeMetric::uniformity};

// Errors for which the run time is determined.
inline constexpr std::array kConvergeTargets{0.05, 0.02, 0.01, 0.005, 0.001};

// An error over the seeds at a number of paths. value: root of the mean square, also of the
// maximum, less the reference's own error where it could be subtracted; low, high: smallest and
// largest of single seeds, as measured. value is NaN if there is nothing to measure. is_below: the
// error is below the reference's error, which is then the value.
struct ConvergeError {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = 0.0, high = 0.0;
  bool is_below = false;
};

// Number of points whose stated 95 % interval contains the true value.
struct ConvergeCoverage {
  std::uint64_t held = 0, tried = 0;
  double share() const {
    return tried > 0 ? static_cast<double>(held) / static_cast<double>(tried) : 0.0;
  }
};

struct ConvergePhases {  // seconds
  double build = 0.0, direct = 0.0, pool = 0.0, maps = 0.0, connect = 0.0, near = 0.0;
};

// A method at a number of paths, all planes together. Times: of the fastest seed; rays: medians.
struct ConvergeStep {
  std::uint64_t paths = 0;  // of one replicate
  double seconds = 0.0;
  ConvergePhases phases;
  double light_rays = 0.0;      // of light paths, all replicates: so many light vertices at most
  double rays_per_point = 0.0;  // all but those towards luminaires, all replicates
};

struct ConvergeSlopes {
  std::optional<double> over_time, over_rays;  // exponents; none below three steps
};

struct ConvergeTarget {
  std::optional<double> seconds;  // none: not reached, and too far to tell
  bool is_extrapolated = false;
};

// The errors of a method on a plane, [step].
struct ConvergeCurve {
  std::vector<std::array<ConvergeError, kConvergeMetrics>> errors;
  std::vector<ConvergeCoverage> coverage, average_coverage;
  std::array<ConvergeSlopes, kConvergeMetrics> slopes;
  std::array<ConvergeTarget, kConvergeTargets.size()> targets;  // of the RMS error
};

struct ConvergePlane {
  std::string id, name;
  std::size_t points = 0;
  double average_lx = 0.0, minimum_lx = 0.0, uo = 0.0;  // of the reference
  double reference_error = 0.0;                         // RMS, relative
  std::vector<ConvergeCurve> curves;                    // [method]
};

struct ConvergeMethod {
  std::string name, title;
  std::vector<ConvergeStep> steps;
};

struct ConvergeDocument {
  std::string project, path, space_id, program;
  std::string opengl;  // the device, "" = no method needs one
  bool is_software_opengl = false;
  std::string part;       // "total" or "indirect"
  std::string reference;  // in words
  // Replicates of luxgate's own reference; 0: the reference is a file.
  int reference_replicates = 0;
  std::uint64_t reference_paths = 0;
  int replicates = 0, seeds = 0, jobs = 0;
  std::uint64_t first_seed = 1;
  double load_s = 0.0, prepare_s = 0.0, reference_s = 0.0;
  std::size_t triangles = 0, luminaires = 0, points = 0;
  double clamp_per_m2 = 0.0;  // 0 = no clamped method among them
  std::vector<ConvergeMethod> methods;
  std::vector<ConvergePlane> planes;
};

std::string_view converge_metric_name(ConvergeMetric metric);  // "rms"

std::string render_converge_text(const ConvergeDocument& document);
std::string render_converge_csv(const ConvergeDocument& document);
std::string render_converge_json(const ConvergeDocument& document);
// Returns the page in the reader's language; texts of the project and the reference stay unchanged.
std::string render_converge_html(const ConvergeDocument& document, const Texts& t = {},
                                 Paper paper = Paper::a4);

}  // namespace report
