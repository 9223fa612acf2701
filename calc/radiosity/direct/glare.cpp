#include "calc/radiosity/direct/glare.h"

#include "calc/base/elementary.h"
#include "calc/glare/position_index.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/direct/opening_light.h"
#include "calc/radiosity/sampling/shadow_batch.h"
#include "calc/scene/opening.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace calc {
namespace {

// Of a whole of which only so much is seen: how far that may be off, one straight edge.
double doubt_of(double share) { return share < 1.0 ? 1.0 / static_cast<double>(kSightLines) : 0.0; }

// Lines of sight from an eye to an opening: how much could reach it, and how much does. Each line
// stands for the same part of the opening and weighs 1, or 1 / p^2 of its own end.
struct SeenEnds {
  double open = 0.0, all = 0.0;
  double sure_open = 0.0, sure_all = 0.0;    // the same of Counted::sure
  std::size_t facing = 0;                    // ends that face the eye, whatever they weigh
  std::vector<std::uint8_t> faces, is_seen;  // [end]; seen: only of those that weigh anything

  double part() const { return all / static_cast<double>(facing); }
  // Of the whole with an index of 1, at least.
  double sure() const {
    if (!(sure_all > 0.0)) return 0.0;
    return std::max(0.0, sure_open - doubt_of(sure_open / sure_all) * sure_all) /
           static_cast<double>(facing);
  }
};

// What counts of an opening: a weight for each end.
struct Counted {
  std::vector<double> weights;
  std::vector<double> sure;  // 1 / p^2 of ends that have an index on the table, else 0
  bool is_below = false;     // something of it is below the line of sight

  bool is_nothing() const {
    return std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.0; });
  }
};

// The parts in the field of indices, each with its own: Iwata's below the line of sight.
Counted parts_in_field(const std::vector<OpeningView::Point>& ends, const Receiver& receiver) {
  Counted parts{std::vector<double>(ends.size(), 0.0), std::vector<double>(ends.size(), 0.0)};
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const glm::dvec3 to_end = ends[k].position_m - receiver.position_m;
    const SeenAt end(to_end, receiver.axis);
    if (!end.is_in_field()) continue;
    parts.is_below = parts.is_below || end.is_below();
    const std::optional<double> index =
        end.is_below() ? iwata_index(to_end, receiver.axis) : guth_index(to_end, receiver.axis);
    if (!index) continue;
    parts.weights[k] = 1.0 / (*index * *index);
    if (end.is_on_table()) parts.sure[k] = parts.weights[k];
  }
  return parts;
}

// Usually a source counts by its centre. One whose centre is outside the field may still reach into
// it, and then counts with its parts on the table, each with its own index; a large one (add_large)
// with all in the field, and so does one that is also below the line of sight. Sure of one whose
// centre is not on the table are its parts on it.
Counted counted_of(const SeenAt& centre, bool is_large, const std::vector<OpeningView::Point>& ends,
                   const Receiver& receiver) {
  const std::vector<double> all(ends.size(), 1.0);
  if (centre.is_on_table()) return {all, {}};
  Counted counted = parts_in_field(ends, receiver);
  const bool is_above = centre.is_in_field() && !centre.is_below();
  if (counted.is_below && !is_above) return counted;
  if (is_above) {
    counted.weights = all;
    counted.is_below = false;
  } else if (!is_large) {
    counted.weights = counted.sure;
  }
  return counted;
}

// The ends of lines of sight, evenly spread over an opening: a Hammersley set, of which no row or
// column hides behind the slats of a louvre.
std::vector<OpeningView::Point> sight_ends(const PlacedLuminaire& luminaire,
                                           const Receiver& receiver) {
  const glm::dvec3 towards = glm::normalize(receiver.position_m - luminaire.position_m);
  const OpeningView view(luminaire, towards);
  const bool is_point = luminaire.opening.shape == OpeningShape::point;
  const std::uint32_t count = is_point ? 1 : kSightLines * kSightLines;
  std::vector<OpeningView::Point> ends;
  ends.reserve(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    double reversed = 0.0, digit = 0.5;
    for (std::uint32_t bits = k; bits != 0; bits >>= 1, digit *= 0.5) {
      if ((bits & 1u) != 0) reversed += digit;
    }
    ends.push_back(view.point((k + 0.5) / count, reversed + 0.5 / count));
  }
  return ends;
}

SeenEnds look_at(const Tracer& tracer, const PlacedLuminaire& luminaire, const Receiver& receiver,
                 Sight proved, const std::vector<OpeningView::Point>& ends, const Counted& counted,
                 std::uint64_t& rays) {
  ShadowBatch batch(tracer, proved == Sight::unknown, kReceiverToSource);
  const glm::vec3 from(tracer.lift(receiver));
  std::vector<double> is_seen(ends.size(), 0.0);
  SeenEnds sight;
  sight.faces.assign(ends.size(), 0);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const OpeningView::Point& at = ends[k];
    glm::dvec3 to =
        lifted_source_m(luminaire, at.position_m, receiver.position_m, tracer.offset_m());
    if (luminaire.opening.is_body()) {
      // The outline is that for a far eye; a near one sees less of a body.
      if (!(glm::dot(at.normal, receiver.position_m - at.position_m) > 0.0)) continue;
      to = at.position_m + tracer.offset_m() * at.normal;
    }
    ++sight.facing;
    sight.faces[k] = 1;
    if (!(counted.weights[k] > 0.0)) continue;
    sight.all += counted.weights[k];
    if (!counted.sure.empty()) sight.sure_all += counted.sure[k];
    if (proved != Sight::hidden) batch.add(from, glm::vec3(to), 1.0, &is_seen[k]);
  }
  batch.flush();
  rays += batch.rays();
  for (std::size_t k = 0; k < ends.size(); ++k) {
    sight.open += counted.weights[k] * is_seen[k];
    if (!counted.sure.empty()) sight.sure_open += counted.sure[k] * is_seen[k];
    sight.is_seen.push_back(is_seen[k] > 0.0 ? 1 : 0);
  }
  return sight;
}

double intensity_cd(const PlacedLuminaire& luminaire, const glm::dvec3& direction) {
  const glm::dvec3 out = glm::transpose(luminaire.world_from_luminaire) * direction;
  return luminaire.web->intensity_cd({out.x, out.y, out.z}) * luminaire.flux_scale;
}

class GlareEye {
 public:
  GlareEye(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
           std::span<GlareSum> sums)
      : tracer_(tracer),
        receiver_(receiver),
        has_shadows_(has_shadows),
        sums_(sums),
        seen_sr_(tracer.scene().luminaires.size(), 0.0) {}

  void add(std::size_t index_of_luminaire) {
    const PlacedLuminaire& luminaire = tracer_.scene().luminaires[index_of_luminaire];
    const glm::dvec3 to_source = luminaire.position_m - receiver_.position_m;
    if (is_behind(luminaire, receiver_)) return;
    const SeenAt seen(to_source, receiver_.axis);
    const std::vector<OpeningView::Point> ends = sight_ends(luminaire, receiver_);
    const double r2 = glm::dot(to_source, to_source);
    const glm::dvec3 out = to_source / -std::sqrt(r2);
    const double area_m2 = seen_opening_m2(luminaire, out);
    const double solid_angle_sr = area_m2 / r2;
    // Parts of a large one may shine into the eye though its centre does not, or be seen through a
    // gap between two lines.
    const bool is_large = solid_angle_sr > kLargestGlareSource_sr;
    const bool is_whole = seen.is_in_field();
    const Counted counted = counted_of(seen, is_large, ends, receiver_);
    if (counted.is_nothing()) return;
    const double cd = intensity_cd(luminaire, out);
    if (!(cd > 0.0) && !(is_large && shines_here(luminaire, ends))) return;
    const Sight proof = proved(index_of_luminaire);
    const SeenEnds sight = look_at(tracer_, luminaire, receiver_, proof, ends, counted, rays_);
    // No line of so many sees it, and still a gap between two may: a part of the upper end.
    const bool is_seen = sight.open > 0.0;
    const bool may_be_seen =
        proof != Sight::hidden && luminaire.opening.shape != OpeningShape::point;
    if (!is_large && !is_seen && !may_be_seen) return;
    if (!(sight.all > 0.0)) return;  // hidden, or a body turned away
    seen_sr_[index_of_luminaire] = std::min(1.0, sight.open / sight.all) * solid_angle_sr;
    const bool has_area = area_m2 > 0.0;
    if (!has_area && is_seen) note_doubt(luminaire, GlareProblem::no_area, 0.0);
    const double squares = cd * cd / ((has_area ? area_m2 : kSmallestGlareSource_m2) * r2);
    const bool has_index = is_whole && !counted.is_below;
    const double index = has_index ? guth_index(to_source, receiver_.axis).value() : 1.0;
    const double whole = squares / (index * index) * sight.part();
    GlareSum found = bounds(whole, sight.open / sight.all);
    if (!counted.sure.empty()) found.low = std::min(found.low, squares * sight.sure());
    found.low *= std::min(1.0, area_m2 / kSmallestGlareSource_m2);
    if (is_large) {
      return add_large(luminaire, ends, sight, solid_angle_sr, found);
    }
    if (counted.is_below && is_seen) {
      note_doubt(luminaire, GlareProblem::below_sight, 0.0);
      found.value = squares * sight.sure_open / static_cast<double>(sight.facing);
    }
    add(luminaire, found);
  }

  // After all luminaires.
  void add_joined(const JoinedOpening& joined) {
    double sum_sr = 0.0;
    for (const std::size_t l : joined.members) sum_sr += seen_sr_[l];
    if (!(sum_sr > kLargestGlareSource_sr)) return;
    for (const std::size_t l : joined.members) {
      const PlacedLuminaire& luminaire = tracer_.scene().luminaires[l];
      if (seen_sr_[l] > 0.0) note_doubt(luminaire, GlareProblem::too_large, sum_sr);
    }
  }

  std::uint64_t rays() const { return rays_; }

 private:
  Sight proved(std::size_t luminaire) const {
    if (!has_shadows_) return Sight::free;
    if (tracer_.scene().luminaires[luminaire].opening.shape == OpeningShape::point) {
      return Sight::unknown;
    }
    return opening_sight(tracer_, luminaire, receiver_, true);
  }

  // Whether anything of it in the field sends light to the eye.
  bool shines_here(const PlacedLuminaire& luminaire,
                   const std::vector<OpeningView::Point>& ends) const {
    return std::any_of(ends.begin(), ends.end(), [&](const OpeningView::Point& end) {
      const glm::dvec3 to_end = end.position_m - receiver_.position_m;
      return SeenAt(to_end, receiver_.axis).is_in_field() &&
             intensity_cd(luminaire, -glm::normalize(to_end)) > 0.0;
    });
  }

  // whole: of what would count if nothing hid it; share: of it, what is seen.
  static GlareSum bounds(double whole, double share) {
    GlareSum sum;
    sum.value = whole * share;
    sum.high = whole * std::min(1.0, share + doubt_of(share));
    sum.low = whole * std::max(0.0, share - doubt_of(share));
    return sum;
  }

  // The whole is larger than the formula is for; what of it is seen and lies in the field may not
  // be. Then each part counts as a source of its own, with its own luminance, distance and index.
  // found: as of a smaller source; it stands in the ends, so that nothing is proved by the way of
  // counting alone.
  void add_large(const PlacedLuminaire& luminaire, const std::vector<OpeningView::Point>& ends,
                 const SeenEnds& sight, double solid_angle_sr, const GlareSum& found) {
    const Counted parts = parts_in_field(ends, receiver_);
    const auto facing = static_cast<double>(sight.facing);
    double all = 0.0, open = 0.0, all_sr = 0.0, open_sr = 0.0, counted = 0.0, seen = 0.0;
    double sure = 0.0;  // of what is open
    std::vector<std::pair<double, double>>
        parts_given;  // share of the field, what it gives if seen
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (parts.weights[k] == 0.0 || sight.faces[k] == 0) continue;
      const glm::dvec3 to_end = ends[k].position_m - receiver_.position_m;
      const double r2 = glm::dot(to_end, to_end);
      const glm::dvec3 out = to_end / -std::sqrt(r2);
      const double area_m2 = seen_opening_m2(luminaire, out);
      const double is_seen = sight.is_seen[k];
      const double part_sr = area_m2 / (r2 * facing);
      const double cd = intensity_cd(luminaire, out);
      const double squares = area_m2 > 0.0 ? cd * cd / (area_m2 * r2 * facing) : 0.0;
      const double given = squares * parts.weights[k];
      parts_given.emplace_back(SeenAt(to_end, receiver_.axis).share_of_field(), given);
      all += given;
      open += given * is_seen;
      if (parts.sure[k] > 0.0) sure += given * is_seen;
      all_sr += part_sr;
      open_sr += part_sr * is_seen;
      counted += 1.0;
      seen += is_seen;
    }
    // The edge of the field and that of what hides the rest are each known to a row of lines.
    const double rows = (counted < facing ? 1.0 : 0.0) + (seen < counted ? 1.0 : 0.0);
    const double doubt = facing / static_cast<double>(kSightLines) * rows;
    const double near_sr = counted > 0.0 ? open_sr + doubt * all_sr / counted : 0.0;
    const double far_sr = std::min(1.0, (seen + doubt) / facing) * solid_angle_sr;
    const double size_sr = std::max(near_sr, far_sr);
    const bool is_seen_elsewhere = !(seen > 0.0) && sight.open > 0.0;
    const bool is_below = parts.is_below && seen > 0.0;
    if (is_below) note_doubt(luminaire, GlareProblem::below_sight, 0.0);
    if (is_seen_elsewhere || size_sr > kLargestGlareSource_sr) {
      note_doubt(luminaire, GlareProblem::too_large, seen > 0.0 ? size_sr : solid_angle_sr);
    }
    // Parts of one source differ. In doubt at the edge of the field are those next to it; what
    // hides others may hide those that give the most.
    const double row = facing / static_cast<double>(kSightLines);
    const double at_edge = counted < facing ? sum_of_last(parts_given, row) : 0.0;
    for (auto& [order, given] : parts_given) order = given;
    const double at_hiding = seen < counted ? sum_of_last(parts_given, row) : 0.0;
    const double doubt_of_sum = at_edge + at_hiding;
    GlareSum sum;
    sum.value = is_below ? sure : open;
    sum.low = std::min(std::max(0.0, sure - doubt_of_sum), found.low);
    sum.high = std::max(std::min(all + at_edge, open + doubt_of_sum), found.high);
    add(luminaire, sum);
  }

  // Of what so many parts give, the last by their first number.
  static double sum_of_last(std::vector<std::pair<double, double>> parts, double count) {
    std::sort(parts.begin(), parts.end(), std::greater<>());
    parts.resize(std::min(static_cast<std::size_t>(std::ceil(count)), parts.size()));
    double sum = 0.0;
    for (const auto& [order, given] : parts) sum += given;
    return sum;
  }

  void add(const PlacedLuminaire& luminaire, const GlareSum& source) {
    GlareSum& sum = sums_[luminaire.channel];
    sum.value += source.value;
    sum.low += source.low;
    sum.high += source.high;
  }

  void note_doubt(const PlacedLuminaire& luminaire, GlareProblem problem, double number) {
    std::vector<GlareDoubt>& doubts = sums_[luminaire.channel].doubts;
    const bool is_told = std::any_of(doubts.begin(), doubts.end(),
                                     [&](const GlareDoubt& d) { return d.problem == problem; });
    if (is_told) return;
    const glm::dvec3 world_m = luminaire.position_m + tracer_.scene().origin_m;
    doubts.push_back({0, luminaire.channel, problem, number, {world_m.x, world_m.y, world_m.z}});
  }

  const Tracer& tracer_;
  const Receiver& receiver_;
  bool has_shadows_;
  std::span<GlareSum> sums_;
  std::vector<double> seen_sr_;  // [luminaire]: of what counts, and is seen
  std::uint64_t rays_ = 0;
};

}  // namespace

bool is_behind(const PlacedLuminaire& luminaire, const Receiver& eye) {
  const double reach_m = 0.5 * glm::length(luminaire.opening.size_m());
  return glm::dot(luminaire.position_m - eye.position_m, eye.axis) < -reach_m;
}

std::uint64_t add_glare_sources(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
                                std::span<const JoinedOpening> joined,
                                std::span<GlareSum> channel_sums) {
  GlareEye eye(tracer, receiver, has_shadows, channel_sums);
  for (std::size_t l = 0; l < tracer.scene().luminaires.size(); ++l) eye.add(l);
  for (const JoinedOpening& one : joined) eye.add_joined(one);
  return eye.rays();
}

std::vector<JoinedOpening> joined_luminaires(const PreparedScene& scene) {
  std::vector<OpeningInPlace> openings;
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    openings.push_back({luminaire.position_m, luminaire.world_from_luminaire, luminaire.opening});
  }
  return joined_openings(openings);
}

}  // namespace calc
