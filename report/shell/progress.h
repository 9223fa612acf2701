#pragma once
// One line on standard error that says how far the calculation is; only for people at a terminal.

#include "calc/radiosity/solve.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace cli {

class Progress {
 public:
  // Shows nothing if not enabled, and nothing for work that ends within half a second.
  explicit Progress(bool enabled) : enabled_(enabled), start_(Clock::now()) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  void start_project(const std::string& path) { project_ = path; }
  void start_space(const std::string& name) { space_ = name; }
  void update(const calc::SolveProgress& solve);
  // Removes the line, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool enabled_;
  Clock::time_point start_;
  Clock::time_point last_shown_{};
  std::size_t shown_width_ = 0;
  std::string project_, space_;
};

}  // namespace cli
