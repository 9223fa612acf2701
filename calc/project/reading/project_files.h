#pragma once
// Reads the files that a project names: only beside the project file or below it, each read and
// recorded once.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/meshes/gbxml.h"
#include "calc/meshes/mesh_file.h"
#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/web.h"
#include "calc/project/reading/luminaire_list_csv.h"
#include "calc/scene/project.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace calc {

// How a project uses a file's light.
struct WebUse {
  bool as_point = false;  // from the luminaire's centre, without the file's luminous opening
  bool is_cubic = false;  // hermite_refined()
};

// An emitter of a luminaire.
struct PlacedWeb {
  std::size_t web = 0;  // index into Project::webs
  std::string emitter;  // its id; "" = the only one of a file
  EmitterPlace place;
};

// Returns whether the name is that of a mesh, a table, an XML file or a picture. Photometry accepts
// no other such file, so that a policy that lists the allowed photometry can rely on names.
bool is_named_as_other_than_photometry(std::string_view path);

// Reports problems where the project names the file. An unusable file is reported once; later uses
// of it give an empty result without a message.
class ProjectFiles {
 public:
  // All must outlive this object; `project` gets inputs and webs.
  ProjectFiles(const FileReader& reader, Project& project, Diagnostics& diagnostics,
               const Budget& budget);

  // Counts so many bytes, as estimated, that stay until everything is read. False, and an error,
  // where they are too many: what takes so much must not be made then. what: "the elements of the
  // project take".
  bool take(double bytes, const SourceLocation& where, std::string_view what);
  double taken_bytes() const { return taken_bytes_; }

  // Returns the project file itself, Project::path.
  std::optional<std::string> read_project();

  // Returns one web for each emitter of the luminaire. options: which light of a file; mistakes in
  // them are reported at options.where. Empty on errors.
  std::vector<PlacedWeb> light(const std::string& path, const WebUse& use,
                               const SourceLocation& named_at,
                               const PhotometryOptions& options = {});
  // Returns a mesh that stays valid as long as this object; null on errors. format: if given, other
  // files are errors. node: of a glTF file, "" = all of them.
  const TriangleMesh* mesh(const std::string& path, std::optional<MeshFormat> format,
                           const std::string& node, const SourceLocation& named_at);
  // Returns whether a file is XML, as gbXML is but not a mesh; empty on errors.
  std::optional<bool> is_xml(const std::string& path, const SourceLocation& named_at);
  // Returns a gbXML file that stays valid as long as this object; null on errors.
  const GbxmlBuilding* building(const std::string& path, const SourceLocation& named_at);
  // Returns a CSV file of luminaires that stays valid as long as this object; null on errors.
  const LuminaireList* luminaire_list(const std::string& path, const SourceLocation& named_at);
  // Returns a picture for reports; empty on errors.
  std::optional<Logo> logo(const std::string& path, const SourceLocation& named_at);
  // Returns points in file units, with normalised normals; empty on errors.
  const std::optional<PointList>& point_list(const std::string& path,
                                             const SourceLocation& named_at);

 private:
  std::optional<std::string> resolve(const std::string& path, const SourceLocation& named_at);
  std::string full_path(const std::string& key) const;
  // Counts `factor` bytes for each byte of a file that is about to be parsed.
  bool take_file(std::string_view bytes, double factor, const SourceLocation& named_at,
                 const std::string& path);
  std::optional<std::string> read(const std::string& key, const std::string& as_named,
                                  const SourceLocation& named_at);

  // A light of a file: the path and the choices.
  using FileLight = std::tuple<std::string, int, std::string, std::string>;
  const std::optional<LuminaireLight>& photometry(const FileLight& light,
                                                  const std::string& as_named,
                                                  const SourceLocation& named_at,
                                                  PhotometryOptions options);

  const FileReader& reader_;
  Project& project_;
  Diagnostics& diagnostics_;
  const Budget& budget_;
  std::map<FileLight, std::optional<LuminaireLight>> photometry_;
  std::map<std::tuple<FileLight, bool, bool>, std::vector<PlacedWeb>> webs_;
  std::map<std::pair<std::string, std::string>, std::optional<TriangleMesh>> meshes_;  // with node
  std::map<std::string, std::optional<bool>> is_xml_;
  std::map<std::string, std::optional<GbxmlBuilding>> buildings_;
  std::map<std::string, std::optional<LuminaireList>> luminaire_lists_;
  std::map<std::string, std::optional<PointList>> point_lists_;
  // Light of files with equal bytes (links to one file, copies) that need no other files.
  std::map<std::tuple<std::string, FileLight, bool, bool>, std::vector<PlacedWeb>> same_light_;
  std::map<FileLight, std::string> hash_;  // of its file; none: it needs others
  double taken_bytes_ = 0.0;
  std::set<std::string> recorded_;
};

}  // namespace calc
