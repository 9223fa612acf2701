#pragma once
// Checks of a project for advice.

#include "report/advice/find_advice.h"
#include "report/advice/kept_light.h"
#include "report/check/run.h"
#include "report/document/document.h"
#include "report/document/level_advice.h"
#include "report/shell/output/progress.h"
#include "report/tools/check/watched_project.h"

#include <string>
#include <vector>

namespace cli {

// Keeps the light that documents omit.
class LightKeeper : public WatchedProject {
 public:
  // kept: must outlive this.
  LightKeeper(Progress& progress, const std::string& path, KeptLight& kept)
      : WatchedProject(progress, path), kept_(kept) {}

  void solved(const std::string& project, const std::string& space,
              const calc::PreparedScene& scene, const std::vector<calc::PlaneTask>& tasks,
              const calc::SpaceSolution& solution) override {
    WatchedProject::solved(project, space, scene, tasks, solution);
    kept_.keep(tasks, solution);
  }

 private:
  KeptLight& kept_;
};

// Returns a check of the project at that path with another text and other random numbers than the
// run's seed, because a choice by the same numbers may profit from them. progress, and the files of
// the run, must outlive it.
CheckText check_by_other_numbers(const std::string& path, const check::Run& run,
                                 Progress& progress);

// Returns the advice of check --advice for a project that this run has checked. bytes: of its file.
std::vector<report::LevelAdvice> advice_on(const report::ProjectPart& part,
                                           const std::string& bytes, const check::Run& run,
                                           Progress& progress);

}  // namespace cli
