#include "calc/project/spaces/mesh_room.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/meshes/mesh_shells.h"
#include "calc/project/objects/mesh_attributes.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

// A solid that takes so much of the room's box may be the room itself, in a thick building.
constexpr double kMostOfRoom = 0.5;
constexpr double kTouching = 1.0e-6;  // of the size

double box_volume(const BoundingBox& box) {
  const glm::dvec3 size = box.upper - box.lower;
  return box.is_empty() ? 0.0 : size.x * size.y * size.z;
}

bool box_contains(const BoundingBox& outer, const BoundingBox& inner) {
  const double gap = kTouching * outer.diagonal();
  const BoundingBox wide{outer.lower - gap, outer.upper + gap};
  return wide.contains(inner.lower) && wide.contains(inner.upper);
}

// What may be the room, or stands in it.
struct Piece {
  MeshShell shell;  // its triangles are those of the whole mesh
  std::string name;
  Body body;  // of the shell alone
};

class MeshRoomReader {
 public:
  MeshRoomReader(ElementReader& reader, const PlacedMesh& placed, Space& space)
      : reader_(reader), placed_(placed), space_(space), local_of_(placed.vertex_m.size(), kNone) {}

  // False after an error.
  bool read(RoomPlan& plan) {
    find_pieces();
    if (reader_.has("shell") && reader_.text("shell") == kAllShells) return read_all();
    const std::optional<std::size_t> chosen = choose();
    if (!chosen || !is_room(*chosen)) return false;
    const Piece room = candidate(*chosen);
    add_bodies(*chosen, room);
    describe(room, plan);
    return true;
  }

 private:
  // Closed ones, the largest box first; then, if there are any, all other triangles as one.
  void find_pieces() {
    const TriangleMesh& mesh = *placed_.mesh;
    std::vector<std::vector<std::uint32_t>> of_object(mesh.object_name.size());
    for (std::uint32_t t = 0; t < mesh.triangle.size(); ++t) {
      of_object[mesh.object_of[t]].push_back(t);
    }
    std::vector<std::uint32_t> rest;
    for (const std::vector<std::uint32_t>& triangles : of_object) take_closed(triangles, rest);
    if (mesh.object_name.size() > 1) {
      std::sort(rest.begin(), rest.end());
      take_closed(std::exchange(rest, {}), rest);
    }
    std::stable_sort(closed_.begin(), closed_.end(), [](const Piece& one, const Piece& other) {
      return box_volume(one.shell.bounds) > box_volume(other.shell.bounds);
    });
    std::sort(rest.begin(), rest.end());
    open_.shell.triangle = std::move(rest);
    open_.body = body_of(open_.shell.triangle);
    open_.shell.bounds = bounding_box(open_.body.vertex_m);
  }

  void take_closed(const std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& rest) {
    const Body all = body_of(triangles);
    std::vector<bool> is_taken(triangles.size());
    for (MeshShell& shell : find_shells(all.vertex_m, all.triangle)) {
      // Of one whose faces have no sides nobody knows what is inside.
      if (!shell.is_closed || shell.faces == FacesLook::unclear) continue;
      for (std::uint32_t& t : shell.triangle) {
        is_taken[t] = true;
        t = triangles[t];
      }
      const std::string& name =
          placed_.mesh->object_name[placed_.mesh->object_of[shell.triangle.front()]];
      Piece piece{std::move(shell), name, {}};
      piece.body = body_of(piece.shell.triangle);
      closed_.push_back(std::move(piece));
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (!is_taken[i]) rest.push_back(triangles[i]);
    }
  }

  // With the corners of these triangles alone.
  Body body_of(const std::vector<std::uint32_t>& triangles) {
    Body body;
    body.where = space_.where;
    std::vector<std::uint32_t> used;
    for (const std::uint32_t t : triangles) {
      glm::uvec3 corners = placed_.mesh->triangle[t];
      for (int i = 0; i < 3; ++i) {
        std::uint32_t& local = local_of_[corners[i]];
        if (local == kNone) {
          local = static_cast<std::uint32_t>(used.size());
          used.push_back(corners[i]);
          body.vertex_m.push_back(placed_.vertex_m[corners[i]]);
        }
        corners[i] = local;
      }
      body.triangle.push_back(corners);
      body.material_of.push_back(placed_.material[t]);
    }
    for (const std::uint32_t vertex : used) local_of_[vertex] = kNone;
    return body;
  }

  bool has_open() const { return !open_.shell.triangle.empty(); }
  bool is_open(std::size_t index) const { return index == closed_.size(); }
  const Piece& candidate(std::size_t index) const {
    return is_open(index) ? open_ : closed_[index];
  }

  // Most of the corners that are not on the room's surface: furniture may stick in the floor, and
  // what stands on the roof has no corner inside. Of what has all corners on it, its middle.
  static bool is_in(const Body& body, const SolidLocator& room) {
    constexpr std::size_t kMostSamples = 64;
    const std::size_t step = body.vertex_m.size() / kMostSamples + 1;
    std::size_t inside = 0, outside = 0;
    for (std::size_t i = 0; i < body.vertex_m.size(); i += step) {
      const SolidSide side = room.locate(body.vertex_m[i]);
      if (side == SolidSide::inside) ++inside;
      if (side == SolidSide::outside) ++outside;
    }
    if (inside + outside > 0) return inside >= outside;
    return room.locate(bounding_box(body.vertex_m).centre()) != SolidSide::outside;
  }

  // Made when it is first asked for.
  const SolidLocator& locator(std::size_t room) {
    if (!locator_ || located_ != room) locator_.emplace(candidate(room).body);
    located_ = room;
    return *locator_;
  }

  bool stands_in(std::size_t index, std::size_t room) {
    const Piece &inner = candidate(index), &outer = candidate(room);
    if (box_volume(inner.shell.bounds) >= box_volume(outer.shell.bounds)) return false;
    if (is_open(room)) return outer.shell.bounds.contains(inner.shell.bounds.centre());
    return is_in(inner.body, locator(room));
  }

  // With "shell": from 1, of closed ones only.
  std::optional<std::size_t> choose_by_number() {
    const std::string words = reader_.text("shell");
    const std::optional<int> number = parse_integer(words);
    if (number && *number >= 1 && static_cast<std::size_t>(*number) <= closed_.size()) {
      return static_cast<std::size_t>(*number) - 1;
    }
    if (words.empty()) return std::nullopt;  // said
    reader_.report(DiagnosticId::number_out_of_range, reader_.where("shell"), "shell", "room",
                   shorten_utf8(words, 40), fmt::format("one of: {}", list()));
    return std::nullopt;
  }

  std::optional<std::size_t> choose() {
    if (reader_.has("shell")) return choose_by_number();
    if (closed_.empty()) return std::size_t{0};
    const BoundingBox& largest = closed_[0].shell.bounds;
    std::vector<std::size_t> beside;
    for (std::size_t i = 1; i < closed_.size(); ++i) {
      if (!stands_in(i, 0)) beside.push_back(i);
    }
    const bool holds_open = !has_open() || box_contains(largest, open_.shell.bounds);
    if (beside.empty() && holds_open) return choose_largest();
    const bool is_in_open = std::all_of(closed_.begin(), closed_.end(), [&](const Piece& piece) {
      return has_open() && box_contains(open_.shell.bounds, piece.shell.bounds);
    });
    const bool is_small = box_volume(largest) <= kMostOfRoom * box_volume(open_.shell.bounds);
    if (is_in_open && is_small) return closed_.size();
    if (has_open() && !holds_open) {
      return refuse("it has a closed shell, and open surfaces reach beyond the shell");
    }
    return refuse(fmt::format("{} closed shells are side by side", beside.size() + 1));
  }

  std::optional<std::size_t> choose_largest() {
    const Piece& room = closed_[0];
    double filled = 0.0;  // by all that stand in it, one in another counted twice
    for (std::size_t i = 1; i < closed_.size(); ++i) {
      const Piece& inner = closed_[i];
      filled += box_volume(inner.shell.bounds);
      const bool is_large = filled > kMostOfRoom * box_volume(room.shell.bounds);
      const bool is_hollow =
          room.shell.faces == FacesLook::outward && inner.shell.faces == FacesLook::inward;
      if (!is_large && !is_hollow) continue;
      return refuse(fmt::format(
          "shell {} is inside shell 1 and {}; it may be a solid in the room, or the room "
          "within thick walls",
          i + 1,
          is_hollow ? "has faces that look the other way"
          : box_volume(inner.shell.bounds) > kMostOfRoom * box_volume(room.shell.bounds)
              ? "fills most of it"
              : "fills most of it together with larger shells"));
    }
    if (has_open() &&
        box_volume(open_.shell.bounds) > kMostOfRoom * box_volume(room.shell.bounds) &&
        encloses_something(open_.body.vertex_m, open_.body.triangle)) {
      return refuse(
          "open surfaces in shell 1 enclose most of it; they may be the room within thick "
          "walls");
    }
    return std::size_t{0};
  }

  std::nullopt_t refuse(const std::string& why) {
    reader_.report(DiagnosticId::mesh_room_not_clear, reader_.where("file"), space_.id,
                   space_.surfaces_file, why, list());
    return std::nullopt;
  }

  // "1 ('hall', 4 x 5 x 3 m), 2 ('desk', 1 x 2 x 0.75 m) or \"all\" (...)"
  std::string list() const {
    constexpr std::size_t kMostListed = 8;
    std::string words;
    for (std::size_t i = 0; i < std::min(closed_.size(), kMostListed); ++i) {
      const Piece& piece = closed_[i];
      const glm::dvec3 size = piece.shell.bounds.upper - piece.shell.bounds.lower;
      words += fmt::format("{} ({}{:.4g} x {:.4g} x {:.4g} m), ", i + 1,
                           piece.name.empty() ? "" : "'" + shorten_utf8(piece.name, 40) + "', ",
                           size.x, size.y, size.z);
    }
    if (closed_.size() > kMostListed) {
      words += fmt::format("smaller ones up to {}, ", closed_.size());
    }
    return words + "or \"all\" (the room is the space between all surfaces, such as thick walls)";
  }

  // The room is between the solids.
  bool read_all() {
    const TriangleMesh& mesh = *placed_.mesh;
    if (!encloses_something(placed_.vertex_m, mesh.triangle)) return refuse_sheet();
    if (has_open()) add_body(open_.body, "sheets");
    std::size_t solids = 0;
    for (Piece& piece : closed_) {
      piece.body.is_closed = true;
      add_body(std::move(piece.body), fmt::format("solid{}", ++solids));
    }
    space_.notes.push_back(say<Sentence::mesh_room_between>(Message::path(space_.surfaces_file),
                                                            solids, open_.shell.triangle.size()));
    return true;
  }

  bool refuse_sheet() {
    reader_.report(DiagnosticId::mesh_room_encloses_nothing, reader_.where("file"), space_.id,
                   space_.surfaces_file);
    return false;
  }

  bool is_room(std::size_t chosen) {
    if (!is_open(chosen)) return true;
    const OpenEdges open = open_edges(open_.body.vertex_m, open_.body.triangle);
    if (!encloses_something(open_.body.vertex_m, open_.body.triangle)) return refuse_sheet();
    if (open.count == 0) {
      refuse(
          "shells share edges and cannot be told apart; make each shell its own object in the "
          "file");
      return false;
    }
    reader_.report(DiagnosticId::mesh_room_open, reader_.where("file"), space_.id,
                   space_.surfaces_file, open.count, open.length, open.longest, open.at.x,
                   open.at.y, open.at.z);
    return true;
  }

  void add_body(Body body, const std::string& name) {
    body.id = space_.id + "." + name;
    space_.bodies.push_back(std::move(body));
  }

  void add_bodies(std::size_t chosen, const Piece& room) {
    Body shell = room.body;
    shell.encloses_room = !is_open(chosen);
    add_body(std::move(shell), "shell");
    std::size_t solids = 0;
    std::vector<std::uint32_t> left_out;
    for (std::size_t i = 0; i < closed_.size(); ++i) {
      if (i == chosen) continue;
      if (!stands_in(i, chosen)) {
        const std::vector<std::uint32_t>& triangles = closed_[i].shell.triangle;
        left_out.insert(left_out.end(), triangles.begin(), triangles.end());
        continue;
      }
      Body solid = closed_[i].body;
      solid.is_closed = true;
      add_body(std::move(solid), fmt::format("solid{}", ++solids));
    }
    if (!is_open(chosen) && has_open()) add_sheets(chosen, left_out);
    if (!left_out.empty()) warn_left_out(left_out);
  }

  // Those that are not in the room would not change its light.
  void add_sheets(std::size_t room, std::vector<std::uint32_t>& left_out) {
    std::vector<std::uint32_t> inside;
    for (const MeshShell& sheet : find_shells(open_.body.vertex_m, open_.body.triangle)) {
      std::vector<std::uint32_t> triangles;
      for (const std::uint32_t t : sheet.triangle) triangles.push_back(open_.shell.triangle[t]);
      std::vector<std::uint32_t>& to = is_in(body_of(triangles), locator(room)) ? inside : left_out;
      to.insert(to.end(), triangles.begin(), triangles.end());
    }
    std::sort(inside.begin(), inside.end());
    if (!inside.empty()) add_body(body_of(inside), "sheets");
  }

  void warn_left_out(const std::vector<std::uint32_t>& triangles) {
    double area_m2 = 0.0;
    for (const std::uint32_t t : triangles) {
      const glm::uvec3& corner = placed_.mesh->triangle[t];
      const glm::dvec3 a = placed_.vertex_m[corner.x];
      area_m2 += 0.5 * glm::length(glm::cross(placed_.vertex_m[corner.y] - a,
                                              placed_.vertex_m[corner.z] - a));
    }
    reader_.report(DiagnosticId::mesh_room_left_out, reader_.where("file"), space_.id,
                   triangles.size(), space_.surfaces_file, area_m2);
  }

  void describe(const Piece& room, RoomPlan& plan) {
    const MeshShell& shell = room.shell;
    if (shell.is_closed) {
      const Message look =
          shell.faces == FacesLook::inward ? say<Sentence::faces_inward>()
          : shell.faces == FacesLook::outward
              ? say<Sentence::faces_outward>()
              : say<Sentence::faces_mixed>(shell.triangle.size() - shell.outward, shell.outward);
      space_.notes.push_back(
          say<Sentence::mesh_room_faces>(Message::path(space_.surfaces_file), shell.volume, look));
    }
    const MeshFloor floor = find_floor(room.body.vertex_m, room.body.triangle);
    plan.corners_m = floor.outline;
    plan.origin_m = {0.0, 0.0, floor.z};
    plan.height_m = floor.height;
    constexpr double kLeastSaid_m2 = 1.0e-3;
    if (shell.is_closed && !floor.outline.empty() && floor.above > kLeastSaid_m2) {
      space_.notes.push_back(say<Sentence::mesh_room_above_floor>(floor.above));
    }
  }

  ElementReader& reader_;
  const PlacedMesh& placed_;
  Space& space_;
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> local_of_;  // of a vertex in the body that is being made
  std::vector<Piece> closed_;
  std::optional<SolidLocator> locator_;  // of the candidate located_
  std::size_t located_ = 0;
  Piece open_{{}, {}, {}};
};

}  // namespace

void read_mesh_surfaces(ProjectContext& context, ElementReader& reader, Space& space,
                        RoomPlan& plan) {
  const std::optional<PlacedMesh> placed = read_placed_mesh(context, reader);
  if (!placed) return;
  space.surfaces_file = reader.text("file");
  space.is_from_mesh = true;
  const auto triangles = static_cast<double>(placed->mesh->triangle.size());
  if (!check_room_for(context, reader, 1.0, triangles)) return;
  if (!MeshRoomReader(reader, *placed, space).read(plan)) return;
  const auto bodies = static_cast<double>(space.bodies.size());
  if (!check_room_for(context, reader, bodies, triangles)) return;
  context.instances += bodies;
  context.triangles += triangles;
}

}  // namespace calc
