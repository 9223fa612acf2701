#include "report/shell/progress.h"

#include <fmt/format.h>

#include <cstdio>

namespace cli {

void Progress::update(const calc::SolveProgress& solve) {
  using namespace std::chrono_literals;
  const Clock::time_point now = Clock::now();
  if (!enabled_ || now - start_ < 500ms || now - last_shown_ < 100ms) return;
  last_shown_ = now;
  clear();
  const std::string line =
      fmt::format("{} {}: {} of {} planes done, {} paths per replicate", project_, space_,
                  solve.planes_done, solve.planes, solve.paths_per_replicate);
  shown_width_ = line.size();
  fmt::print(stderr, "{}", line);
  std::fflush(stderr);
}

void Progress::clear() {
  if (shown_width_ == 0) return;
  fmt::print(stderr, "\r{:{}}\r", "", shown_width_);
  std::fflush(stderr);
  shown_width_ = 0;
}

}  // namespace cli
