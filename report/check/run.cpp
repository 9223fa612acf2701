#include "report/check/run.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/store/entry_store.h"
#include "report/check/check_project.h"

#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace check {
namespace {

// Every other file is as it is.
class ChangedFile : public calc::FileReader {
 public:
  ChangedFile(std::shared_ptr<const calc::FileReader> files, std::string path, std::string text)
      : files_(std::move(files)), path_(std::move(path)), text_(std::move(text)) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override {
    if (path == path_) return {text_, ""};
    return files_->read_within(folder, path);
  }

 private:
  const std::shared_ptr<const calc::FileReader> files_;
  const std::string path_, text_;
};

// Of somebody else.
std::shared_ptr<const calc::FileReader> borrowed(const calc::FileReader& files) {
  return {std::shared_ptr<const calc::FileReader>(), &files};
}

// One day, even over midnight.
Settings completed(const Settings& settings) {
  if (const std::string problem = problem_with(settings); !problem.empty()) {
    throw std::invalid_argument(problem);
  }
  Settings complete = settings;
  complete.today = day_of(settings);
  return complete;
}

std::vector<ProjectPlan> planned(const std::vector<std::string>& paths,
                                 const calc::FileReader& files,
                                 const std::vector<rules::RulePack>& packs,
                                 const Settings& settings) {
  return plan_projects(paths, files, packs, settings.radiosity, settings.today, settings.budget,
                       settings.selection);
}

// Whatever goes wrong in one project must not stop the others.
template <class Work>
void report_failures(const std::string& path, calc::Diagnostics& diagnostics, const Work& work) {
  const calc::SourceLocation where{path, 0, 0};
  try {
    work();
  } catch (const calc::BackendFailure& failure) {
    diagnostics.report(calc::DiagnosticId::backend_failed, where, failure.what());
  } catch (const std::bad_alloc&) {
    diagnostics.report(calc::DiagnosticId::not_enough_memory, where);
  } catch (const std::exception& error) {
    diagnostics.report(calc::DiagnosticId::internal_error, where, error.what());
  }
}

}  // namespace

Run::Run(Settings settings, Packs packs, std::shared_ptr<const calc::FileReader> files,
         std::shared_ptr<Machine> machine)
    : settings_(std::move(settings)),
      packs_(std::move(packs)),
      files_(std::move(files)),
      machine_(std::move(machine)) {}

Run::Run(const Settings& settings)
    : Run(completed(settings),
          std::make_shared<const std::vector<rules::RulePack>>(rules::builtin_rule_packs()),
          std::make_shared<const calc::DiskFileReader>(), nullptr) {
  BackendChoice choice;
  std::string problem, warning;
  OpenBackend opened = *open_backend(choice, gpu::Fault::none, "", problem, warning);
  machine_ = std::make_shared<Machine>(
      Machine{Hardware(gpu::Fault::none, ""), std::move(choice), std::move(opened)});
}

std::optional<Run> Run::open(RunRequest request, const calc::FileReader& files,
                             const std::vector<std::string>& paths,
                             calc::Diagnostics& diagnostics) {
  Settings settings = completed(request.settings);
  auto packs = std::make_shared<const std::vector<rules::RulePack>>(std::move(request.packs));
  Hardware hardware(request.gl_fault, request.program_folder);
  BackendChoice choice =
      choose_backend(request.backend, settings.radiosity.shadow_map_texels, hardware, [&] {
        const std::vector<ProjectPlan> plans = planned(paths, files, *packs, settings);
        if (request.planned) request.planned(plans);
        return first_look_work(plans, settings.radiosity);
      });
  std::string problem, software;
  std::optional<OpenBackend> opened =
      open_backend(choice, request.gl_fault, request.program_folder, problem, software);
  if (!opened) {
    diagnostics.report(calc::DiagnosticId::backend_not_available, {}, "gpu", problem);
    return std::nullopt;
  }
  if (!software.empty()) {
    diagnostics.report(calc::DiagnosticId::backend_is_software, {}, software);
  }
  return Run(std::move(settings), std::move(packs), borrowed(files),
             std::make_shared<Machine>(
                 Machine{std::move(hardware), std::move(choice), *std::move(opened)}));
}

Run Run::with_settings(const Settings& settings) const {
  Run copy = *this;
  copy.settings_ = completed(settings);
  return copy;
}

Run Run::with_packs(std::vector<rules::RulePack> packs) const {
  Run copy = *this;
  copy.packs_ = std::make_shared<const std::vector<rules::RulePack>>(std::move(packs));
  return copy;
}

Run Run::with_files(const calc::FileReader& files) const {
  Run copy = *this;
  copy.files_ = borrowed(files);
  return copy;
}

Run Run::with_text(const std::string& path, std::string text) const {
  Run copy = *this;
  copy.files_ = std::make_shared<const ChangedFile>(files_, path, std::move(text));
  return copy;
}

Run Run::with_light_in(std::shared_ptr<calc::EntryStore> entries, bool is_all_there_is) const {
  Run copy = *this;
  copy.entries_ = std::move(entries);
  copy.is_all_there_is_ = is_all_there_is;
  return copy;
}

Run Run::with_vertices(VertexSource vertices) const {
  Run copy = *this;
  copy.vertices_ = std::make_shared<const VertexSource>(std::move(vertices));
  return copy;
}

report::ProjectPart Run::check(const std::string& path, Observer& observer) const {
  report::ProjectPart part;
  calc::Diagnostics failures;
  report_failures(path, failures, [&] { part = check_project(path, *this, observer); });
  if (!failures.has_errors()) return part;
  report::ProjectPart failed;
  failed.path = path;
  failed.diagnostics = failures.all();
  return failed;
}

report::ProjectPart Run::check(const std::string& path) const {
  Observer nobody;
  return check(path, nobody);
}

calc::Diagnostics Run::light(const std::string& path, const std::vector<Unit>& units,
                             Observer& observer) const {
  calc::Diagnostics diagnostics, failures;
  report_failures(path, failures, [&] { diagnostics = light_units(path, units, *this, observer); });
  diagnostics.add(failures);
  return diagnostics;
}

std::vector<ProjectPlan> Run::plan(const std::vector<std::string>& paths) const {
  return planned(paths, *files_, *packs_, settings_);
}

std::optional<calc::LookStore> Run::store() const {
  if (entries_ == nullptr) return std::nullopt;
  return calc::LookStore{*entries_, machine_->opened.identity, is_all_there_is_};
}

Concurrency Run::concurrency() const {
  const calc::RadiositySettings& radiosity = settings_.radiosity;
  if (backend().backend == Backend::gpu || radiosity.time_limit_s > 0.0) return {radiosity.jobs, 1};
  constexpr std::size_t kForEachThread = 2;  // so that nobody waits while results are written
  return {radiosity.jobs, kForEachThread * static_cast<std::size_t>(calc::thread_count(radiosity))};
}

}  // namespace check
