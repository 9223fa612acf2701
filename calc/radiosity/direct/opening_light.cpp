#include "calc/radiosity/direct/opening_light.h"

#include "calc/photometry/web_sketch.h"
#include "calc/radiosity/terms/connection_terms.h"
#include "calc/radiosity/terms/opening_constants.h"
#include "calc/scene/opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace calc {
namespace {

// Places of a patch, as directions to the receiver.
class PlaceLanes {
 public:
  PlaceLanes(const PlacedLuminaire& luminaire, const Receiver& receiver, SketchLanes& lanes)
      : luminaire_(luminaire),
        receiver_(receiver),
        sketch_(luminaire.web->sketch()),
        lanes_(lanes) {}

  // Places are centre + x u + y v.
  void set(const glm::dvec3& centre_m, const glm::dvec3& u_m, const glm::dvec3& v_m) {
    world_ = {centre_m - receiver_.position_m, u_m, v_m};
    for (std::size_t k = 0; k < world_.size(); ++k) table_[k] = in_table(-world_[k]);
  }
  void add(double x, double y) {
    const glm::dvec3 to_source_m = world_[0] + x * world_[1] + y * world_[2];
    const double response_times_m =
        response_times_distance(receiver_.kernel, receiver_.axis, to_source_m);
    lanes_.add(sketch_, table_[0] + x * table_[1] + y * table_[2],
               luminaire_.flux_scale * std::max(0.0, response_times_m));
  }

 private:
  glm::dvec3 in_table(const glm::dvec3& way_m) const {
    const glm::dvec3 own_m = glm::transpose(luminaire_.world_from_luminaire) * way_m;
    const std::array<double, 3> turned = luminaire_.web->to_table({own_m.x, own_m.y, own_m.z});
    return {turned[0], turned[1], turned[2]};
  }

  const PlacedLuminaire& luminaire_;
  const Receiver& receiver_;
  const WebSketch& sketch_;
  SketchLanes& lanes_;
  std::array<glm::dvec3, 3> world_, table_;  // centre, u, v: from the receiver; towards it
};

// A part of a flat opening that is seen in full: light from (x, y) in [-1, 1]^2, or in the unit
// disk, as a polynomial.
class OpeningPatch {
 public:
  OpeningPatch(const PlacedLuminaire& luminaire, const Receiver& receiver, const OpeningCell& cell)
      : luminaire_(luminaire), share_(cell.size_s * cell.size_t) {
    const LuminousOpening& opening = luminaire.opening;
    is_disk_ = opening.shape == OpeningShape::disk;
    const glm::dmat3& axes = luminaire.world_from_luminaire;
    const double u = 0.5 * opening.along_c0_m, v = 0.5 * opening.along_c90_m;
    u_m_ = cell.size_s * u * axes[0];
    v_m_ = cell.size_t * v * axes[1];
    centre_m_ = luminaire.position_m + (2.0 * cell.s + cell.size_s - 1.0) * u * axes[0] +
                (2.0 * cell.t + cell.size_t - 1.0) * v * axes[1];
    const double size_m = 2.0 * std::sqrt(glm::dot(u_m_, u_m_) + glm::dot(v_m_, v_m_));
    ratio_ = size_m / glm::length(centre_m_ - receiver.position_m);
    beam_rad_ = luminaire.web->sketch().finest_rad();
    most_cd_ =
        is_narrow()
            ? intensities_towards(luminaire, centre_m_, 0.5 * size_m, receiver.position_m).most_cd
            : luminaire.web->max_intensity_cd() * luminaire.flux_scale;
  }

  bool is_narrow() const { return std::isfinite(beam_rad_); }
  // No light of it comes here.
  bool is_dark() const { return is_narrow() && most_cd_ == 0.0; }

  // Its places are asked for: 1, 5 or 9 of them, in the order in which fit() takes their light.
  void ask(const Receiver& receiver, SketchLanes& lanes) const {
    PlaceLanes places(luminaire_, receiver, lanes);
    places.set(centre_m_, kPlace * u_m_, kPlace * v_m_);
    if (places_asked() == 9) {
      for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) places.add(x, y);
      }
      return;
    }
    places.add(0, 0);
    if (places_asked() == 1) return;
    add_cross(places, 1.0);
  }
  std::size_t places_asked() const {
    return ratio_ < std::min(kOnePlace, kOnePlaceOfBeam * beam_rad_)       ? 1
           : ratio_ < std::min(kFivePlaces, kFivePlacesOfBeam * beam_rad_) ? 5
                                                                           : 9;
  }
  double largest_ratio() const { return std::min(kLargestPatch, kPartOfBeam * beam_rad_); }

  double ratio() const { return ratio_; }  // of its size to its distance
  // lx: of its places. False: all are dark, and the light may still begin at a corner or be a
  // narrow beam between: ask_more() and fit_dark().
  bool fit(const Receiver& receiver, const float* lx) {
    if (std::all_of(lx, lx + places_asked(), [](float value) { return !(value > 0.0f); })) {
      return false;
    }
    const auto at = [lx](std::size_t k) { return static_cast<double>(lx[k]); };
    if (places_asked() == 9) {
      fit_nine(receiver, {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8)});
    } else if (places_asked() == 5) {
      fit_five(receiver, {at(0), at(1), at(2), at(3), at(4)});
    } else {
      c_[0][0] = at(0);
      rest_lx_ = (is_narrow() ? ratio_ / beam_rad_ : ratio_) * at(0) + unseen_lx(receiver);
    }
    return true;
  }
  static constexpr std::size_t kMorePlaces = 8;
  void ask_more(const Receiver& receiver, SketchLanes& lanes) const {
    PlaceLanes places(luminaire_, receiver, lanes);
    places.set(centre_m_, u_m_, v_m_);
    add_cross(places, kPlace);
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) places.add(x, y);
    }
  }
  void fit_dark(const Receiver& receiver, const float* lx) {
    const auto at = [lx](std::size_t k) { return static_cast<double>(lx[k]); };
    fit_five(receiver, {0.0, at(0), at(1), at(2), at(3)});
    const double corner_lx = std::max({at(4), at(5), at(6), at(7)});
    rest_lx_ += (ratio_ * ratio_ + kPatchFloor) * corner_lx;
  }
  // Mean of the polynomial over the patch, times its share of the opening.
  double known_lx() const {
    const double xx = is_disk_ ? 0.25 : 1.0 / 3.0, xxyy = is_disk_ ? 1.0 / 24.0 : 1.0 / 9.0;
    return share_ * (c_[0][0] + xx * (c_[2][0] + c_[0][2]) + xxyy * c_[2][2]);
  }
  // About how large the rest may be.
  double rest_lx() const { return share_ * rest_lx_; }
  // The rest at a place, in [0, 1)^2 as OpeningView has it.
  double rest_lx(const Receiver& receiver, double s, double t) const {
    const glm::dvec2 at = is_disk_ ? unit_disk(s, t) : glm::dvec2(2.0 * s - 1.0, 2.0 * t - 1.0);
    double polynomial = 0.0;
    for (std::size_t i = 3; i-- > 0;) {
      polynomial = polynomial * at.x + (c_[i][0] + at.y * (c_[i][1] + at.y * c_[i][2]));
    }
    return share_ * (light_lx(receiver, at.x, at.y) - polynomial);
  }

 private:
  double light_lx(const Receiver& receiver, double x, double y) const {
    return point_illuminance_lx(luminaire_, centre_m_ + x * u_m_ + y * v_m_, receiver);
  }

  // p(-h), p(0), p(h) -> coefficients of x and x^2.
  static constexpr double kPlace = 0.7745966692414834;  // sqrt(3/5), of Gauss's rule
  static glm::dvec2 curve(double before, double middle, double after) {
    return {(after - before) / (2.0 * kPlace),
            (after - 2.0 * middle + before) / (2.0 * kPlace * kPlace)};
  }

  // Middle, west, east, south, north.
  void fit_five(const Receiver& receiver, const std::array<double, 5>& lx) {
    const glm::dvec2 x = curve(lx[1], lx[0], lx[2]), y = curve(lx[3], lx[0], lx[4]);
    c_[0][0] = lx[0];
    c_[1][0] = x[0], c_[2][0] = x[1], c_[0][1] = y[0], c_[0][2] = y[1];
    take_range(receiver, *std::min_element(lx.begin(), lx.end()),
               *std::max_element(lx.begin(), lx.end()));
  }

  // From south to north, from west to east.
  void fit_nine(const Receiver& receiver, const std::array<double, 9>& lx) {
    std::array<std::array<double, 3>, 3> along_y;  // [x place]: coefficients of 1, y, y^2
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2 y = curve(lx[3 * i], lx[3 * i + 1], lx[3 * i + 2]);
      along_y[i] = {lx[3 * i + 1], y[0], y[1]};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 x = curve(along_y[0][k], along_y[1][k], along_y[2][k]);
      c_[0][k] = along_y[1][k], c_[1][k] = x[0], c_[2][k] = x[1];
    }
    take_range(receiver, *std::min_element(lx.begin(), lx.end()),
               *std::max_element(lx.begin(), lx.end()));
  }

  // West, east, south, north.
  static void add_cross(PlaceLanes& places, double reach) {
    places.add(-reach, 0);
    places.add(reach, 0);
    places.add(0, -reach);
    places.add(0, reach);
  }

  // Smooth light differs from the polynomial by about the square of the ratio; that of a beam as
  // wide as the part, by all that it is.
  void take_range(const Receiver& receiver, double lowest_lx, double highest_lx) {
    rest_lx_ = (is_narrow() ? of_beam() : ratio_ * ratio_) * (highest_lx - lowest_lx) +
               kPatchFloor * highest_lx + unseen_lx(receiver);
  }

  double of_beam() const {
    const double share = 0.5 * ratio_ / beam_rad_;
    return std::min(1.0, share * share);
  }

  // What places may have missed.
  double unseen_lx(const Receiver& receiver) const {
    const double floor = is_narrow() ? kUnseenOfBeam * of_beam() : 0.0;
    return (std::max(floor, kUnseenFloor) + luminaire_.web->sketch().largest_error_share()) *
           most_lx(receiver);
  }

  // At its largest intensity, head-on.
  double most_lx(const Receiver& receiver) const {
    const glm::dvec3 away = centre_m_ - receiver.position_m;
    const double reach_m2 = glm::dot(u_m_, u_m_) + glm::dot(v_m_, v_m_);
    return most_cd_ / std::max(glm::dot(away, away), reach_m2);
  }

  const PlacedLuminaire& luminaire_;
  bool is_disk_;
  double share_;
  double ratio_;     // of its size to its distance
  double beam_rad_;  // see WebSketch::finest_rad()
  double most_cd_;   // that it may send this way
  glm::dvec3 centre_m_, u_m_, v_m_;
  std::array<std::array<double, 3>, 3> c_{};  // [power of x][power of y]
  double rest_lx_ = 0.0;
};

std::array<glm::dvec3, 4> lifted_corners(const PlacedLuminaire& luminaire,
                                         const glm::dvec3& receiver_m, double offset_m) {
  const LuminousOpening& opening = luminaire.opening;
  const glm::dvec3 u = 0.5 * opening.along_c0_m * luminaire.world_from_luminaire[0],
                   v = 0.5 * opening.along_c90_m * luminaire.world_from_luminaire[1];
  std::array<glm::dvec3, 4> corner{-u - v, u - v, u + v, v - u};
  for (glm::dvec3& p : corner) {
    p = lifted_source_m(luminaire, luminaire.position_m + p, receiver_m, offset_m);
  }
  return corner;
}

// Patches of one channel all of whose light arrives, and the samples of their rest.
class SeenOpenings {
 public:
  void clear() {
    patches_.clear();
    lanes_.clear();
    cumulative_.clear();
    known_lx_ = 0.0;
  }

  void add(const PlacedLuminaire& luminaire, const Receiver& receiver, const OpeningCell& cell) {
    const OpeningPatch patch(luminaire, receiver, cell);
    if (patch.is_dark()) return;
    if (patch.ratio() > patch.largest_ratio() &&
        luminaire.opening.shape == OpeningShape::rectangle &&
        cell.size_s * cell.size_t > kSmallestShare) {
      for (const OpeningCell& half : halves(luminaire.opening, cell)) {
        add(luminaire, receiver, half);
      }
      return;
    }
    patch.ask(receiver, lanes_);
    patches_.push_back(patch);
  }

  // Once all are there.
  void fit(const Receiver& receiver) {
    evaluate(lanes_);
    std::size_t lane = 0;
    for (OpeningPatch& patch : patches_) {
      if (!patch.fit(receiver, &lanes_.lx[lane])) dark_.push_back(&patch);
      lane += patch.places_asked();
    }
    fit_dark_ones(receiver);
    for (const OpeningPatch& patch : patches_) {
      known_lx_ += patch.known_lx();
      cumulative_.push_back((cumulative_.empty() ? 0.0 : cumulative_.back()) + patch.rest_lx());
    }
  }

  double known_lx() const { return known_lx_; }

  // Of each round.
  std::size_t rest_samples(double error_factor) const {
    if (patches_.empty()) return 0;
    const double share =
        kMeanRest * cumulative_.back() / (kRestWantedError * error_factor * known_lx_);
    if (!(share * share < static_cast<double>(kMostRestSamples))) return kMostRestSamples;
    return std::max(kFewestRestSamples, static_cast<std::size_t>(std::ceil(share * share)));
  }

  // One round of one replicate.
  double sample_rest_lx(const Receiver& receiver, RandomKey key, std::size_t samples) const {
    if (patches_.empty() || !(cumulative_.back() > 0.0)) return 0.0;
    const auto count = static_cast<double>(samples);
    double sum = 0.0;
    for (std::size_t k = 0; k < samples; ++k) {
      const RandomKey sample = key.with(k);
      const double u = (static_cast<double>(k) + sample.with(0).uniform()) / count;
      const auto found =
          std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u * cumulative_.back());
      const OpeningPatch& patch = patches_[static_cast<std::size_t>(found - cumulative_.begin())];
      if (!(patch.rest_lx() > 0.0)) continue;
      const double weight = cumulative_.back() / (patch.rest_lx() * count);
      sum += weight * patch.rest_lx(receiver, sample.with(1).uniform(), sample.with(2).uniform());
    }
    return sum;
  }

 private:
  void fit_dark_ones(const Receiver& receiver) {
    lanes_.clear();
    for (const OpeningPatch* patch : dark_) patch->ask_more(receiver, lanes_);
    evaluate(lanes_);
    std::size_t lane = 0;
    for (OpeningPatch* patch : dark_) {
      patch->fit_dark(receiver, &lanes_.lx[lane]);
      lane += OpeningPatch::kMorePlaces;
    }
    dark_.clear();
  }

  static constexpr double kSmallestShare = 0x1p-40;  // of an opening: it touches the receiver

  static std::array<OpeningCell, 2> halves(const LuminousOpening& opening,
                                           const OpeningCell& cell) {
    OpeningCell first = cell;
    const bool is_along_s = cell.size_s * opening.along_c0_m >= cell.size_t * opening.along_c90_m;
    (is_along_s ? first.size_s : first.size_t) *= 0.5;
    OpeningCell second = first;
    (is_along_s ? second.s : second.t) += is_along_s ? first.size_s : first.size_t;
    return {first, second};
  }

  std::vector<OpeningPatch> patches_;
  std::vector<OpeningPatch*> dark_;
  SketchLanes lanes_;               // places of all, one patch after the other
  std::vector<double> cumulative_;  // of rest_lx()
  double known_lx_ = 0.0;
};

// Channel by channel, so that what is known of one does not hang on how bright another is.
void add_seen(std::span<const SeenOpenings> seen, const Receiver& receiver, RandomKey key,
              const OpeningRounds& rounds, const OpeningSums& sums) {
  for (std::size_t c = 0; c < seen.size(); ++c) {
    if (rounds.first == 0) sums.known_lx[c * sums.stride] += seen[c].known_lx();
    const std::size_t samples = seen[c].rest_samples(rounds.error_factor);
    for (std::size_t r = 0; r < rounds.replicates; ++r) {
      const RandomKey rest_key = key.with(r).with("rest").with(c);
      double& sum = sums.sampled_lx[r * sums.replicate_stride + c * sums.stride];
      for (std::uint32_t i = rounds.first; i < rounds.last; ++i) {
        sum += seen[c].sample_rest_lx(receiver, rest_key.with(i), samples);
      }
    }
  }
}

void widen(SightBox& box, const glm::dvec3& p) {
  box.low_m = glm::min(box.low_m, p);
  box.high_m = glm::max(box.high_m, p);
}

bool is_flat(const LuminousOpening& opening) {
  return opening.shape == OpeningShape::rectangle || opening.shape == OpeningShape::disk;
}

// Few cells, each a smooth part of the opening.
bool has_patches(const PlacedLuminaire& luminaire, const std::vector<OpeningCell>& cells) {
  return is_flat(luminaire.opening) &&
         (luminaire.opening.shape == OpeningShape::rectangle || cells.size() == 1);
}

Sight sight_of_cells(const Tracer& tracer, const PlacedLuminaire& luminaire,
                     const std::vector<OpeningCell>& cells, const Receiver& receiver,
                     bool has_shadows) {
  if (cells.empty()) return Sight::hidden;
  if (!has_patches(luminaire, cells)) return Sight::unknown;
  if (!has_shadows) return Sight::free;
  return tracer.sight(tracer.lift(receiver),
                      lifted_corners(luminaire, receiver.position_m, tracer.offset_m()));
}

}  // namespace

Sight opening_sight(const Tracer& tracer, std::size_t luminaire, const Receiver& receiver,
                    bool has_shadows) {
  const PlacedLuminaire& placed = tracer.scene().luminaires[luminaire];
  return sight_of_cells(tracer, placed, opening_cells(placed, receiver.position_m), receiver,
                        has_shadows);
}

std::vector<std::uint8_t> find_free_openings(const Tracer& tracer,
                                             std::span<const Receiver> receivers,
                                             const DirectProofs& proofs) {
  const auto& luminaires = tracer.scene().luminaires;
  std::vector<std::uint8_t> is_free(luminaires.size(), 0);
  if (!proofs.has_shadows || receivers.empty()) return is_free;  // needs no proof
  const glm::dvec3 first_m = tracer.lift(receivers.front());
  SightBox from{first_m, first_m}, at{receivers.front().position_m, receivers.front().position_m};
  for (const Receiver& receiver : receivers) {
    widen(from, tracer.lift(receiver));
    widen(at, receiver.position_m);
  }
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    if (!is_flat(luminaires[l].opening) || proofs.leaves_out(l)) continue;
    // The opening is lifted to the side of the receiver: to both, if they are on both.
    const auto lifted = [&](const glm::dvec3& p) {
      return lifted_corners(luminaires[l], p, tracer.offset_m());
    };
    const glm::dvec3 any_m = lifted(at.low_m)[0];
    SightBox to{any_m, any_m};
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 p((k & 1) != 0 ? at.high_m.x : at.low_m.x,
                         (k & 2) != 0 ? at.high_m.y : at.low_m.y,
                         (k & 4) != 0 ? at.high_m.z : at.low_m.z);
      for (const glm::dvec3& corner_m : lifted(p)) widen(to, corner_m);
    }
    is_free[l] = static_cast<std::uint8_t>(tracer.is_free_between(from, to));
  }
  return is_free;
}

DirectRays add_openings(const Tracer& tracer, const Receiver& receiver, const DirectProofs& proofs,
                        RandomKey key, const OpeningRounds& rounds, const OpeningSums& sums) {
  thread_local std::vector<SeenOpenings> seen;
  seen.resize(tracer.scene().channels.size());
  for (SeenOpenings& channel : seen) channel.clear();
  ShadowBatch batch(tracer, proofs.has_shadows, kReceiverToSource);
  const auto& luminaires = tracer.scene().luminaires;
  const auto sampled = [&](std::size_t replicate) {
    return sums.sampled_lx + replicate * sums.replicate_stride;
  };
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    const PlacedLuminaire& luminaire = luminaires[l];
    if (luminaire.opening.shape == OpeningShape::point || proofs.leaves_out(l)) continue;
    const std::vector<OpeningCell> cells =
        opening_cells(luminaire, receiver.position_m, rounds.error_factor);
    const bool is_free = !proofs.is_free.empty() && proofs.is_free[l] != 0;
    const Sight sight =
        sight_of_cells(tracer, luminaire, cells, receiver, proofs.has_shadows && !is_free);
    if (sight == Sight::hidden) continue;
    if (sight == Sight::free) {
      for (const OpeningCell& cell : cells) seen[luminaire.channel].add(luminaire, receiver, cell);
      continue;
    }
    for (std::size_t r = 0; r < rounds.replicates; ++r) {
      add_opening_samples(batch, tracer, l, cells, receiver, key.with(r), rounds.first, rounds.last,
                          sampled(r), sums.stride, sums.largest);
    }
  }
  batch.flush();
  for (SeenOpenings& channel : seen) channel.fit(receiver);
  add_seen(seen, receiver, key, rounds, sums);
  return {batch.rays(), batch.has_contributions(), batch.has_hidden(), batch.has_seen()};
}

}  // namespace calc
