#include "calc/project/project_files.h"

#include "calc/base/file_hash.h"
#include "calc/base/relative_path.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web_hermite.h"
#include "calc/project/point_list_csv.h"

#include <vector>

namespace calc {
namespace {

// The same light from the middle of the luminaire.
PhotometricWeb without_opening(const PhotometricWeb& web) {
  std::vector<double> intensity_cd;
  for (std::size_t c = 0; c < web.c_rad().size(); ++c) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) {
      intensity_cd.push_back(web.table_cd(c, g));
    }
  }
  return PhotometricWeb::make(web.c_rad(), web.gamma_rad(), std::move(intensity_cd),
                              LuminousOpening{}, web.source(), web.axis());
}

}  // namespace

ProjectFiles::ProjectFiles(const FileReader& reader, Project& project, Diagnostics& diagnostics)
    : reader_(reader), project_(project), diagnostics_(diagnostics) {}

std::optional<std::string> ProjectFiles::read_project() {
  FileContent content = reader_.read(project_.path);
  if (!content.ok()) {
    diagnostics_.report(DiagnosticId::file_not_readable, SourceLocation{project_.path},
                        project_.path, content.error);
    return std::nullopt;
  }
  project_.inputs.push_back({project_.path, sha256_hex(content.bytes)});
  return std::move(content.bytes);
}

std::optional<std::string> ProjectFiles::resolve(const std::string& path,
                                                 const SourceLocation& named_at) {
  std::optional<std::string> key = normalize_relative_path(path);
  if (!key) diagnostics_.report(DiagnosticId::file_outside_project, named_at, path);
  return key;
}

std::string ProjectFiles::full_path(const std::string& key) const {
  const std::size_t slash = project_.path.rfind('/');
  return slash == std::string::npos ? key : project_.path.substr(0, slash + 1) + key;
}

std::optional<std::string> ProjectFiles::read(const std::string& key, const std::string& as_named,
                                              const SourceLocation& named_at) {
  const std::string folder = full_path("");
  FileContent content = reader_.read_within(folder.empty() ? "." : folder, full_path(key));
  if (content.is_outside) {
    diagnostics_.report(DiagnosticId::file_link_outside, named_at, full_path(key));
    return std::nullopt;
  }
  if (!content.ok()) {
    diagnostics_.report(DiagnosticId::file_not_readable, named_at, full_path(key), content.error);
    return std::nullopt;
  }
  if (recorded_.insert(key).second) {
    project_.inputs.push_back({as_named, sha256_hex(content.bytes)});
  }
  return std::move(content.bytes);
}

const std::optional<LuminaireLight>& ProjectFiles::photometry(const FileLight& light,
                                                              const std::string& as_named,
                                                              const SourceLocation& named_at,
                                                              PhotometryOptions options) {
  const auto [entry, is_new] = photometry_.try_emplace(light);
  if (!is_new) return entry->second;
  const std::string& key = std::get<0>(light);
  options.read_companion = [&](const std::string& file_name) -> std::optional<std::string> {
    const std::size_t slash = key.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : key.substr(0, slash + 1);
    return read(folder + file_name, folder + file_name, named_at);
  };
  if (const std::optional<std::string> bytes = read(key, as_named, named_at)) {
    entry->second = parse_luminaire_light(*bytes, full_path(key), diagnostics_, options);
  }
  return entry->second;
}

std::vector<PlacedWeb> ProjectFiles::light(const std::string& path, const WebUse& use,
                                           const SourceLocation& named_at,
                                           const PhotometryOptions& options) {
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return {};
  const FileLight chosen{*key, options.lamp_set, options.variant, options.emitter};
  const auto [entry, is_new] = webs_.try_emplace({chosen, use.as_point, use.is_cubic});
  if (!is_new) return entry->second;
  const std::optional<LuminaireLight>& light = photometry(chosen, path, named_at, options);
  if (!light) return {};
  for (const EmitterLight& emitter : light->emitters) {
    const PhotometricWeb shaped = use.as_point ? without_opening(emitter.web) : emitter.web;
    project_.webs.push_back(use.is_cubic ? hermite_refined(shaped) : shaped);
    entry->second.push_back({project_.webs.size() - 1, emitter.id, emitter.place});
  }
  return entry->second;
}

const TriangleMesh* ProjectFiles::mesh(const std::string& path, std::optional<MeshFormat> format,
                                       const SourceLocation& named_at) {
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return nullptr;
  const auto [entry, is_new] = meshes_.try_emplace(*key);
  if (is_new) {
    const std::string folder = key->substr(0, key->rfind('/') + 1);  // "" = the project's
    const SideFiles side_files = [&](const std::string& name) {
      return read(folder + name, folder + name, {full_path(*key), 0, 0});
    };
    if (const std::optional<std::string> bytes = read(*key, path, named_at)) {
      entry->second = parse_mesh_file(*bytes, full_path(*key), side_files, diagnostics_, format);
    }
  }
  if (!entry->second) return nullptr;
  if (format && *format != entry->second->format) {  // the file is used twice
    diagnostics_.report(DiagnosticId::mesh_other_format, named_at, name_of(*format),
                        name_of(entry->second->format));
    return nullptr;
  }
  return &*entry->second;
}

const GbxmlBuilding* ProjectFiles::building(const std::string& path,
                                            const SourceLocation& named_at) {
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return nullptr;
  const auto [entry, is_new] = buildings_.try_emplace(*key);
  if (is_new) {
    if (std::optional<std::string> bytes = read(*key, path, named_at)) {
      entry->second = parse_gbxml(std::move(*bytes), full_path(*key), diagnostics_);
    }
  }
  return entry->second ? &*entry->second : nullptr;
}

const LuminaireList* ProjectFiles::luminaire_list(const std::string& path,
                                                  const SourceLocation& named_at) {
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return nullptr;
  const auto [entry, is_new] = luminaire_lists_.try_emplace(*key);
  if (is_new) {
    if (const std::optional<std::string> bytes = read(*key, path, named_at)) {
      entry->second = parse_luminaire_list(*bytes, full_path(*key), diagnostics_);
    }
  }
  return entry->second ? &*entry->second : nullptr;
}

const std::optional<PointList>& ProjectFiles::point_list(const std::string& path,
                                                         const SourceLocation& named_at) {
  static const std::optional<PointList> kNone;
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return kNone;
  const auto [entry, is_new] = point_lists_.try_emplace(*key);
  if (is_new) {
    if (const std::optional<std::string> bytes = read(*key, path, named_at)) {
      entry->second = parse_point_list(*bytes, full_path(*key), diagnostics_);
    }
    if (entry->second) entry->second->file = path;
  }
  return entry->second;
}

}  // namespace calc
