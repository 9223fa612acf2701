#include "calc/meshes/mesh_gltf.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/relative_path.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/meshes/gltf_container.h"
#include "calc/meshes/mesh_builder.h"
#include "calc/meshes/mesh_gltf_accessor.h"

#include <tiny_gltf.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace calc {
namespace {

using gltf::Broken;
using gltf::checked;
using gltf::fail;
using gltf::read_accessor;

constexpr std::size_t kMostBufferBytes = std::size_t{1} << 30;  // of all buffers together

// An error that is already reported.
struct Reported {};

// ---- buffers ----

// The only files that the library gets to see, by the name it asks for.
struct BufferFiles {
  std::map<std::string, std::string, std::less<>> bytes_of;
  std::size_t bytes_given = 0;
};

BufferFiles read_buffer_files(const GltfContainer& container, const SideFiles& side_files) {
  BufferFiles files;
  for (const std::string& uri : container.buffer_uri) {
    if (uri.starts_with("data:")) continue;
    const std::string name = percent_decoded(uri, false);
    const std::optional<std::string> path = normalize_relative_path(name);
    if (!path || path->empty() || name.find(':') != std::string::npos) {
      fail("its buffer '{}' is not a file beside it or in a folder below it",
           shorten_utf8(uri, 60));
    }
    if (files.bytes_of.contains(name)) continue;
    std::optional<std::string> bytes = side_files(*path);
    if (!bytes) throw Reported{};
    // The library takes + for a blank.
    files.bytes_of[percent_decoded(uri, true)] = *bytes;
    files.bytes_of[name] = std::move(*bytes);
  }
  return files;
}

// Since tinygltf 2.8 there is a callback for sizes, and 2.9 takes all of them or none.
template <class Callbacks>
void set_size_callback(Callbacks& callbacks) {
  if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
    callbacks.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string& name,
                                      void* self) {
      *size = static_cast<BufferFiles*>(self)->bytes_of.at(name).size();
      return true;
    };
  }
}

tinygltf::FsCallbacks callbacks_of(BufferFiles& files) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string& name, void* self) {
    return static_cast<BufferFiles*>(self)->bytes_of.contains(name);
  };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* problem,
                               const std::string& name, void* self) {
    auto& known = *static_cast<BufferFiles*>(self);
    const std::string& bytes = known.bytes_of.at(name);
    known.bytes_given += bytes.size();
    if (known.bytes_given > kMostBufferBytes) {
      *problem = "the buffers are too large together";
      return false;
    }
    out->assign(bytes.begin(), bytes.end());
    return true;
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                void*) { return false; };
  set_size_callback(callbacks);
  callbacks.user_data = &files;
  return callbacks;
}

// The library's answer is checked where it gives one: files of the system would be read by
// callbacks that it did not take.
template <class Library>
void set_callbacks(Library& library, const tinygltf::FsCallbacks& callbacks) {
  if constexpr (std::is_void_v<decltype(library.SetFsCallbacks(callbacks))>) {
    library.SetFsCallbacks(callbacks);
  } else if (!library.SetFsCallbacks(callbacks)) {
    throw std::logic_error("tinygltf wants more callbacks than it is given");
  }
}

bool ignore_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                  int, void*) {
  return true;
}

tinygltf::Model load_model(std::string_view bytes, const GltfContainer& container,
                           BufferFiles& files) {
  // Each buffer without a URI is a copy of the GLB's bytes; the standard allows one.
  if (container.buffers > container.buffer_uri.size() + (container.is_binary ? 1 : 0)) {
    fail("a buffer has no URI; only the first buffer of a GLB may have none");
  }
  tinygltf::TinyGLTF library;
  library.SetImageLoader(ignore_image, nullptr);
  set_callbacks(library, callbacks_of(files));
  tinygltf::Model model;
  std::string problem, warning;
  const auto size = static_cast<unsigned>(bytes.size());
  bool good = false;
  if (container.is_binary) {
    good = library.LoadBinaryFromMemory(&model, &problem, &warning,
                                        reinterpret_cast<const unsigned char*>(bytes.data()), size);
  } else {
    good = library.LoadASCIIFromString(&model, &problem, &warning, bytes.data(), size, "");
  }
  if (!good || !problem.empty()) {
    std::replace(problem.begin(), problem.end(), '\n', ' ');
    fail("{}", problem.empty() ? "no reason is known" : shorten_utf8(problem, 200));
  }
  if (!model.asset.version.starts_with("2.")) {
    fail("its version is '{}'; only version 2 is read", shorten_utf8(model.asset.version, 20));
  }
  return model;
}

// ---- the scene ----

glm::dmat4 matrix_of(const tinygltf::Node& node) {
  glm::dmat4 matrix(1.0);
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    return matrix;
  }
  const auto has = [&](const std::vector<double>& list, std::size_t size) {
    if (!list.empty() && list.size() != size)
      fail("a node's transform has {} numbers", list.size());
    return !list.empty();
  };
  has(node.matrix, 16);
  if (has(node.rotation, 4)) {
    const std::vector<double>& r = node.rotation;
    const glm::dquat turn(r[3], r[0], r[1], r[2]);
    if (!(glm::length(turn) > 0.0)) fail("a node's rotation is zero");
    matrix = glm::mat4_cast(glm::normalize(turn));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (has(node.scale, 3)) matrix[axis] *= node.scale[a];
    if (has(node.translation, 3)) matrix[3][axis] = node.translation[a];
  }
  return matrix;
}

class SceneReader {
 public:
  SceneReader(const tinygltf::Model& model, const std::string& name, std::string_view wanted,
              Diagnostics& diagnostics)
      : model_(model),
        name_(name),
        wanted_(wanted),
        diagnostics_(diagnostics),
        builder_(MeshFormat::gltf, name, diagnostics) {}

  std::optional<TriangleMesh> run() {
    struct Visit {
      int node;
      glm::dmat4 world_from_parent;
      bool is_wanted;
    };
    std::vector<bool> seen(model_.nodes.size());
    std::vector<Visit> open;
    for (const int root : roots()) open.push_back({root, glm::dmat4(1.0), wanted_.empty()});
    std::reverse(open.begin(), open.end());  // in file order
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const tinygltf::Node& node = checked(model_.nodes, visit.node, "node");
      if (seen[static_cast<std::size_t>(visit.node)]) {
        fail("node {} is the child of two nodes, or of itself", visit.node);
      }
      seen[static_cast<std::size_t>(visit.node)] = true;
      const glm::dmat4 world_from_node = visit.world_from_parent * matrix_of(node);
      const bool is_named = !wanted_.empty() && node.name == wanted_;
      if (is_named) ++found_;
      const bool is_wanted = visit.is_wanted || is_named;
      if (node.mesh >= 0 && is_wanted) add_mesh(node, visit.node, world_from_node);
      if (!node.name.empty()) names_.insert(node.name);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        open.push_back({*child, world_from_node, is_wanted});
      }
    }
    if (!is_wanted_clear()) return std::nullopt;
    if (deformed_ > 0) {
      diagnostics_.report(DiagnosticId::mesh_deformed, {name_, 0, 0}, deformed_);
    }
    return builder_.finish();
  }

 private:
  bool is_wanted_clear() {
    if (wanted_.empty() || found_ == 1) return true;
    const std::vector<std::string_view> known(names_.begin(), names_.end());
    const bool is_short = wanted_.size() <= 100 && known.size() <= 1000;
    diagnostics_.report(
        DiagnosticId::mesh_node, {name_, 0, 0}, shorten_utf8(wanted_, 60),
        found_ > 1
            ? fmt::format("{} nodes of the scene have this name; rename the node to use", found_)
            : fmt::format("the scene has no node of this name ({} others){}", known.size(),
                          is_short ? suggestion(wanted_, known) : std::string()));
    return false;
  }

  std::vector<int> roots() const {
    if (!model_.scenes.empty()) {
      return checked(model_.scenes, std::max(model_.defaultScene, 0), "scene").nodes;
    }
    std::vector<bool> is_child(model_.nodes.size());
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) {
        checked(model_.nodes, child, "node");
        is_child[static_cast<std::size_t>(child)] = true;
      }
    }
    std::vector<int> list;
    for (std::size_t n = 0; n < is_child.size(); ++n) {
      if (!is_child[n]) list.push_back(static_cast<int>(n));
    }
    return list;
  }

  void add_mesh(const tinygltf::Node& node, int node_index, const glm::dmat4& world_from_node) {
    const tinygltf::Mesh& mesh = checked(model_.meshes, node.mesh, "mesh");
    std::string object = node.name.empty() ? mesh.name : node.name;
    if (object.empty()) object = fmt::format("node {}", node_index);
    builder_.set_object(object);
    bool is_deformed = node.skin >= 0;
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      is_deformed = is_deformed || !mesh.primitives[p].targets.empty();
      add_primitive(mesh.primitives[p], fmt::format("object '{}', primitive {}", object, p),
                    world_from_node);
    }
    if (is_deformed) ++deformed_;
  }

  void add_primitive(const tinygltf::Primitive& primitive, const std::string& where,
                     const glm::dmat4& world_from_node) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES) return;  // points and lines
    if (mode > TINYGLTF_MODE_TRIANGLE_FAN) fail("{}: unknown mode {}", where, mode);
    const auto positions = primitive.attributes.find("POSITION");
    if (positions == primitive.attributes.end()) fail("{} has no POSITION", where);
    const std::vector<double> numbers =
        read_accessor(model_, positions->second, TINYGLTF_TYPE_VEC3, 3, kMaxMeshVertices);
    const std::size_t count = numbers.size() / 3;
    const std::size_t first = builder_.vertices();
    if (!builder_.has_room_for_vertices(count)) throw Reported{};
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec4 local(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2], 1.0);
      const bool good = builder_.add_vertex(glm::dvec3(world_from_node * local), [&] {
        return fmt::format("{}, position {}", where, i);
      });
      if (!good) throw Reported{};
    }
    set_material(primitive.material);
    add_faces(mode, corners_of(primitive, where, first, count), where);
  }

  void set_material(int index) {
    if (index < 0) return builder_.set_material("");
    const std::string& name = checked(model_.materials, index, "material").name;
    builder_.set_material(name.empty() ? fmt::format("material {}", index) : name);
  }

  std::vector<std::uint32_t> corners_of(const tinygltf::Primitive& primitive,
                                        const std::string& where, std::size_t first,
                                        std::size_t count) const {
    std::vector<std::uint32_t> corners;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < count; ++i) {
        corners.push_back(static_cast<std::uint32_t>(first + i));
      }
      return corners;
    }
    constexpr std::size_t kMostCorners = 3 * kMaxMeshTriangles + 3;
    for (const double index :
         read_accessor(model_, primitive.indices, TINYGLTF_TYPE_SCALAR, 1, kMostCorners)) {
      if (!(index >= 0.0 && index < static_cast<double>(count))) {
        fail("{} names position {}; allowed: 0 to {}", where, index, count - 1);
      }
      corners.push_back(static_cast<std::uint32_t>(first + static_cast<std::size_t>(index)));
    }
    return corners;
  }

  void add_faces(int mode, const std::vector<std::uint32_t>& corner, const std::string& where) {
    const bool is_list = mode == TINYGLTF_MODE_TRIANGLES;
    if (corner.size() < 3 || (is_list && corner.size() % 3 != 0)) {
      fail("{} has {} corners, which do not form triangles", where, corner.size());
    }
    for (std::size_t i = 0; i + 2 < corner.size(); i += is_list ? 3 : 1) {
      std::array<std::uint32_t, 3> face{corner[i], corner[i + 1], corner[i + 2]};
      if (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1) std::swap(face[1], face[2]);
      if (mode == TINYGLTF_MODE_TRIANGLE_FAN) face = {corner[i + 1], corner[i + 2], corner[0]};
      if (!builder_.add_face(face, 0)) throw Reported{};
    }
  }

  const tinygltf::Model& model_;
  const std::string& name_;
  std::string_view wanted_;  // the node; "" = all
  Diagnostics& diagnostics_;
  MeshBuilder builder_;
  std::size_t deformed_ = 0, found_ = 0;
  std::set<std::string_view> names_;
};

std::optional<TriangleMesh> read_gltf(std::string_view bytes, const std::string& name,
                                      const SideFiles& side_files, Diagnostics& diagnostics,
                                      std::string_view node) {
  const std::optional<GltfContainer> container = open_gltf(bytes, name, diagnostics);
  if (!container) return std::nullopt;
  const std::string required = unknown_gltf_extensions(container->extensions_required);
  if (!required.empty()) {
    const bool is_packed =
        required.find("meshopt") != required.npos || required.find("draco") != required.npos;
    diagnostics.report(DiagnosticId::mesh_extension_required, SourceLocation{name, 0, 0},
                       required + (is_packed ? " (compressed meshes: switch compression off in the "
                                               "exporter, or unpack the file with a glTF tool)"
                                             : ""));
    return std::nullopt;
  }
  BufferFiles files = read_buffer_files(*container, side_files);
  const tinygltf::Model model = load_model(bytes, *container, files);
  files.bytes_of.clear();
  const std::string ignored = unknown_gltf_extensions(container->extensions_used);
  if (!ignored.empty()) {
    diagnostics.report(DiagnosticId::mesh_extension_ignored, SourceLocation{name, 0, 0}, ignored);
  }
  return SceneReader(model, name, node, diagnostics).run();
}

}  // namespace

std::optional<TriangleMesh> parse_gltf(std::string_view bytes, const std::string& name,
                                       const SideFiles& side_files, Diagnostics& diagnostics,
                                       std::string_view node) {
  const SourceLocation where{name, 0, 0};
  try {
    return read_gltf(bytes, name, side_files, diagnostics, node);
  } catch (const Broken& broken) {
    diagnostics.report(DiagnosticId::mesh_broken, where, "glTF", broken.what);
  } catch (const Reported&) {
    // nothing to add
  } catch (const std::exception& exception) {
    diagnostics.report(DiagnosticId::mesh_broken, where, "glTF", exception.what());
  }
  return std::nullopt;
}

}  // namespace calc
