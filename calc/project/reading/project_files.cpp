#include "calc/project/reading/project_files.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_hash.h"
#include "calc/base/relative_path.h"
#include "calc/base/xml_encoding.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web_hermite.h"
#include "calc/project/reading/logo.h"
#include "calc/project/reading/point_list_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
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

// Of the table, and of what is made of it for many directions at once.
double web_bytes(const PhotometricWeb& web) {
  constexpr double kSketch = 250.0e3;
  return kSketch + 8.0 * static_cast<double>(web.c_rad().size() * web.gamma_rad().size());
}

// While a file is read everything in it stands there several times.
constexpr double kMeshByteFactor = 12.0, kTableByteFactor = 12.0;
// It stays, and reports hold it as text.
constexpr double kLogoByteFactor = 4.0;

}  // namespace

bool is_named_as_other_than_photometry(std::string_view path) {
  constexpr std::array<std::string_view, 10> kEndings{".csv", ".obj", ".stl", ".ply", ".gltf",
                                                      ".glb", ".bin", ".xml", ".png", ".svg"};
  std::string lower(path);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return lower.ends_with(ending); });
}

ProjectFiles::ProjectFiles(const FileReader& reader, Project& project, Diagnostics& diagnostics,
                           const Budget& budget)
    : reader_(reader), project_(project), diagnostics_(diagnostics), budget_(budget) {}

bool ProjectFiles::take(double bytes, const SourceLocation& where, std::string_view what) {
  const double all = taken_bytes_ + bytes;
  if (all > budget_[BudgetOf::memory]) {
    report_beyond(diagnostics_, where, what, BudgetOf::memory, all, budget_);
    return false;
  }
  taken_bytes_ = all;
  return true;
}

std::optional<std::string> ProjectFiles::read_project() {
  // Who may change a folder may put a link into it that others name: "designs/*.xml".
  const std::string folder = full_path("");
  FileContent content = reader_.read_within(folder.empty() ? "." : folder, project_.path);
  if (content.is_outside) {
    diagnostics_.report(DiagnosticId::file_link_outside, SourceLocation{project_.path},
                        project_.path);
    return std::nullopt;
  }
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

bool ProjectFiles::take_file(std::string_view bytes, double factor, const SourceLocation& named_at,
                             const std::string& path) {
  return take(factor * static_cast<double>(bytes.size()), named_at,
              "'" + path + "' brings the project to");
}

const std::optional<LuminaireLight>& ProjectFiles::photometry(const FileLight& light,
                                                              const std::string& as_named,
                                                              const SourceLocation& named_at,
                                                              PhotometryOptions options) {
  const auto [entry, is_new] = photometry_.try_emplace(light);
  if (!is_new) return entry->second;
  const std::string& key = std::get<0>(light);
  bool is_alone = true;
  options.read_companion = [&](const std::string& file_name) -> std::optional<std::string> {
    is_alone = false;
    if (is_named_as_other_than_photometry(file_name)) {
      diagnostics_.report(
          DiagnosticId::file_of_other_kind, named_at,
          fmt::format("'{}' refers to '{}', whose name is that of a mesh, a table or an XML "
                      "file; a photometry file is needed",
                      full_path(key), file_name));
      return std::nullopt;
    }
    const std::size_t slash = key.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : key.substr(0, slash + 1);
    return read(folder + file_name, folder + file_name, named_at);
  };
  if (const std::optional<std::string> bytes = read(key, as_named, named_at)) {
    entry->second = parse_luminaire_light(*bytes, full_path(key), diagnostics_, options);
    if (is_alone) hash_.emplace(light, sha256_hex(*bytes));
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
  std::vector<PlacedWeb>* same = nullptr;
  if (const auto hash = hash_.find(chosen); hash != hash_.end()) {
    FileLight choices = chosen;
    std::get<0>(choices).clear();
    same = &same_light_[{hash->second, choices, use.as_point, use.is_cubic}];
    if (!same->empty()) return entry->second = *same;
  }
  for (const EmitterLight& emitter : light->emitters) {
    const PhotometricWeb shaped = use.as_point ? without_opening(emitter.web) : emitter.web;
    PhotometricWeb web = use.is_cubic ? hermite_refined(shaped) : shaped;
    if (!take(web_bytes(web), named_at, "the photometry of '" + path + "' brings the project to")) {
      entry->second.clear();
      return {};
    }
    project_.webs.push_back(std::move(web));
    entry->second.push_back({project_.webs.size() - 1, emitter.id, emitter.place});
  }
  if (same != nullptr) *same = entry->second;
  return entry->second;
}

std::optional<bool> ProjectFiles::is_xml(const std::string& path, const SourceLocation& named_at) {
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return std::nullopt;
  const auto [entry, is_new] = is_xml_.try_emplace(*key);
  if (is_new) {
    const std::optional<std::string> bytes = read(*key, path, named_at);
    if (bytes) entry->second = looks_like_xml(*bytes);
  }
  return entry->second;
}

const TriangleMesh* ProjectFiles::mesh(const std::string& path, std::optional<MeshFormat> format,
                                       const std::string& node, const SourceLocation& named_at) {
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return nullptr;
  const auto [entry, is_new] = meshes_.try_emplace({*key, node});
  if (is_new) {
    const std::string folder = key->substr(0, key->rfind('/') + 1);  // "" = the project's
    const SideFiles side_files = [&](const std::string& name) {
      return read(folder + name, folder + name, {full_path(*key), 0, 0});
    };
    const std::optional<std::string> bytes = read(*key, path, named_at);
    if (bytes && take_file(*bytes, kMeshByteFactor, named_at, path)) {
      entry->second =
          parse_mesh_file(*bytes, full_path(*key), side_files, diagnostics_, format, node);
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
    std::optional<std::string> bytes = read(*key, path, named_at);
    if (bytes && take_file(*bytes, kMeshByteFactor, named_at, path)) {
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
    const std::optional<std::string> bytes = read(*key, path, named_at);
    if (bytes && take_file(*bytes, kTableByteFactor, named_at, path)) {
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
    const std::optional<std::string> bytes = read(*key, path, named_at);
    if (bytes && take_file(*bytes, kTableByteFactor, named_at, path)) {
      entry->second = parse_point_list(*bytes, full_path(*key), diagnostics_);
    }
    if (entry->second) entry->second->file = path;
  }
  return entry->second;
}

std::optional<Logo> ProjectFiles::logo(const std::string& path, const SourceLocation& named_at) {
  Logo logo{path, LogoFormat::png, ""};
  if (!is_logo_name(path, logo.format)) {
    diagnostics_.report(DiagnosticId::logo_not_usable, named_at, path,
                        "its name must end with .png or .svg");
    return std::nullopt;
  }
  const std::optional<std::string> key = resolve(path, named_at);
  if (!key) return std::nullopt;
  std::optional<std::string> bytes = read(*key, path, named_at);
  if (!bytes) return std::nullopt;
  if (const std::string problem = logo_problem(*bytes, logo.format); !problem.empty()) {
    diagnostics_.report(DiagnosticId::logo_not_usable, named_at, path, problem);
    return std::nullopt;
  }
  if (!take_file(*bytes, kLogoByteFactor, named_at, path)) return std::nullopt;
  logo.bytes = *std::move(bytes);
  return logo;
}

}  // namespace calc
