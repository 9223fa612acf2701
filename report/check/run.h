#pragma once
// A run of checks: its settings, files, rule packs, backend and stored light. Every tool that
// checks projects uses it, and so does a program that embeds luxgate (examples/embed).

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

// The arguments for opening a run.
struct RunRequest {
  Settings settings;                   // as problem_with() allows; without a day: the clock's
  std::vector<rules::RulePack> packs;  // that projects may cite
  BackendRequest backend;
  std::string program_folder;              // where compiled shaders are kept, "" = nowhere
  gpu::Fault gl_fault = gpu::Fault::none;  // for tests
  // Called with the plans of the projects if `auto` needs them; may be empty.
  std::function<void(const std::vector<ProjectPlan>&)> planned;
};

// A run is a value: copies share the backend, packs and stored light, so a variant costs next to
// nothing. Functions that begin with `with` return a copy with one change. Several threads may call
// all const functions at once, for one run and for its copies.
class Run {
 public:
  // Creates a run on the processor, with files of the disk and the delivered packs. Throws
  // std::invalid_argument for settings that problem_with() refuses.
  explicit Run(const Settings& settings = {});
  // Opens a run. files: must outlive the run. paths: projects by which `auto` chooses. Empty after
  // an error, such as a missing graphics device that was requested; another device is never used
  // instead. Throws as the constructor does.
  static std::optional<Run> open(RunRequest request, const calc::FileReader& files,
                                 const std::vector<std::string>& paths,
                                 calc::Diagnostics& diagnostics);

  Run with_settings(const Settings& settings) const;
  Run with_packs(std::vector<rules::RulePack> packs) const;
  // files: must outlive the copy.
  Run with_files(const calc::FileReader& files) const;
  // Replaces the text of the file at this path, whatever is on the disk.
  Run with_text(const std::string& path, std::string text) const;
  // Takes sampling rounds from there and stores them there, which never changes a result.
  // is_all_there_is: as in calc::LookStore.
  Run with_light_in(std::shared_ptr<calc::EntryStore> entries, bool is_all_there_is = false) const;
  // Uses these vertices instead of tracing. The settings must come from use_settings_of() them.
  Run with_vertices(VertexSource vertices) const;

  // Calculates and judges one project. Errors of the input and of the machine are in the part's
  // diagnostics and leave it not judged: they stop no batch. A plane without points is not judged;
  // the others are. A check that its observer stops judges nothing.
  report::ProjectPart check(const std::string& path, Observer& observer) const;
  report::ProjectPart check(const std::string& path) const;
  // Calculates the light of these units of one project without judging, so that the store has every
  // sampling round that check() will need. Returns errors: unreadable files, unknown spaces or
  // planes, and units whose light a store cannot keep.
  calc::Diagnostics light(const std::string& path, const std::vector<Unit>& units,
                          Observer& observer) const;
  // Returns what check() would do for each project.
  std::vector<ProjectPlan> plan(const std::vector<std::string>& paths) const;

  const Settings& settings() const { return settings_; }
  const calc::FileReader& files() const { return *files_; }
  const std::vector<rules::RulePack>& packs() const { return *packs_; }
  const BackendChoice& backend() const { return machine_->choice; }
  // Returns the devices that compute each part, for reports.
  const std::string& description() const { return machine_->opened.description; }
  // Returns the device that calculates; null: none does.
  const std::shared_ptr<gpu::DeviceThread>& device() const { return machine_->opened.device; }
  Hardware& hardware() const { return machine_->hardware; }
  // Returns how many projects, and spaces of each, are best calculated at the same time: one if
  // they share a device or a time limit, otherwise some for each thread.
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
