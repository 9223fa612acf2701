#include "report/tools/selftest/scene.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/scene/prepared_scene.h"

#include <algorithm>
#include <cmath>

namespace cli::selftest {
namespace {

// The replicate's illuminance of one channel; all scenes here have maintenance factors of 1.
double value_lx(const calc::PlaneField& field, std::size_t r, std::size_t i, Part part) {
  double sum = 0.0;
  for (std::size_t c = 0; c < field.channels.size(); ++c) {
    if (part != Part::indirect) {
      sum += field.direct_exact_at(c, i);
      sum += field.direct_sampled_at(r, c, i);
    }
    if (part != Part::direct) sum += field.indirect_at(r, c, i);
  }
  return sum;
}

bool is_sampled(const calc::PlaneField& field, Part part) {
  return (part != Part::indirect && !field.direct_sampled_lx.empty()) ||
         (part != Part::direct && !field.indirect_lx.empty());
}

}  // namespace

calc::PhotometricWeb isotropic_web(double cd, calc::LuminousOpening opening) {
  return calc::PhotometricWeb::make({0.0}, {0.0, 0.5 * calc::kPi, calc::kPi}, {cd, cd, cd}, opening,
                                    {});
}

calc::PhotometricWeb lambert_web(double axis_cd, calc::LuminousOpening opening) {
  constexpr int kSteps = 900;
  std::vector<double> gamma_rad, cd;
  for (int k = 0; k <= kSteps; ++k) {
    gamma_rad.push_back(0.5 * calc::kPi * k / kSteps);
    cd.push_back(k == kSteps ? 0.0 : axis_cd * calc::cos(gamma_rad.back()));
  }
  return calc::PhotometricWeb::make({0.0}, gamma_rad, cd, opening, {});
}

Scene::Scene() {
  project_.path = project_.name = "selftest";
  calc::Space space;
  space.id = "site";
  space.bodies.emplace_back().id = "surfaces";
  project_.spaces.push_back(space);
}

std::uint32_t Scene::material(double rho) {
  for (std::size_t m = 0; m < project_.materials.size(); ++m) {
    if (project_.materials[m].reflectance == rho) return static_cast<std::uint32_t>(m);
  }
  project_.materials.push_back({"m" + std::to_string(project_.materials.size()), rho, {}});
  return static_cast<std::uint32_t>(project_.materials.size() - 1);
}

void Scene::add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                         double rho) {
  calc::Body& to = body();
  const auto first = static_cast<std::uint32_t>(to.vertex_m.size());
  to.vertex_m.insert(to.vertex_m.end(), {a, b, c});
  to.triangle.emplace_back(first, first + 1, first + 2);
  to.material_of.push_back(material(rho));
}

void Scene::add_quad(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                     double rho) {
  add_triangle(corner, corner + u, corner + u + v, rho);
  add_triangle(corner, corner + u + v, corner + v, rho);
}

void Scene::add_box(const glm::dvec3& low, const glm::dvec3& size, const FaceReflectances& rho) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 across(0.0), u(0.0), v(0.0);
    across[axis] = size[axis];
    u[(axis + 1) % 3] = size[(axis + 1) % 3];
    v[(axis + 2) % 3] = size[(axis + 2) % 3];
    add_quad(low, u, v, rho[static_cast<std::size_t>(2 * axis)]);
    add_quad(low + across, u, v, rho[static_cast<std::size_t>(2 * axis + 1)]);
  }
}

void Scene::add_box(const glm::dvec3& low, const glm::dvec3& size, double rho) {
  add_box(low, size, same_on_all(rho));
}

void Scene::add_luminaire(const calc::PhotometricWeb& web, const glm::dvec3& position_m,
                          const glm::dmat3& world_from_luminaire) {
  calc::LuminaireType type;
  type.id = "t" + std::to_string(project_.luminaire_types.size());
  type.web = project_.webs.size();
  project_.webs.push_back(web);
  calc::Luminaire luminaire;
  luminaire.id = "l" + std::to_string(project_.luminaire_types.size());
  luminaire.type = project_.luminaire_types.size();
  luminaire.position_m = position_m;
  luminaire.world_from_luminaire = world_from_luminaire;
  project_.luminaire_types.push_back(type);
  project_.spaces[0].luminaires.push_back(luminaire);
}

void Scene::repeat_luminaire(const glm::dvec3& position_m) {
  std::vector<calc::Luminaire>& luminaires = project_.spaces[0].luminaires;
  luminaires.push_back(luminaires.back());
  luminaires.back().id = "l" + std::to_string(luminaires.size());
  luminaires.back().position_m = position_m;
}

void Scene::add_luminous(const Rectangle& rectangle, double exitance_lm_m2) {
  const double along_u = glm::length(rectangle.u), along_v = glm::length(rectangle.v);
  const glm::dvec3 z = -rectangle.normal, x = rectangle.u / along_u;
  const calc::LuminousOpening opening{calc::OpeningShape::rectangle, along_u, along_v, 0.0};
  add_luminaire(lambert_web(exitance_lm_m2 / calc::kPi * along_u * along_v, opening),
                rectangle.corner + 0.5 * (rectangle.u + rectangle.v),
                glm::dmat3(x, glm::cross(z, x), z));
}

void Scene::move(const glm::dvec3& by) {
  for (glm::dvec3& vertex : body().vertex_m) vertex += by;
  for (calc::Luminaire& luminaire : project_.spaces[0].luminaires) luminaire.position_m += by;
}

double Scene::surface_m2() const {
  const calc::Body& of = project_.spaces[0].bodies[0];
  double sum = 0.0;
  for (const glm::uvec3& t : of.triangle) {
    sum += 0.5 * glm::length(glm::cross(of.vertex_m[t.y] - of.vertex_m[t.x],
                                        of.vertex_m[t.z] - of.vertex_m[t.x]));
  }
  return sum;
}

std::vector<double> Solution::replicates(std::size_t point, Part part) const {
  std::vector<double> values;
  const std::size_t count = is_sampled(field, part) ? field.replicates : 1;
  for (std::size_t r = 0; r < count; ++r) values.push_back(value_lx(field, r, point, part));
  return values;
}

std::vector<double> Solution::replicates(const std::vector<double>& weights, Part part) const {
  std::vector<double> values(is_sampled(field, part) ? field.replicates : 1, 0.0);
  for (std::size_t r = 0; r < values.size(); ++r) {
    for (std::size_t i = 0; i < field.points; ++i) {
      values[r] += weights[i] * value_lx(field, r, i, part);
    }
  }
  return values;
}

Solution solve(const Scene& scene, const std::vector<Point>& points, const Effort& effort,
               calc::ReceiverKernel kernel) {
  calc::SensorGrid grid;
  grid.kernel = kernel;
  for (const Point& point : points) {
    grid.position_m.push_back(point.position_m);
    grid.normal.push_back(point.normal);
  }
  return solve(scene.project(), scene.project().spaces[0], grid, effort);
}

Solution solve(const calc::Project& project, const calc::Space& space, const calc::SensorGrid& grid,
               const Effort& effort) {
  calc::RadiositySettings settings;
  settings.seed = effort.seed;
  settings.jobs = effort.jobs;
  settings.replicates = kReplicates;
  settings.max_paths = effort.paths;
  settings.first_paths = std::min(settings.first_paths, effort.paths);  // looks as of a check
  const calc::PreparedScene prepared = calc::prepare_scene(project, space);
  const auto gatherer = calc::make_cpu_gatherer();
  calc::SpaceSolution solved = calc::solve_illuminance(
      prepared, {{"plane", &grid}}, settings, 0.95, *gatherer,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});
  Solution solution;
  solution.field = std::move(solved.fields[0]);
  solution.problem = solution.field.problem.english();
  solution.balance = solved.balance;
  const calc::SolveCounters& counters = solution.field.counters;
  solution.rays =
      solved.pool_rays + counters.direct_rays + counters.connection_rays + counters.near_rays;
  return solution;
}

}  // namespace cli::selftest
