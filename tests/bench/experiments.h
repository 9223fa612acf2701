#pragma once
// What bench_core can do; see README.md for how to run and read each.

#include "tests/bench/measure.h"

namespace bench {

void run_converge(const Options& options);
void run_accuracy(const Options& options);
// Ratios and nothing else.
void run_ratios(const Options& options);
void run_near(const Options& options);
void run_openings(const Options& options);
void run_stiff(const Options& options);
void run_coverage(const Options& options);
void run_sparse(const Options& options);
void run_scaling(const Options& options);
// names: scene (office), number of seeds (none: cost of one).
void run_verdicts(const Options& options);
// Reading speed and memory of photometry files.
void run_files(const Options& options);
void run_projects(const Options& options);
// Every generator and experiment at the smallest size, with the checks that cost nothing. Throws
// std::runtime_error if one fails.
void run_smoke(const Options& options);

}  // namespace bench
