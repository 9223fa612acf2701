#pragma once
// Memory of this process, where the system tells (Linux); NaN elsewhere.

namespace bench {

double used_memory_mib();
// Since the start or the last reset.
double peak_memory_mib();
// Gives freed memory back and lets the peak begin anew; without effect where the system does not
// allow it (peaks then only grow, which is right as long as sizes do).
void reset_peak_memory();

}  // namespace bench
