#pragma once
// Progress, Ctrl-C and counts of sampling rounds of a project in a batch.

#include "calc/radiosity/looks/solve.h"
#include "report/check/observer.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace cli {

class WatchedProject : public check::Observer {
 public:
  WatchedProject(Progress& progress, const std::string& path) : progress_(progress, path) {}

  void start_project(std::size_t spaces) override { progress_.start_project(spaces); }
  void start_space(const std::string& id) override { progress_.start_space(id); }
  bool go_on(const calc::SolveProgress& progress) override {
    progress_.update(progress);
    return !interrupted();
  }
  bool is_stopped() const override { return interrupted(); }
  void solved(const std::string& /*project_path*/, const std::string& /*space_id*/,
              const calc::PreparedScene& /*scene*/, const std::vector<calc::PlaneTask>& /*tasks*/,
              const calc::SpaceSolution& solution) override {
    const std::scoped_lock lock(mutex_);
    looks_.read += solution.looks.read;
    looks_.computed += solution.looks.computed;
  }
  // Returns the counts, once the project is done.
  const calc::LookCounts& looks() const { return looks_; }

 private:
  ProjectProgress progress_;
  std::mutex mutex_;  // spaces are solved at the same time
  calc::LookCounts looks_;
};

}  // namespace cli
