#pragma once
// Numerical stability: how the error grows towards the ends of what can be asked for.

#include "report/tools/selftest/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace validation {

struct SweepStep {
  double value = 0.0;       // of what is swept
  double deviation = 0.0;   // of the mean, relative to the truth
  double half_width = 0.0;  // of the 95 % interval, relative; 0 = exact
  double known_to = 0.0;    // the truth, relative
  double rays = 0.0;
  std::string said;  // what the program says instead of a number; "" = a number
};

struct Sweep {
  std::string name, title, unit, what;  // what: the light that is compared
  std::vector<SweepStep> steps;
};

// announce: told every step before it is calculated.
std::vector<Sweep> run_sweeps(const cli::selftest::Effort& effort,
                              const std::function<void(const std::string&)>& announce);

std::string render_sweeps_csv(const std::vector<Sweep>& sweeps);
std::string render_sweeps_markdown(const std::vector<Sweep>& sweeps);
std::string render_sweeps_html(const std::vector<Sweep>& sweeps);

}  // namespace validation
