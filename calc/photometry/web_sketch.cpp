#include "calc/photometry/web_sketch.h"

#include "calc/base/units.h"
#include "calc/base/wide.h"
#include "calc/photometry/web_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace calc {
namespace {

// Finest steps: a quarter of a degree of gamma, five of C.
constexpr std::size_t kMostGammas = 720, kMostPlanes = 72;
constexpr float kPi_f = std::numbers::pi_v<float>;
constexpr float kEdge = 1e-6f;  // rad: roundings of an angle

bool are_ends_of_steps(const std::vector<double>& nodes_rad, double range_rad, std::size_t steps) {
  return std::all_of(nodes_rad.begin(), nodes_rad.end(), [&](double node_rad) {
    const double place = node_rad / range_rad * static_cast<double>(steps);
    return std::abs(place - std::round(place)) < 1e-9;
  });
}

// Steps of `range_rad`, as wide as the narrowest of the nodes where steps so wide meet them all.
std::size_t steps_of(const std::vector<double>& nodes_rad, double range_rad, std::size_t most) {
  double least_rad = range_rad;
  for (std::size_t i = 0; i + 1 < nodes_rad.size(); ++i) {
    least_rad = std::min(least_rad, nodes_rad[i + 1] - nodes_rad[i]);
  }
  const double steps = std::round(range_rad / least_rad);
  if (!(steps < static_cast<double>(most))) return most;
  const std::size_t even = std::max<std::size_t>(1, static_cast<std::size_t>(steps));
  return are_ends_of_steps(nodes_rad, range_rad, even) ? even : most;
}

#define TERM [[gnu::always_inline]] inline
#define ABSOLUTE std::fabs
#include "calc/photometry/turn_of.glsl"
#undef ABSOLUTE
#undef TERM

struct SketchTable {
  const float* cd;  // [plane][gamma], one more of each than steps
  int last_plane, last_gamma, stride;
  float planes_per_rad, gammas_per_rad;
  float begin, end;  // of the web's gammas, in steps; dark outside
};

LUXGATE_WIDE void sketched_light(const SketchTable& table, std::size_t n,
                                 const float* __restrict__ x_m, const float* __restrict__ y_m,
                                 const float* __restrict__ z_m, const float* __restrict__ factor,
                                 float* __restrict__ lx) {
  const float* __restrict__ cd = table.cd;
  const int last_plane = table.last_plane, last_gamma = table.last_gamma, stride = table.stride;
  const float planes_per_rad = table.planes_per_rad, gammas_per_rad = table.gammas_per_rad;
  const float begin = table.begin, end = table.end;
  for (std::size_t k = 0; k < n; ++k) {
    const float x = x_m[k], y = y_m[k], z = z_m[k];
    const float across2 = x * x + y * y;
    const float d2 = across2 + z * z;
    const float d3 = d2 * __builtin_sqrtf(d2);
    const float gamma = turn_of(__builtin_sqrtf(across2), -z) * gammas_per_rad;
    float c = turn_of(y, x);
    c = (c < 0.0f ? c + 2.0f * kPi_f : c) * planes_per_rad;
    int row = static_cast<int>(gamma), plane = static_cast<int>(c);
    row = row < last_gamma ? row : last_gamma;
    plane = plane < last_plane ? plane : last_plane;
    const float s = gamma - static_cast<float>(row), t = c - static_cast<float>(plane);
    const int at = plane * stride + row;
    const float here = cd[at] + s * (cd[at + 1] - cd[at]);
    const float next = cd[at + stride] + s * (cd[at + stride + 1] - cd[at + stride]);
    const float inside = gamma < begin || gamma > end ? 0.0f : factor[k];
    lx[k] = inside * (here + t * (next - here)) / (d3 > 1e-30f ? d3 : 1e-30f);
  }
}

}  // namespace

WebSketch::WebSketch(const PhotometricWeb& web)
    : planes_(web.is_axial() ? 1 : steps_of(web.c_rad(), 2.0 * kPi, kMostPlanes)),
      gammas_(steps_of(web.gamma_rad(), kPi, kMostGammas)),
      begin_rad_(web.gamma_rad().front()),
      end_rad_(web.gamma_rad().back()),
      finest_rad_(narrowest_beam_rad(web)),
      gamma_rad_(web.gamma_rad()),
      most_cd_(gamma_rad_.size(), 0.0) {
  for (std::size_t g = 0; g < gamma_rad_.size(); ++g) {
    for (std::size_t p = 0; p < web.c_rad().size(); ++p) {
      most_cd_[g] = std::max(most_cd_[g], web.table_cd(p, g));
    }
  }
  fill(web);
  if (are_ends_of_steps(web.gamma_rad(), kPi, gammas_) &&
      (web.is_axial() || are_ends_of_steps(web.c_rad(), 2.0 * kPi, planes_))) {
    return;
  }
  largest_error_share_ += measured_error_cd(web) / web.max_intensity_cd();
}

void WebSketch::fill(const PhotometricWeb& web) {
  constexpr double kBesidePole_rad = 1e-9;  // at the pole the web has one value for all C
  for (std::size_t p = 0; p <= planes_; ++p) {
    const double c_rad = 2.0 * kPi * static_cast<double>(p) / static_cast<double>(planes_);
    for (std::size_t g = 0; g <= gammas_; ++g) {
      const double gamma_rad = kPi * static_cast<double>(g) / static_cast<double>(gammas_);
      const double inside_rad = std::clamp(gamma_rad, std::max(begin_rad_, kBesidePole_rad),
                                           std::min(end_rad_, kPi - kBesidePole_rad));
      cd_.push_back(static_cast<float>(web.at_table_angles_cd(c_rad, inside_rad)));
    }
  }
}

double WebSketch::measured_error_cd(const PhotometricWeb& web) const {
  SketchLanes lanes;
  std::vector<double> exact_cd;
  const auto ask = [&](double c_rad, double gamma_rad) {
    const std::array<double, 3> way = direction_of({c_rad, gamma_rad});
    lanes.add(*this, {way[0], way[1], way[2]}, 1.0);
    exact_cd.push_back(web.at_table_angles_cd(c_rad, gamma_rad));
  };
  const std::vector<double>&c_rad = web.c_rad(), &gamma_rad = web.gamma_rad();
  for (std::size_t p = 0; p < c_rad.size(); ++p) {
    const bool is_last = p + 1 == c_rad.size();
    const double between_rad = is_last ? c_rad[p] : 0.5 * (c_rad[p] + c_rad[p + 1]);
    for (std::size_t g = 0; g + 1 < gamma_rad.size(); ++g) {
      if (g > 0) ask(c_rad[p], gamma_rad[g]);
      ask(between_rad, 0.5 * (gamma_rad[g] + gamma_rad[g + 1]));
    }
  }
  evaluate(lanes);
  double largest_cd = 0.0;
  for (std::size_t k = 0; k < exact_cd.size(); ++k) {
    largest_cd = std::max(largest_cd, std::abs(static_cast<double>(lanes.lx[k]) - exact_cd[k]));
  }
  return largest_cd;
}

WebSketch::Band WebSketch::band(double from_rad, double to_rad) const {
  constexpr double kRounding_rad = 1e-9;
  const double from = from_rad - kRounding_rad, to = to_rad + kRounding_rad;
  if (to < gamma_rad_.front() || from > gamma_rad_.back()) return {};
  // The angles of the table that hold the range between them, on both sides.
  const auto after = std::upper_bound(gamma_rad_.begin(), gamma_rad_.end(), from);
  const auto begin = after == gamma_rad_.begin() ? after : after - 1;
  const auto end = std::lower_bound(gamma_rad_.begin(), gamma_rad_.end(), to);
  const auto at = [&](auto place) { return most_cd_.begin() + (place - gamma_rad_.begin()); };
  const auto [least, most] =
      std::minmax_element(at(begin), at(end == gamma_rad_.end() ? end : end + 1));
  const bool has_end = (from < gamma_rad_.front() && gamma_rad_.front() > 0.0) ||
                       (to > gamma_rad_.back() && gamma_rad_.back() < kPi);
  return {*most, *least == 0.0 || has_end};
}

WebSketch::Table WebSketch::table() const {
  const float gammas_per_rad = static_cast<float>(gammas_) / kPi_f;
  return {planes_, gammas_, (static_cast<float>(begin_rad_) - kEdge) * gammas_per_rad,
          (static_cast<float>(end_rad_) + kEdge) * gammas_per_rad, cd_};
}

void WebSketch::light_of(std::size_t n, const float* x_m, const float* y_m, const float* z_m,
                         const float* factor, float* lx) const {
  const Table from = table();
  const SketchTable table{cd_.data(),
                          static_cast<int>(planes_) - 1,
                          static_cast<int>(gammas_) - 1,
                          static_cast<int>(gammas_) + 1,
                          static_cast<float>(planes_) / (2.0f * kPi_f),
                          static_cast<float>(gammas_) / kPi_f,
                          from.begin,
                          from.end};
  sketched_light(table, n, x_m, y_m, z_m, factor, lx);
}

void SketchLanes::clear() {
  for (std::vector<float>* list : {&x_m, &y_m, &z_m, &factor, &lx}) list->clear();
  sketch.clear();
}

void SketchLanes::add(const WebSketch& its_sketch, const glm::dvec3& way_m, double its_factor) {
  x_m.push_back(static_cast<float>(way_m.x));
  y_m.push_back(static_cast<float>(way_m.y));
  z_m.push_back(static_cast<float>(way_m.z));
  factor.push_back(static_cast<float>(its_factor));
  sketch.push_back(&its_sketch);
}

void evaluate(SketchLanes& lanes) {
  const std::size_t count = lanes.sketch.size();
  lanes.lx.resize(count);
  for (std::size_t first = 0; first < count;) {
    const WebSketch* sketch = lanes.sketch[first];
    std::size_t last = first + 1;
    while (last < count && lanes.sketch[last] == sketch) ++last;
    sketch->light_of(last - first, &lanes.x_m[first], &lanes.y_m[first], &lanes.z_m[first],
                     &lanes.factor[first], &lanes.lx[first]);
    first = last;
  }
}

}  // namespace calc
