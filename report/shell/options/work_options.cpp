#include "report/shell/options/work_options.h"

#include "report/shell/command/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace cli {
namespace {

using check::Backend;
using check::GpuStages;

const std::vector<std::pair<std::string_view, calc::Method>> kMethods = {
    {"light-pool", calc::Method::light_pool},
    {"instant-radiosity", calc::Method::instant_radiosity}};

// A name of calc::name_of(), or "all"; forbidden besides those that are already.
ValueParser forbidden_skip(calc::SkipSet& target) {
  std::vector<std::string_view> names = calc::names_of<calc::Skip>();
  names.push_back("all");
  std::vector<std::string> words(names.begin(), names.end());
  const auto parse = [&target, names = std::move(names)](const std::string& text) -> std::string {
    if (text == "all") {
      target.forbid_all();
      return "";
    }
    if (const std::optional<calc::Skip> skip = calc::find_value<calc::Skip>(text)) {
      target.forbid(*skip);
      return "";
    }
    return one_of_message(text, names);
  };
  return {parse, std::move(words)};
}

// "light-paths,near-field": names of stages, each once, at least one.
ValueParser gpu_stages(std::optional<GpuStages>& target) {
  const auto parse = [&target](const std::string& text) -> std::string {
    GpuStages stages = GpuStages::none();
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::string_view name = std::string_view(text).substr(begin, end - begin);
      bool GpuStages::*const stage = check::find_gpu_stage(name);
      if (stage == nullptr) return one_of_message(name, check::gpu_stage_names(GpuStages()));
      if (stages.*stage) return std::string(name) + " is named twice";
      stages.*stage = true;
      begin = end + 1;
    }
    target = stages;
    return "";
  };
  const std::vector<std::string_view> names = check::gpu_stage_names(GpuStages());
  return {parse, {names.begin(), names.end()}};
}

std::string no_skip_words(const calc::SkipSet& skips) {
  calc::SkipSet none;
  none.forbid_all();
  if (skips == none) return " --no-skip all";
  std::string text;
  for (const auto& [skip, name] : calc::EnumNames<calc::Skip>::list) {
    if (!skips.allows(skip)) text += fmt::format(" --no-skip {}", name);
  }
  return text;
}

std::string method_name(calc::Method method) {
  for (const auto& [name, known] : kMethods) {
    if (known == method) return std::string(name);
  }
  return "";
}

}  // namespace

std::vector<Option> work_options(calc::RadiositySettings& settings) {
  return {
      {"--replicates", "N", "Repeat each calculation N times for its interval, 4 to 64; default 16",
       whole_number(settings.replicates, calc::kFewestReplicates, calc::kMostReplicates)},
      {"--max-paths", "N",
       "Limit light paths per replicate and plane, a power of two; default 65536",
       power_of_two(settings.max_paths, calc::kFewestPaths, calc::kMostPaths)},
      jobs_option(settings.jobs),
      {"--method", "NAME",
       "Choose the method: light-pool or instant-radiosity; default light-pool. instant-radiosity "
       "is for comparison: it connects every point with every light vertex",
       choice<calc::Method>(settings.method, kMethods)},
      {"--visibility", "NAME",
       "Choose how visibility is found: rays or shadow-map:N; default rays. shadow-map:N needs "
       "--method instant-radiosity and OpenGL. N is the number of texels along an edge of the "
       "cube, a power of two from 16 to 2048",
       visibility(settings.shadow_map_texels)},
      {"--clamp", "G",
       "Cut off geometry terms above G, in 1/m2, with --method instant-radiosity; default none. "
       "The light that is cut off is in no interval. Verdicts that more light could change are "
       "undecided",
       positive_number(settings.clamp_per_m2)},
      {"--no-skip", "NAME",
       "Calculate also what could be omitted for this reason; 'all' for every reason; repeatable. "
       "Other random numbers may then be drawn. 'luxgate plan' lists the names",
       forbidden_skip(settings.skips), true}};
}

std::vector<Option> backend_options(check::BackendRequest& request) {
  return {{"--backend", "NAME",
           "Choose the processor: auto, cpu or gpu (OpenGL compute); default auto. auto takes a "
           "GPU if there is one and enough work for it. It never takes software OpenGL. 'luxgate "
           "plan' prints the choice",
           choice<Backend>(
               request.backend,
               {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"gpu", Backend::gpu}})},
          {"--gl-device", "N",
           "Choose the OpenGL device for --backend gpu. 'luxgate devices' lists them",
           whole_number(request.gl_device, 0, 1023)},
          {"--gpu-stages", "LIST",
           "Choose what runs on the GPU with --backend gpu; default all. A list with commas of "
           "direct-light, light-paths, connections and near-field. The CPU does the rest",
           gpu_stages(request.stages)}};
}

std::string complete_work(calc::RadiositySettings& settings, const check::BackendRequest& request) {
  if (request.gl_device >= 0 && request.backend != Backend::gpu) {
    return "--gl-device needs --backend gpu";
  }
  if (request.stages && request.backend != Backend::gpu) return "--gpu-stages needs --backend gpu";
  const bool is_instant = settings.method == calc::Method::instant_radiosity;
  if (settings.shadow_map_texels > 0) {
    if (!is_instant) {
      return "--visibility shadow-map needs --method instant-radiosity; with light-pool only "
             "--visibility rays is allowed";
    }
    if (request.backend == Backend::cpu) {
      return "--visibility shadow-map draws with OpenGL: --backend auto and gpu are allowed with "
             "it, cpu is not";
    }
  }
  if (settings.clamp_per_m2 > 0.0 && !is_instant) return "--clamp needs --method instant-radiosity";
  settings.first_paths = std::min(settings.first_paths, settings.max_paths);
  return "";
}

std::string method_words(const calc::RadiositySettings& settings) {
  const calc::RadiositySettings defaults;
  std::string words;
  if (settings.method != defaults.method) {
    words += " --method " + method_name(settings.method);
  }
  if (settings.shadow_map_texels > 0) {
    words += fmt::format(" --visibility shadow-map:{}", settings.shadow_map_texels);
  }
  if (settings.clamp_per_m2 != defaults.clamp_per_m2) {
    words += fmt::format(" --clamp {}", settings.clamp_per_m2);
  }
  return words.empty() ? words : words.substr(1);
}

std::string work_words(const calc::RadiositySettings& settings,
                       const check::BackendRequest& request) {
  const std::string method = method_words(settings);
  std::string words = method.empty() ? "" : " " + method;
  words += no_skip_words(settings.skips);
  if (request.backend == Backend::cpu) words += " --backend cpu";
  if (request.backend != Backend::gpu) return words;
  words += " --backend gpu";
  if (const GpuStages stages = request.stages.value_or(GpuStages()); stages != GpuStages()) {
    words += fmt::format(" --gpu-stages {}", fmt::join(check::gpu_stage_names(stages), ","));
  }
  return words;
}

}  // namespace cli
