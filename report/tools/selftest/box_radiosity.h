#pragma once
// Calculates a closed box by classical radiosity on a fine mesh: form factors by Lambert's contour
// formula, no ray and no random number, independent of the program.

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace cli::selftest {

// Returns the direct illuminance (lx) at a point with unit normal.
using DirectLight = std::function<double(const glm::dvec3& x, const glm::dvec3& n)>;

// Returns the light of an isotropic source (cd).
DirectLight isotropic_light(double intensity_cd, const glm::dvec3& source);
// Returns the light of a source aimed straight down, of axis_cd cos gamma (cd).
DirectLight downlight(double axis_cd, const glm::dvec3& source);

// Faces in the order x = 0, x = size.x, y = 0, ... , z = size.z.
using FaceReflectances = std::array<double, 6>;
constexpr FaceReflectances same_on_all(double rho) { return {rho, rho, rho, rho, rho, rho}; }

// The box [0, size]: E = E_direct + F rho E on n x n patches per face that are smaller towards the
// edges, n >= 3, iterated until nothing changes; interpolated between the patches' centres.
class BoxRadiosity {
 public:
  BoxRadiosity(const glm::dvec3& size, const FaceReflectances& rho, DirectLight direct, int n);

  // Returns the light at any point in the box or on its faces, by unit normal.
  double indirect_lx(const glm::dvec3& x, const glm::dvec3& n) const;

 private:
  struct Patch {
    std::array<glm::dvec3, 4> corner;
    glm::dvec3 centre, normal;
    glm::dvec3 half_u, half_v;
    double rho;
    std::size_t face;

    double area_m2() const { return 4.0 * glm::length(half_u) * glm::length(half_v); }
  };
  static double factor(const glm::dvec3& x, const glm::dvec3& n, const Patch& patch);
  void add_face(const glm::dvec3& size, int axis, int side, double rho, int n);
  std::vector<double> factors() const;  // [from][to], of patches
  void solve();
  void refine();
  double indirect_at(const glm::dvec3& y, std::size_t face) const;
  double part_lx(const Patch& part, const glm::dvec3& x, const glm::dvec3& n) const;

  int n_;
  DirectLight direct_;
  std::vector<Patch> patches_;                  // [face][i][j]
  std::array<std::vector<double>, 3> centres_;  // of patches along x, y and z
  std::vector<double> indirect_lx_;             // at the patches' centres
};

// A number and its largest relative error.
struct KnownValue {
  double value = 0.0;
  double known_to = 0.0;
};

// Two meshes of a box: the value of the finer mesh, with an error bound from their difference.
//
// Near an edge radiosity changes like a root of the distance, and the value of a mesh there
// approaches the truth only as 1/n (measured for n = 6 ... 24, a millimetre from a corner: 36.57,
// 36.29, 36.11, 35.99, 35.87 lx towards 35.6). So the remaining error is e_fine = (e_coarse -
// e_fine) n_c / (n_f - n_c), twice the difference for 6 and 9. In the middle of a face it falls
// faster, and this bound is too large.
class BoxReference {
 public:
  BoxReference(const glm::dvec3& size, const FaceReflectances& rho, const DirectLight& direct);

  KnownValue indirect_lx(const glm::dvec3& x, const glm::dvec3& n) const;

 private:
  BoxRadiosity coarse_, fine_;
};

}  // namespace cli::selftest
