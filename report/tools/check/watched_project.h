#pragma once
// Progress and Ctrl-C of one project of a batch.

#include "report/check/observer.h"
#include "report/shell/interrupt.h"
#include "report/shell/progress.h"

#include <cstddef>
#include <string>

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

 private:
  ProjectProgress progress_;
};

}  // namespace cli
