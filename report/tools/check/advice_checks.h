#pragma once
// Checks of one project that advice stands on.

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

// Keeps the light that documents leave out.
class LightKeeper : public WatchedProject {
 public:
  // kept: outlives this.
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

// The project at that path with another text, by other random numbers than those of the run's seed:
// what was chosen by the same ones may owe something to them. progress, and the files of the run,
// outlive it.
CheckText check_by_other_numbers(const std::string& path, const check::Run& run,
                                 Progress& progress);

// What check --advice says of a project that this run has checked; bytes: of its file.
std::vector<report::LevelAdvice> advice_on(const report::ProjectPart& part,
                                           const std::string& bytes, const check::Run& run,
                                           Progress& progress);

}  // namespace cli
