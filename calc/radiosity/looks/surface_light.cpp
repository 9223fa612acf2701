#include "calc/radiosity/looks/surface_light.h"

#include "calc/base/elementary.h"
#include "calc/base/sentences.h"
#include "calc/base/statistics.h"
#include "calc/radiosity/looks/solve.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace calc {
namespace {

constexpr int kMostLevels = 12;
constexpr int kRefinements = 2;
// Where light changes by less than this share of what is bright along an edge, it is not split.
constexpr double kSmoothShare = 0.04;
constexpr int kSmoothings = 3;
constexpr double kBrightShare = 0.95;  // of the points are darker
// Corners on the rim of a surface are estimated a little inside, clear of the surface beside it.
constexpr double kRimShare = 0.1;
constexpr double kMostRim_m = 0.01;
// Openings' samples are off by about two parts in a hundred in each replicate, where it matters:
// less than the steps of a picture's colours.
constexpr double kOpeningErrorFactor = 4.0;

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // ascending

Edge edge_of(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

struct SharedEdge {
  Edge edge;
  int triangles = 0;
};

// Triangles whose corners are one where place and normal are.
class SurfaceMesh {
 public:
  // Of the next side.
  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& normal) {
    side_.push_back(static_cast<std::uint32_t>(side_.size()));
    const auto index = [&](const glm::vec3& p) {
      const auto next = static_cast<std::uint32_t>(corners());
      return corner(p, normal, {next, next});
    };
    const std::uint32_t i = index(a), j = index(b), k = index(c);
    triangle_.emplace_back(i, j, k);
  }

  std::size_t corners() const { return position_m_.size(); }
  const std::vector<glm::vec3>& position_m() const { return position_m_; }
  const std::vector<glm::vec3>& normal() const { return normal_; }
  const std::vector<glm::uvec3>& triangle() const { return triangle_; }
  const std::vector<std::uint32_t>& side() const { return side_; }

  double length_m(const Edge& edge) const {
    return glm::distance(glm::dvec3(position_m_[edge.first]), glm::dvec3(position_m_[edge.second]));
  }

  // Of a corner that split() made, the edge that it halves; of others no edge: itself twice.
  const Edge& halved_edge(std::size_t corner) const { return halved_edge_[corner]; }

  // Ascending.
  std::vector<SharedEdge> edges() const {
    std::vector<Edge> all;
    all.reserve(3 * triangle_.size());
    for (const glm::uvec3& t : triangle_) {
      for (int k = 0; k < 3; ++k) all.push_back(edge_of(t[k], t[(k + 1) % 3]));
    }
    std::sort(all.begin(), all.end());
    std::vector<SharedEdge> result;
    for (const Edge& edge : all) {
      if (result.empty() || result.back().edge != edge) result.push_back({edge});
      ++result.back().triangles;
    }
    return result;
  }

  // Halves these edges, in all triangles that share them: no gaps open.
  void split(const std::vector<Edge>& edges) {
    std::vector<Middle> middle;
    for (const Edge& edge : edges) {
      const glm::vec3 m = 0.5f * (position_m_[edge.first] + position_m_[edge.second]);
      middle.push_back({edge, corner(m, normal_[edge.first], edge)});
    }
    std::sort(middle.begin(), middle.end());
    const std::vector<glm::uvec3> old = std::exchange(triangle_, {});
    const std::vector<std::uint32_t> old_side = std::exchange(side_, {});
    for (std::size_t k = 0; k < old.size(); ++k) {
      split(old[k], middle);
      side_.resize(triangle_.size(), old_side[k]);
    }
  }

  // Where corners are estimated.
  std::vector<glm::dvec3> sample_positions_m(double offset_m) const {
    std::vector<glm::dvec3> result(position_m_.begin(), position_m_.end());
    std::vector<std::uint8_t> is_rim(corners(), 0);
    for (const auto& [edge, triangles] : edges()) {
      if (triangles > 1) continue;
      is_rim[edge.first] = is_rim[edge.second] = 1;
    }
    for (const glm::uvec3& t : triangle_) {
      const glm::dvec3 middle_m = (glm::dvec3(position_m_[t.x]) + glm::dvec3(position_m_[t.y]) +
                                   glm::dvec3(position_m_[t.z])) /
                                  3.0;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t i = t[k];
        if (is_rim[i] == 0) continue;
        is_rim[i] = 0;  // the first triangle has it
        const glm::dvec3 inwards_m = middle_m - result[i];
        const double wanted_m = std::max(kRimShare * glm::length(inwards_m), 20.0 * offset_m);
        const double length_m = std::min({wanted_m, kMostRim_m, 0.5 * glm::length(inwards_m)});
        if (length_m > 0.0) result[i] += glm::normalize(inwards_m) * length_m;
      }
    }
    return result;
  }

 private:
  using Middle = std::pair<Edge, std::uint32_t>;  // an edge and the corner that halves it

  std::uint32_t corner(const glm::vec3& p, const glm::vec3& normal, const Edge& halved_edge) {
    std::array<std::int32_t, 6> key;
    for (int k = 0; k < 3; ++k) {
      key[static_cast<std::size_t>(k)] = std::bit_cast<std::int32_t>(p[k] + 0.0f);  // no -0
      key[static_cast<std::size_t>(3 + k)] =
          static_cast<std::int32_t>(std::lround(1000.0f * normal[k]));
    }
    const auto [entry, is_new] =
        index_.try_emplace(key, static_cast<std::uint32_t>(position_m_.size()));
    if (is_new) {
      position_m_.push_back(p);
      normal_.push_back(normal);
      halved_edge_.push_back(halved_edge);
    }
    return entry->second;
  }

  // middle: ascending.
  void split(const glm::uvec3& t, const std::vector<Middle>& middle) {
    constexpr std::uint32_t kNone = ~0u;
    std::array<std::uint32_t, 3> m;  // of edge k, k + 1
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const Middle least{edge_of(t[k], t[(k + 1) % 3]), 0};
      const auto found = std::lower_bound(middle.begin(), middle.end(), least);
      const bool is_halved = found != middle.end() && found->first == least.first;
      m[static_cast<std::size_t>(k)] = is_halved ? found->second : kNone;
      if (is_halved) ++count;
    }
    if (count == 0) {
      triangle_.push_back(t);
      return;
    }
    if (count == 3) {
      triangle_.insert(
          triangle_.end(),
          {{t.x, m[0], m[2]}, {t.y, m[1], m[0]}, {t.z, m[2], m[1]}, {m[0], m[1], m[2]}});
      return;
    }
    // Turned so that edge 0 is the one of its kind.
    int turn = 0;
    while ((m[static_cast<std::size_t>(turn)] != kNone) != (count == 1)) ++turn;
    const auto c = [&](int k) { return t[(turn + k) % 3]; };
    const auto n = [&](int k) { return m[static_cast<std::size_t>((turn + k) % 3)]; };
    if (count == 1) {
      triangle_.insert(triangle_.end(), {{c(0), n(0), c(2)}, {n(0), c(1), c(2)}});
    } else {
      triangle_.insert(triangle_.end(),
                       {{n(1), c(2), n(2)}, {c(0), c(1), n(1)}, {c(0), n(1), n(2)}});
    }
  }

  std::vector<glm::vec3> position_m_, normal_;
  std::vector<Edge> halved_edge_;
  std::vector<glm::uvec3> triangle_;
  std::vector<std::uint32_t> side_;  // of each triangle
  std::map<std::array<std::int32_t, 6>, std::uint32_t> index_;
};

SurfaceMesh mesh_of(const PreparedScene& scene, std::span<const SurfaceSide> sides) {
  SurfaceMesh mesh;
  for (const SurfaceSide& side : sides) {
    const glm::uvec3& t = scene.triangle[side.triangle];
    const glm::vec3 &a = scene.vertex_m[t.x], &b = scene.vertex_m[t.y], &c = scene.vertex_m[t.z];
    if (side.is_flipped) {
      mesh.add(a, c, b, side.normal);
    } else {
      mesh.add(a, b, c, side.normal);
    }
  }
  return mesh;
}

double area_m2(const SurfaceMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangle()) {
    const glm::dvec3 a(mesh.position_m()[t.x]), b(mesh.position_m()[t.y]),
        c(mesh.position_m()[t.z]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

PreparedScene with_black_surfaces(const PreparedScene& scene) {
  PreparedScene black = scene;
  std::fill(black.reflectance.begin(), black.reflectance.end(), 0.0);
  return black;
}

// What is known at the corners so far.
class CornerLight {
 public:
  CornerLight(const PreparedScene& scene, const SurfaceLightSettings& settings, Gatherer& gatherer)
      : scene_(scene), settings_(settings), gatherer_(gatherer) {}

  // At all corners of a first mesh. False: problem() says why not.
  bool estimate(const SurfaceMesh& mesh) { return estimate_new(scene_, mesh); }

  // At the corners by which the mesh was refined since. They halve edges along which mostly direct
  // light changes: only that is estimated, and indirect light is taken to be linear there.
  bool estimate_direct(const SurfaceMesh& mesh) {
    const std::size_t known = known_;
    if (!estimate_new(with_black_surfaces(scene_), mesh)) return false;
    for (std::size_t i = known; i < mesh.corners(); ++i) {
      const auto [a, b] = mesh.halved_edge(i);
      const float at_a = indirect_lx_[a], at_b = indirect_lx_[b];
      indirect_lx_[i] = std::isnan(at_a) ? at_b : std::isnan(at_b) ? at_a : 0.5f * (at_a + at_b);
    }
    return true;
  }

  // At all corners, with evened indirect light.
  std::vector<float> lx(const SurfaceMesh& mesh) const {
    std::vector<float> result = indirect_lx_;
    const std::vector<SharedEdge> edges = mesh.edges();
    for (int k = 0; k < kSmoothings; ++k) {
      std::vector<float> sum(result.size(), 0.0f);
      std::vector<float> count(result.size(), 0.0f);
      const auto add = [&](std::uint32_t to, std::uint32_t from) {
        if (std::isnan(result[from])) return;
        sum[to] += result[from];
        count[to] += 1.0f;
      };
      for (const auto& [edge, triangles] : edges) {
        add(edge.first, edge.second);
        add(edge.second, edge.first);
      }
      for (std::size_t i = 0; i < result.size(); ++i) {
        if (count[i] > 0.0f) result[i] = 0.5f * (result[i] + sum[i] / count[i]);
      }
    }
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += direct_lx_[i];
    return result;
  }
  const Message& problem() const { return problem_; }
  double error_share() const { return points_ > 0 ? std::sqrt(squares_ / points_) : 0.0; }

 private:
  bool estimate_new(const PreparedScene& scene, const SurfaceMesh& mesh) {
    const std::vector<glm::dvec3> position_m = mesh.sample_positions_m(scene.ray_offset_m());
    SensorGrid grid;
    // Nobody reads the rule of this grid.
    std::vector<std::size_t> corner;
    for (std::vector<float>* lx : {&direct_lx_, &indirect_lx_}) {
      lx->resize(mesh.corners(), std::numeric_limits<float>::quiet_NaN());
    }
    for (std::size_t i = known_; i < mesh.corners(); ++i) {
      if (find_touching_luminaire(scene, position_m[i], 2.0 * scene.ray_offset_m()) >= 0) continue;
      corner.push_back(i);
      grid.position_m.push_back(position_m[i] + scene.origin_m);
      grid.normal.emplace_back(mesh.normal()[i]);
    }
    known_ = mesh.corners();
    return corner.empty() || solve(scene, grid, corner);
  }

  bool solve(const PreparedScene& scene, const SensorGrid& grid,
             const std::vector<std::size_t>& corner) {
    RadiositySettings settings;
    settings.seed = settings_.seed;
    settings.replicates = settings_.replicates;
    settings.first_paths = settings.max_paths = settings_.paths;
    settings.jobs = settings_.jobs;
    settings.refuses_close_points = false;
    settings.opening_error_factor = kOpeningErrorFactor;
    const SpaceSolution solution = solve_illuminance(
        scene, {{"picture", &grid}}, settings, 0.95, gatherer_,
        [](std::size_t, const PlaneField&, Look) { return LookAnswer{}; },
        [this](const SolveProgress&) { return !settings_.go_on || settings_.go_on(); });
    const PlaneField& field = solution.fields.front();
    problem_ = field.problem;
    if (!problem_.empty()) return false;
    std::vector<double> replicate(field.replicates);
    for (std::size_t i = 0; i < field.points; ++i) {
      double indirect_lx = 0.0;
      for (std::size_t r = 0; r < field.replicates; ++r) {
        const PartsOfLight parts = maintained_lx(field, r, i);
        replicate[r] = parts.direct_lx + parts.indirect_lx;
        indirect_lx += parts.indirect_lx / static_cast<double>(field.replicates);
      }
      const ReplicateMean mean = replicate_mean(replicate);
      direct_lx_[corner[i]] = static_cast<float>(mean.mean - indirect_lx);
      indirect_lx_[corner[i]] = static_cast<float>(indirect_lx);
      if (!(indirect_lx > 0.0)) continue;
      squares_ += calc::pow(mean.standard_error / mean.mean, 2);
      points_ += 1.0;
    }
    return true;
  }

  struct PartsOfLight {
    double direct_lx = 0.0, indirect_lx = 0.0;
  };

  static PartsOfLight maintained_lx(const PlaneField& field, std::size_t r, std::size_t i) {
    PartsOfLight sum;
    for (std::size_t c = 0; c < field.channels.size(); ++c) {
      const double factor = field.channels[c].maintenance_factor;
      sum.direct_lx += factor * field.direct_exact_at(c, i);
      sum.direct_lx += factor * field.direct_sampled_at(r, c, i);
      sum.indirect_lx += factor * field.indirect_at(r, c, i);
    }
    return sum;
  }

  const PreparedScene& scene_;
  const SurfaceLightSettings& settings_;
  Gatherer& gatherer_;
  std::vector<float> direct_lx_, indirect_lx_;  // NaN: at a luminaire without size
  std::size_t known_ = 0;
  Message problem_;
  double squares_ = 0.0, points_ = 0.0;
};

// Splits until no edge is longer than `most_m`; false if there are too many corners.
bool split_long_edges(SurfaceMesh& mesh, double most_m, std::size_t most_corners) {
  for (int level = 0; level < kMostLevels && mesh.corners() <= most_corners; ++level) {
    std::vector<Edge> wanted;
    for (const auto& [edge, triangles] : mesh.edges()) {
      if (mesh.length_m(edge) > most_m) wanted.push_back(edge);
    }
    if (wanted.empty()) break;
    mesh.split(wanted);
  }
  return mesh.corners() <= most_corners;
}

float bright_lx(std::vector<float> lx) {
  std::erase_if(lx, [](float value) { return std::isnan(value); });
  if (lx.empty()) return 0.0f;
  const auto at =
      lx.begin() + static_cast<std::ptrdiff_t>(kBrightShare * static_cast<double>(lx.size() - 1));
  std::nth_element(lx.begin(), at, lx.end());
  return *at;
}

// The edges along which light changes most, at most so many.
std::vector<Edge> uneven_edges(const SurfaceMesh& mesh, const std::vector<float>& lx,
                               double least_m, std::size_t most) {
  const auto least_change = static_cast<float>(kSmoothShare) * bright_lx(lx);
  std::vector<std::pair<float, Edge>> found;
  for (const auto& [edge, triangles] : mesh.edges()) {
    const float change = std::abs(lx[edge.first] - lx[edge.second]);
    if (change > least_change && mesh.length_m(edge) > least_m) found.emplace_back(-change, edge);
  }
  std::sort(found.begin(), found.end());
  if (found.size() > most) found.resize(most);
  std::vector<Edge> result;
  for (const auto& [change, edge] : found) result.push_back(edge);
  return result;
}

// Corners at a luminaire without size take the brightest value beside them.
void fill_gaps(const SurfaceMesh& mesh, std::vector<float>& lx) {
  std::vector<float> filled = lx;
  for (const glm::uvec3& t : mesh.triangle()) {
    for (int k = 0; k < 3; ++k) {
      if (!std::isnan(lx[t[k]])) continue;
      for (int other = 0; other < 3; ++other) filled[t[k]] = std::fmax(filled[t[k]], lx[t[other]]);
    }
  }
  for (float& value : filled) {
    if (std::isnan(value)) value = 0.0f;
  }
  lx = std::move(filled);
}

}  // namespace

LitSurfaces light_surfaces(const PreparedScene& scene, std::span<const SurfaceSide> sides,
                           const SurfaceLightSettings& settings, Gatherer& gatherer) {
  LitSurfaces result;
  SurfaceMesh mesh = mesh_of(scene, sides);
  const double most_m =
      2.2 *
      std::sqrt(area_m2(mesh) / static_cast<double>(std::max<std::size_t>(1, settings.points)));
  if (!split_long_edges(mesh, most_m, settings.most_points)) {
    result.problem = say<Sentence::too_many_surfaces>();
    return result;
  }
  CornerLight light(scene, settings, gatherer);
  bool is_known = light.estimate(mesh);
  for (int k = 0; is_known && k < kRefinements; ++k) {
    const std::vector<Edge> edges =
        uneven_edges(mesh, light.lx(mesh), 0.2 * most_m, settings.points / kRefinements);
    if (edges.empty()) break;
    mesh.split(edges);
    is_known = light.estimate_direct(mesh);
  }
  result.problem = light.problem();
  if (!is_known) return result;
  result.lx = light.lx(mesh);
  fill_gaps(mesh, result.lx);
  result.position_m = mesh.position_m();
  result.triangle = mesh.triangle();
  result.side = mesh.side();
  result.error_share = light.error_share();
  return result;
}

}  // namespace calc
