#pragma once
// Shows the progress of a run on standard error: at a terminal one line that is overwritten;
// elsewhere (in the log of a job) a line for each finished project, once a run of several has
// lasted a while.

#include "calc/radiosity/looks/solve.h"
#include "report/shell/output/output_options.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace cli {

enum class ProgressStyle { none, one_line, log };
// Returns the style; none with --quiet.
ProgressStyle progress_style(const OutputOptions& output, const Environment& environment);

// The progress of a run. Several projects may be in work at the same time: any thread may call.
class Progress {
 public:
  // columns: of the terminal; 0: not known. what: the finished things, in the plural.
  explicit Progress(ProgressStyle style, int columns = 0, std::string what = "projects")
      : style_(style), columns_(columns), what_(std::move(what)), start_(Clock::now()) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  // Announces this many further projects.
  void expect(std::size_t projects);
  // Shows a place: "office.xml, room 3 of 12, meeting". Shows nothing for work that ends soon.
  void update(const std::string& place, const calc::SolveProgress& solve);
  // Shows a finished project; called in their order.
  void done(const std::string& path, const std::string& verdict = "");
  // Prints other text while the line is removed.
  void aside(const std::function<void()>& print);
  // Removes the line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void remove_line();
  std::string counts() const;  // "12 of 200 projects done, about 3 min left"; "" of a single one

  const ProgressStyle style_;
  const int columns_;
  const std::string what_;
  const Clock::time_point start_;
  std::mutex mutex_;
  Clock::time_point last_shown_{};
  std::size_t shown_width_ = 0;
  std::size_t projects_ = 0, done_ = 0;
};

// Returns "about 40 s", "about 3 min", "about 2 h" for seconds, at least one.
std::string rough_time(double seconds);

// The progress inside a project.
class ProjectProgress {
 public:
  ProjectProgress(Progress& progress, std::string path)
      : progress_(progress), path_(std::move(path)) {}

  void start_project(std::size_t spaces);
  void start_space(const std::string& id);
  void update(const calc::SolveProgress& solve);

 private:
  Progress& progress_;
  const std::string path_;
  std::mutex mutex_;
  std::size_t spaces_ = 0, started_ = 0;
  std::string space_;  // that was begun last
};

}  // namespace cli
