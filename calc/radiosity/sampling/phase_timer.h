#pragma once
// Wall-clock time of phases, for reports and limits; it never reaches a result.

#include <chrono>

namespace calc {

inline double now_s() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// Returns whether a deadline, of now_s(), has passed; 0 = there is none.
inline bool is_past(double deadline_s) { return deadline_s > 0.0 && now_s() > deadline_s; }

// Adds its lifetime to a phase.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& total_s) : total_s_(total_s), begin_s_(now_s()) {}
  ~PhaseTimer() { total_s_ += now_s() - begin_s_; }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& total_s_;
  double begin_s_;
};

}  // namespace calc
