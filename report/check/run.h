#pragma once
// A run of checks: how is calculated, which files are read, which rule packs hold, who calculates
// and which light is kept. Every tool that checks projects stands on it, and so does a program that
// embeds luxgate (examples/embed).

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/radiosity/looks/solve.h"
#include "report/check/backend.h"
#include "report/check/hardware.h"
#include "report/check/in_order.h"
#include "report/check/observer.h"
#include "report/check/plan.h"
#include "report/check/settings.h"
#include "report/check/units.h"
#include "report/check/vertex_source.h"
#include "report/document/document.h"
#include "rules/pack/rule_pack.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace calc {
class EntryStore;
}

namespace check {

// What a run is opened with.
struct RunRequest {
  Settings settings;                   // as problem_with() allows; without a day: the clock's
  std::vector<rules::RulePack> packs;  // that projects may cite
  BackendRequest backend;
  std::string program_folder;              // where compiled shaders are kept, "" = nowhere
  gpu::Fault gl_fault = gpu::Fault::none;  // for tests
  // Called with the plans of the projects if `auto` needs them; may be empty.
  std::function<void(const std::vector<ProjectPlan>&)> planned;
};

// A value: copies share the backend, packs and kept light, so that a variant costs next to nothing.
// What begins with `with` gives a copy in which one thing is other. All that is const may be called
// by several threads at once, for one run and for its copies.
class Run {
 public:
  // On the processor, with files of the disk and the delivered packs. Throws std::invalid_argument
  // for settings that problem_with() refuses.
  explicit Run(const Settings& settings = {});
  // files: outlive the run. paths: of the projects by which `auto` chooses. Empty after an error,
  // such as a graphics device that was asked for and is not there: another one is never taken
  // instead. Throws as the constructor does.
  static std::optional<Run> open(RunRequest request, const calc::FileReader& files,
                                 const std::vector<std::string>& paths,
                                 calc::Diagnostics& diagnostics);

  Run with_settings(const Settings& settings) const;
  Run with_packs(std::vector<rules::RulePack> packs) const;
  // files: outlive the copy.
  Run with_files(const calc::FileReader& files) const;
  // The file at this path has another text, whatever becomes of it on the disk.
  Run with_text(const std::string& path, std::string text) const;
  // Looks are taken from there and kept there, which never changes a result. is_all_there_is: as of
  // calc::LookStore.
  Run with_light_in(std::shared_ptr<calc::EntryStore> entries, bool is_all_there_is = false) const;
  // Instead of tracing; the settings are use_settings_of() it.
  Run with_vertices(VertexSource vertices) const;

  // Calculates and judges one project. Errors, of the input and of the machine, are in the part's
  // diagnostics and leave it not judged: they stop no batch. A plane without points is not judged,
  // the others are. A check that its observer stops has judged nothing.
  report::ProjectPart check(const std::string& path, Observer& observer) const;
  report::ProjectPart check(const std::string& path) const;
  // Calculates the light of these units of one project, so that the store has every look that
  // check() will ask for; nothing is judged. Errors: what cannot be read, and units whose light a
  // store cannot keep or whose spaces or planes there are not.
  calc::Diagnostics light(const std::string& path, const std::vector<Unit>& units,
                          Observer& observer) const;
  // What check() would do, of each project.
  std::vector<ProjectPlan> plan(const std::vector<std::string>& paths) const;

  const Settings& settings() const { return settings_; }
  const calc::FileReader& files() const { return *files_; }
  const std::vector<rules::RulePack>& packs() const { return *packs_; }
  const BackendChoice& backend() const { return machine_->choice; }
  // Who computes which part, for reports.
  const std::string& description() const { return machine_->opened.description; }
  // That calculates; null: none does.
  const std::shared_ptr<gpu::DeviceThread>& device() const { return machine_->opened.device; }
  Hardware& hardware() const { return machine_->hardware; }
  // How many projects, and spaces of each, are best calculated at the same time: one where a device
  // or a time limit is shared among them, else some for each thread.
  Concurrency concurrency() const;

  // For check_project().
  calc::Stages stages() const { return machine_->opened.stages(); }
  std::optional<calc::LookStore> store() const;
  const VertexSource* vertices() const { return vertices_.get(); }

 private:
  struct Machine {
    Hardware hardware;
    BackendChoice choice;
    OpenBackend opened;
  };
  using Packs = std::shared_ptr<const std::vector<rules::RulePack>>;

  Run(Settings settings, Packs packs, std::shared_ptr<const calc::FileReader> files,
      std::shared_ptr<Machine> machine);

  Settings settings_;
  Packs packs_;
  std::shared_ptr<const calc::FileReader> files_;
  std::shared_ptr<Machine> machine_;
  std::shared_ptr<calc::EntryStore> entries_;  // null: no light is kept
  bool is_all_there_is_ = false;
  std::shared_ptr<const VertexSource> vertices_;
};

}  // namespace check
