#include "report/shell/output/progress.h"

#include "report/shell/process/print.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cli {

using namespace std::chrono_literals;

ProgressStyle progress_style(const OutputOptions& output, const Environment& environment) {
  if (output.quiet) return ProgressStyle::none;
  return environment.stderr_is_terminal ? ProgressStyle::one_line : ProgressStyle::log;
}

std::string rough_time(double seconds) {
  constexpr double kMinute_s = 60.0, kHour_s = 3600.0;
  const auto rough = [](double count, const char* unit) {
    return fmt::format("about {:.0f} {}", std::max(1.0, std::round(count)), unit);
  };
  if (seconds < 1.5 * kMinute_s) return rough(seconds, "s");
  if (seconds < 1.5 * kHour_s) return rough(seconds / kMinute_s, "min");
  return rough(seconds / kHour_s, "h");
}

namespace {

// Within the terminal's width, since a line that wraps cannot be written over: the place gives way.
std::string in_one_line(const std::string& counts, const std::string& place,
                        const std::string& work, int columns) {
  constexpr std::size_t kShortestPlace = 12;
  const std::string start = counts.empty() ? "" : counts + "; ";
  const std::size_t used = report::display_width(start) + report::display_width(work) + 1;
  const auto available = static_cast<std::size_t>(std::max(columns, 0));
  if (columns <= 0 || used + report::display_width(place) <= available) return start + place + work;
  if (used + kShortestPlace > available) {
    return report::shorten_start(counts.empty() ? place : counts,
                                 std::max<std::size_t>(available, 2) - 1);
  }
  return start + report::shorten_start(place, available - used) + work;
}

}  // namespace

void Progress::expect(std::size_t projects) {
  const std::scoped_lock lock(mutex_);
  projects_ += projects;
}

std::string Progress::counts() const {
  if (projects_ <= 1) return {};
  std::string words = fmt::format("{} of {} {} done", done_, projects_, what_);
  if (done_ == 0 || done_ >= projects_) return words;
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = static_cast<double>(projects_ - done_) / static_cast<double>(done_);
  return words + ", " + rough_time(elapsed_s * left) + " left";
}

void Progress::update(const std::string& place, const calc::SolveProgress& solve) {
  if (style_ != ProgressStyle::one_line) return;
  const Clock::time_point now = Clock::now();
  const std::scoped_lock lock(mutex_);
  if (now - start_ < 500ms || now - last_shown_ < 100ms) return;
  last_shown_ = now;
  remove_line();
  const std::string line =
      in_one_line(counts(), place,
                  fmt::format(": {} of {} planes done, {} paths per replicate", solve.planes_done,
                              solve.planes, solve.paths_per_replicate),
                  columns_);
  shown_width_ = report::display_width(line);
  tell("{}", line);
  std::fflush(stderr);
}

void Progress::done(const std::string& path, const std::string& verdict) {
  constexpr auto kQuietFor = 2s;
  const std::scoped_lock lock(mutex_);
  ++done_;
  remove_line();
  if (style_ != ProgressStyle::log || projects_ <= 1) return;
  if (Clock::now() - start_ < kQuietFor) return;
  tell("luxgate: {}: {}{}{}\n", counts(), report::printable(path), verdict.empty() ? "" : ": ",
       verdict);
}

void Progress::aside(const std::function<void()>& print) {
  const std::scoped_lock lock(mutex_);
  remove_line();
  print();
}

void Progress::clear() {
  const std::scoped_lock lock(mutex_);
  remove_line();
}

void Progress::remove_line() {
  if (shown_width_ == 0) return;
  tell("\r{:{}}\r", "", shown_width_);
  std::fflush(stderr);
  shown_width_ = 0;
}

void ProjectProgress::start_project(std::size_t spaces) {
  const std::scoped_lock lock(mutex_);
  spaces_ = spaces;
}

void ProjectProgress::start_space(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  ++started_;
  space_ = id;
}

void ProjectProgress::update(const calc::SolveProgress& solve) {
  std::string place = report::printable(path_);
  {
    const std::scoped_lock lock(mutex_);
    if (spaces_ > 1) place += fmt::format(", space {} of {}", started_, spaces_);
    place += ", " + report::printable(space_);
  }
  progress_.update(place, solve);
}

}  // namespace cli
