#include "report/tools/vpl/vpl.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/project_xml.h"
#include "calc/scene/prepared_scene.h"
#include "report/check/drawing_device.h"
#include "report/check/vertex_source.h"
#include "report/formats/write.h"
#include "report/images/exr.h"
#include "report/images/png.h"
#include "report/shell/options/chosen_space.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/output/outputs.h"
#include "report/shell/process/print.h"
#include "report/text/number_format.h"
#include "report/tools/pictures/room_pictures.h"
#include "report/tools/vpl/vpl_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

namespace cli {
namespace {

// What readers of files take, with room for the header.
constexpr std::uint64_t kLargestFileBytes = std::uint64_t{510} << 20;

double reflected_lm(const calc::VertexCache& cache) {
  double sum = 0.0;
  for (const calc::VertexCacheBatch& batch : cache.batches) {
    const double share = static_cast<double>(batch.last - batch.first) /
                         static_cast<double>(cache.paths * static_cast<unsigned>(cache.replicates));
    for (const calc::LightVertex& vertex : batch.vertices) {
      sum += share * static_cast<double>(vertex.flux_lm);
    }
  }
  return sum;
}

std::string summary(const std::string& file, std::size_t bytes, const calc::VertexCache& cache) {
  return fmt::format(
      "Wrote {}: {} light vertices of {} paths ({} replicates of {}), {:.3g} MB\n"
      "space '{}', seed {}: {} lm of reflected flux\n",
      file, report::format_count(cache.vertices()),
      report::format_count(cache.paths * static_cast<unsigned>(cache.replicates)), cache.replicates,
      report::format_count(cache.paths), 1e-6 * static_cast<double>(bytes), cache.space_id,
      cache.seed, report::format_lumens(reflected_lm(cache)));
}

class VertexWriter {
 public:
  VertexWriter(const VplOptions& options, const RecordingReader& files,
               calc::Diagnostics& diagnostics)
      : options_(options), files_(files), diagnostics_(diagnostics) {}

  // What was written, in words; "" after an error.
  std::string run(const Environment& environment, gpu::Fault gl_fault) {
    const std::optional<calc::Project> project =
        calc::load_project(files_, options_.project, diagnostics_);
    if (!project || diagnostics_.has_errors()) return "";
    const calc::Space* space = find_chosen_space(*project, options_.space, diagnostics_);
    if (space == nullptr || !can_write() || !open_device(environment, gl_fault)) return "";
    const calc::PreparedScene scene = calc::prepare_scene(*project, *space);
    calc::RadiositySettings settings = options_.radiosity;
    settings.first_paths = std::min(settings.first_paths, settings.max_paths);
    calc::TracedCache traced = calc::trace_vertex_cache(scene, settings);
    if (!traced.cache) {
      diagnostics_.report(calc::DiagnosticId::no_vertex_cache, space->where, space->id,
                          traced.problem);
      return "";
    }
    traced.cache->made_by = check::vertex_maker();
    traced.cache->space_id = space->id;
    std::string text;
    if (!options_.output.empty() && !write_cache(*traced.cache, text)) return "";
    if (!options_.view.empty() && !write_view(*traced.cache, *space, scene, text)) return "";
    return text;
  }

 private:
  bool fail(const std::string& problem) {
    diagnostics_.report(calc::DiagnosticId::output_not_possible, {}, problem);
    return false;
  }

  bool can_write() {
    std::set<std::string> taken;
    for (const std::string& input : files_.paths()) taken.insert(path_identity(input));
    for (const std::string& file : {options_.output, options_.view}) {
      if (file.empty()) continue;
      if (!taken.insert(path_identity(file)).second) {
        return fail(fmt::format("'{}' is an input or another output and is not overwritten", file));
      }
      if (const std::string problem = writability(file); !problem.empty()) return fail(problem);
    }
    return true;
  }

  bool open_device(const Environment& environment, gpu::Fault gl_fault) {
    if (options_.view.empty()) return true;
    check::PictureDevice::Request request;
    request.fault = gl_fault;
    request.program_folder = environment.program_folder;
    request.warn = [this](const std::string& failure) {
      diagnostics_.report(calc::DiagnosticId::picture_device_failed, {}, failure);
    };
    if (options_.gl_device >= 0) {
      request.choice.device = options_.gl_device;
    } else {
      check::Hardware hardware(gl_fault, environment.program_folder);
      request.choice = check::choose_to_draw(hardware, view_work);
    }
    picture_device_.emplace(std::move(request));
    std::string problem;
    device_ = picture_device_->get(problem);
    return device_ != nullptr || fail(fmt::format("cannot draw '{}': {}", options_.view, problem));
  }

  bool write_cache(const calc::VertexCache& cache, std::string& text) {
    if (calc::vertex_ply_bytes(cache) > kLargestFileBytes) {
      return fail(
          fmt::format("'{}' would have {:.0f} MB; at most {} MB can be read: take fewer paths or "
                      "replicates",
                      options_.output, 1e-6 * static_cast<double>(calc::vertex_ply_bytes(cache)),
                      kLargestFileBytes / 1'000'000));
    }
    const std::string bytes = calc::render_vertex_ply(cache);
    if (!write(options_.output, bytes)) return false;
    text += summary(options_.output, bytes.size(), cache);
    return true;
  }

  // One look of one replicate: of all of them dots would hide the room.
  bool write_view(const calc::VertexCache& cache, const calc::Space& space,
                  const calc::PreparedScene& scene, std::string& text) {
    const calc::VertexCacheBatch& shown = cache.batches.front();
    std::string bytes;
    try {
      const report::Raster raster =
          draw_vertices(*device_, calc::Tracer(scene), shown.vertices, opens(space));
      bytes = is_exr(options_.view)
                  ? report::render_colour_exr(options_.project, space.id, "light vertices", raster)
                  : report::encode_png(raster);
    } catch (const std::runtime_error& error) {  // calc::BackendFailure too
      return fail(fmt::format("cannot draw '{}': {}", options_.view, error.what()));
    }
    if (!write(options_.view, bytes)) return false;
    text += fmt::format("Wrote {}: {} light vertices of {} paths, drawn by {}{}\n", options_.view,
                        report::format_count(shown.vertices.size()),
                        report::format_count(shown.last - shown.first), device_->device().name(),
                        device_->device().is_software ? " (software)" : "");
    return true;
  }

  bool write(const std::string& file, const std::string& bytes) {
    const std::string problem = report::write_file_atomically(file, bytes);
    return problem.empty() || fail(fmt::format("cannot write '{}': {}", file, problem));
  }

  const VplOptions& options_;
  const RecordingReader& files_;
  calc::Diagnostics& diagnostics_;
  std::optional<check::PictureDevice> picture_device_;
  gpu::DeviceThread* device_ = nullptr;  // of picture_device_
};

CommandOutcome run_vpl(const VplOptions& options, const calc::FileReader& disk,
                       const Environment& environment, gpu::Fault gl_fault) {
  const RecordingReader files(disk);
  calc::Diagnostics diagnostics;
  CommandOutcome outcome;
  outcome.text = VertexWriter(options, files, diagnostics).run(environment, gl_fault);
  if (outcome.text.empty()) outcome.code = kNotJudged;
  outcome.diagnostics = diagnostics.all();
  return outcome;
}

}  // namespace

Command vpl_command() {
  const auto options = std::make_shared<VplOptions>();
  Command command = vpl_syntax(*options);
  command.run = [options](const RunContext& context) {
    return print_outcome(run_vpl(*options, calc::DiskFileReader(options->allowed),
                                 context.environment, context.gl_fault));
  };
  return command;
}

}  // namespace cli
