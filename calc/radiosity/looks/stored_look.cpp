#include "calc/radiosity/looks/stored_look.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace calc {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

// What a look holds; the rest is left out of its bytes.
enum Part : std::uint32_t {
  kExact = 1u << 0,
  kOpenings = 1u << 1,    // samples on openings
  kReflection = 1u << 2,  // sums of reflected light
  kNearField = 1u << 3,   // clear distances
  kPaths = 1u << 4,       // light paths were traced
  kGlare = 1u << 5,
  kAllParts = (1u << 6) - 1
};

// Flags of a point.
constexpr std::uint8_t kMayBeSampled = 1, kHasHidden = 2, kHasSeen = 4;

struct Head {
  std::uint32_t parts = 0;
  std::uint32_t most_rounds = 0;
  std::uint64_t points = 0, channels = 0, replicates = 0;
  double emitted_lm = 0.0, untraced_lm = 0.0;
  std::uint64_t paths = 0, direct_rays = 0, connection_rays = 0, near_rays = 0, pool_rays = 0;
  std::uint64_t doubts = 0;
};
static_assert(std::is_trivially_copyable_v<Head> && sizeof(Head) == 96);

struct StoredDoubt {
  std::uint64_t point, channel, problem;
  double number;
  double luminaire_m[3];
};
static_assert(std::is_trivially_copyable_v<StoredDoubt> && sizeof(StoredDoubt) == 56);

class Writer {
 public:
  explicit Writer(std::size_t bytes) { bytes_.reserve(bytes); }
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void add_all(const std::vector<T>& list) {
    bytes_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

// Takes memory for what is there only.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void get(T& value) {
    get_bytes(&value, sizeof value);
  }
  template <class T>
  void get_all(std::vector<T>& list, std::size_t count) {
    if (!is_good_ || count > bytes_.size() / sizeof(T)) {
      is_good_ = false;
      return;
    }
    list.resize(count);
    get_bytes(list.data(), count * sizeof(T));
  }
  void refuse() { is_good_ = false; }
  bool is_good() const { return is_good_; }
  bool is_done() const { return is_good_ && bytes_.empty(); }

 private:
  void get_bytes(void* into, std::size_t count) {
    if (!is_good_ || count > bytes_.size()) {
      is_good_ = false;
      return;
    }
    if (count > 0) std::memcpy(into, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }

  std::string_view bytes_;
  bool is_good_ = true;
};

// A number that is none would pass for light. Sums may be negative: what samples on openings add to
// the light that is known of them.
template <class Number>
bool all_finite(const std::vector<Number>& list) {
  return std::all_of(list.begin(), list.end(), [](Number x) { return std::isfinite(x); });
}

template <class Number>
bool all_positive(const std::vector<Number>& list) {
  return std::all_of(list.begin(), list.end(), [](Number x) { return x > Number(0); });
}

std::uint32_t parts_of(const PlaneState& plane, bool is_exact, const LookLight& light) {
  const PlaneSums& sums = plane.sums();
  std::uint32_t parts = 0;
  if (is_exact) parts |= kExact;
  if (sums.most_rounds > 0) parts |= kOpenings;
  if (!sums.indirect_sum_lx.empty()) parts |= kReflection;
  if (!sums.clear_m.empty()) parts |= kNearField;
  if (light.has_paths) parts |= kPaths;
  if (!plane.field().glare.value.empty()) parts |= kGlare;
  return parts;
}

std::vector<std::uint8_t> point_flags(const PlaneSums& sums) {
  std::vector<std::uint8_t> flags(sums.rounds.size());
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (sums.may_be_sampled[i] != 0) flags[i] |= kMayBeSampled;
    if (sums.has_hidden_opening[i] != 0) flags[i] |= kHasHidden;
    if (sums.has_seen_opening[i] != 0) flags[i] |= kHasSeen;
  }
  return flags;
}

// Only the largest over the replicates is ever asked for.
std::vector<float> largest_of_replicates(const PlaneState& plane) {
  std::vector<float> largest(plane.points(), 0.0f);
  for (std::size_t k = 0; k < plane.sums().largest_sum_lx.size(); ++k) {
    float& at_point = largest[k % plane.points()];
    at_point = std::max(at_point, plane.sums().largest_sum_lx[k]);
  }
  return largest;
}

void add_glare(Writer& out, const GlareField& glare) {
  out.add_all(glare.value);
  out.add_all(glare.low);
  out.add_all(glare.high);
  for (const GlareDoubt& doubt : glare.doubts) {
    out.add(StoredDoubt{doubt.point,
                        doubt.channel,
                        static_cast<std::uint64_t>(doubt.problem),
                        doubt.number,
                        {doubt.luminaire_m[0], doubt.luminaire_m[1], doubt.luminaire_m[2]}});
  }
}

void get_glare(Reader& in, const PlaneState& plane, std::uint64_t doubts, GlareField& glare) {
  const std::size_t count = plane.channels() * plane.points();
  for (auto* list : {&glare.value, &glare.low, &glare.high}) {
    in.get_all(*list, count);
    if (!all_finite(*list)) in.refuse();
  }
  if (doubts > kGlareProblems * count) in.refuse();
  for (std::uint64_t k = 0; in.is_good() && k < doubts; ++k) {
    StoredDoubt stored{};
    in.get(stored);
    if (stored.point >= plane.points() || stored.channel >= plane.channels() ||
        stored.problem > static_cast<std::uint64_t>(GlareProblem::no_area)) {
      return in.refuse();
    }
    glare.doubts.push_back({stored.point,
                            stored.channel,
                            static_cast<GlareProblem>(stored.problem),
                            stored.number,
                            {stored.luminaire_m[0], stored.luminaire_m[1], stored.luminaire_m[2]}});
  }
}

void get_flags(Reader& in, std::size_t points, PlaneSums& sums) {
  std::vector<std::uint8_t> flags;
  in.get_all(flags, points);
  sums.may_be_sampled.resize(flags.size());
  sums.has_hidden_opening.resize(flags.size());
  sums.has_seen_opening.resize(flags.size());
  for (std::size_t i = 0; i < flags.size(); ++i) {
    sums.may_be_sampled[i] = (flags[i] & kMayBeSampled) != 0 ? 1 : 0;
    sums.has_hidden_opening[i] = (flags[i] & kHasHidden) != 0 ? 1 : 0;
    sums.has_seen_opening[i] = (flags[i] & kHasSeen) != 0 ? 1 : 0;
  }
}

void get_openings(Reader& in, const PlaneState& plane, PlaneSums& sums) {
  in.get_all(sums.rounds, plane.points());
  in.get_all(sums.largest_opening_lx, plane.points());
  in.get_all(sums.direct_sum_lx, plane.values());
  if (sums.most_rounds == 0 || !all_positive(sums.rounds) || !all_finite(sums.largest_opening_lx) ||
      !all_finite(sums.direct_sum_lx)) {
    in.refuse();
  }
}

void get_reflection(Reader& in, const PlaneState& plane, PlaneSums& sums) {
  std::vector<float> largest;
  in.get_all(sums.paths, plane.points());
  in.get_all(sums.indirect_sum_lx, plane.values());
  in.get_all(largest, plane.points());
  in.get_all(sums.possible_sample_lx, plane.points());
  in.get_all(sums.short_ray_factor, plane.points());
  if (!in.is_good() || !all_positive(sums.paths) || !all_finite(sums.indirect_sum_lx) ||
      !all_finite(largest) || !all_finite(sums.possible_sample_lx) ||
      !all_finite(sums.short_ray_factor)) {
    return in.refuse();
  }
  sums.largest_sum_lx.assign(plane.field().replicates * plane.points(), 0.0f);
  std::copy(largest.begin(), largest.end(), sums.largest_sum_lx.begin());
}

}  // namespace

std::size_t most_look_bytes(const PlaneState& plane) {
  const std::size_t replicates = plane.field().replicates, points = plane.points();
  const std::size_t of_point = 1 + sizeof(std::uint32_t) + sizeof(float) + sizeof(std::uint64_t) +
                               sizeof(float) + 3 * sizeof(double);
  const std::size_t of_value =
      sizeof(double) + 3 * sizeof(double) + kGlareProblems * sizeof(StoredDoubt);
  return sizeof(Head) + 2 * replicates * sizeof(double) + points * of_point +
         plane.channels() * points * of_value + 2 * plane.values() * sizeof(double);
}

std::string render_look(const PlaneState& plane, bool is_exact, const LookLight& light) {
  const PlaneField& field = plane.field();
  const PlaneSums& sums = plane.sums();
  Head head;
  head.parts = parts_of(plane, is_exact, light);
  head.most_rounds = sums.most_rounds;
  head.points = plane.points();
  head.channels = plane.channels();
  head.replicates = field.replicates;
  head.emitted_lm = light.emitted_lm;
  head.untraced_lm = light.untraced_lm;
  head.paths = field.counters.paths;
  head.direct_rays = field.counters.direct_rays;
  head.connection_rays = field.counters.connection_rays;
  head.near_rays = field.counters.near_rays;
  head.pool_rays = light.pool_rays;
  head.doubts = field.glare.doubts.size();
  Writer out(most_look_bytes(plane));
  out.add(head);
  if ((head.parts & kPaths) != 0) {
    out.add_all(light.absorbed_lm);
    out.add_all(light.escaped_lm);
  }
  out.add_all(field.direct_exact_lx);
  out.add_all(point_flags(sums));
  if ((head.parts & kOpenings) != 0) {
    out.add_all(sums.rounds);
    out.add_all(sums.largest_opening_lx);
    out.add_all(sums.direct_sum_lx);
  }
  if ((head.parts & kReflection) != 0) {
    out.add_all(sums.paths);
    out.add_all(sums.indirect_sum_lx);
    out.add_all(largest_of_replicates(plane));
    out.add_all(sums.possible_sample_lx);
    out.add_all(sums.short_ray_factor);
  }
  if ((head.parts & kNearField) != 0) out.add_all(sums.clear_m);
  if ((head.parts & kGlare) != 0) add_glare(out, field.glare);
  return out.take();
}

std::optional<StoredLook> parse_look(std::string_view bytes, const PlaneState& plane) {
  const std::size_t points = plane.points();
  Reader in(bytes);
  Head head;
  in.get(head);
  if (!in.is_good() || (head.parts & ~std::uint32_t{kAllParts}) != 0 || head.points != points ||
      head.channels != plane.channels() || head.replicates != plane.field().replicates ||
      !std::isfinite(head.emitted_lm) || !std::isfinite(head.untraced_lm)) {
    return std::nullopt;
  }
  StoredLook look;
  look.is_exact = (head.parts & kExact) != 0;
  look.light.emitted_lm = head.emitted_lm;
  look.light.untraced_lm = head.untraced_lm;
  look.light.has_paths = (head.parts & kPaths) != 0;
  look.light.pool_rays = head.pool_rays;
  look.counters.paths = head.paths;
  look.counters.direct_rays = head.direct_rays;
  look.counters.connection_rays = head.connection_rays;
  look.counters.near_rays = head.near_rays;
  if (look.light.has_paths) {
    in.get_all(look.light.absorbed_lm, plane.field().replicates);
    in.get_all(look.light.escaped_lm, plane.field().replicates);
    if (!all_finite(look.light.absorbed_lm) || !all_finite(look.light.escaped_lm)) in.refuse();
  }
  in.get_all(look.direct_exact_lx, plane.channels() * points);
  if (!all_finite(look.direct_exact_lx)) in.refuse();
  PlaneSums& sums = look.sums;
  sums.most_rounds = head.most_rounds;
  get_flags(in, points, sums);
  sums.rounds.assign(in.is_good() ? points : 0, 0);
  sums.largest_opening_lx.assign(sums.rounds.size(), 0.0f);
  sums.paths.assign(sums.rounds.size(), 0);
  sums.possible_sample_lx.assign(sums.rounds.size(), 0.0);
  if ((head.parts & kOpenings) != 0) get_openings(in, plane, sums);
  if ((head.parts & kReflection) != 0) get_reflection(in, plane, sums);
  if ((head.parts & kNearField) != 0) {
    in.get_all(sums.clear_m, points);
    if (!all_finite(sums.clear_m)) in.refuse();
  }
  if ((head.parts & kGlare) != 0) get_glare(in, plane, head.doubts, look.glare);
  if (!in.is_done()) return std::nullopt;
  sums.connection_rays.assign(plane.field().replicates, 0);
  sums.near_rays.assign(plane.field().replicates, 0);
  sums.connection_rays.front() = head.connection_rays;
  sums.near_rays.front() = head.near_rays;
  return look;
}

void restore(StoredLook look, PlaneState& plane) {
  PlaneField& field = plane.field();
  field.direct_exact_lx = std::move(look.direct_exact_lx);
  field.glare = std::move(look.glare);
  field.counters.paths = look.counters.paths;
  field.counters.direct_rays = look.counters.direct_rays;
  field.counters.connection_rays = look.counters.connection_rays;
  field.counters.near_rays = look.counters.near_rays;
  plane.sums() = std::move(look.sums);
}

}  // namespace calc
