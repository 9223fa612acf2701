#pragma once
// Interval estimates from independent replicates.

#include "calc/base/field.h"

#include <span>

namespace calc {

// Returns x with P(T <= x) = probability for Student's t. Requires degrees_of_freedom >= 1 and
// probability in (0, 1). Relative error below 1e-10 (tested against published tables and symmetry).
double student_t_quantile(double probability, int degrees_of_freedom);

// Mean of independent replicates of one quantity.
struct ReplicateMean {
  double mean = 0.0;
  double standard_error = 0.0;  // of the mean: s / sqrt(R); 0 for one replicate
};
ReplicateMean replicate_mean(std::span<const double> replicates);

// Returns a two-sided Student-t interval at `confidence` in (0, 1). A single replicate is exact:
// low = high.
Estimate t_interval(std::span<const double> replicates, double confidence);

}  // namespace calc
