// The file form of a light-vertex cache.

#include "calc/radiosity/looks/scene_fingerprint.h"
#include "calc/radiosity/looks/vertex_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace calc {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kStart =
    "ply\nformat binary_little_endian 1.0\ncomment luxgate light vertices 1\n";
constexpr std::string_view kAnyPly = "ply\n";
constexpr std::string_view kProperties =
    "property float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\n"
    "property float flux\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property uint bounce\nproperty uint path\nproperty uint luminaire\n"
    "property ushort light_group\nproperty uchar replicate\n"
    "property float local_x\nproperty float local_y\nproperty float local_z\n";
constexpr std::string_view kEnd = "end_header\n";
constexpr std::size_t kVertexBytes = 7 * 4 + 3 + 3 * 4 + 2 + 1 + 3 * 4;
constexpr std::size_t kLargestHeader = std::size_t{1} << 20;

using Colour = std::array<std::uint8_t, 3>;
Colour colour_of(std::uint32_t reflection) {  // light to dark, warm to cold
  constexpr std::array<Colour, 5> kColours{
      {{255, 236, 160}, {254, 178, 76}, {240, 96, 60}, {180, 50, 120}, {84, 39, 136}}};
  return kColours[std::min<std::size_t>(reflection, kColours.size() - 1)];
}

// A comment is one line: whatever a name holds, it cannot end it.
std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return line;
}

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T get(const char*& at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  at += sizeof value;
  return value;
}

// Numbers of paths are powers of two: dividing by their ratio loses nothing.
float share_of(const VertexCache& cache, const VertexCacheBatch& batch) {
  return static_cast<float>(static_cast<double>(batch.last - batch.first) /
                            static_cast<double>(cache.paths));
}

void put_vertex(std::string& bytes, const VertexCache& cache, const VertexCacheBatch& batch,
                std::size_t k) {
  const LightVertex& v = batch.vertices[k];
  const glm::vec3 scene_m(glm::dvec3(v.position_m) + cache.origin_m);
  for (int i = 0; i < 3; ++i) put(bytes, scene_m[i]);
  for (int i = 0; i < 3; ++i) put(bytes, v.normal[i]);
  put(bytes, v.flux_lm * share_of(cache, batch));
  for (const std::uint8_t c : colour_of(batch.origins[k].reflection)) put(bytes, c);
  put(bytes, batch.origins[k].reflection + 1);
  put(bytes, batch.origins[k].path);
  put(bytes, batch.luminaire[k]);
  put(bytes, static_cast<std::uint16_t>(v.channel));
  put(bytes, static_cast<std::uint8_t>(batch.replicate));
  for (int i = 0; i < 3; ++i) put(bytes, v.position_m[i]);
}

std::uint64_t checksum(std::string_view before, std::string_view after) {
  Fingerprint print;
  print.add(before);
  print.add(after);
  return print.bits();
}

// Reads a header line by line; after the first failure everything fails and `problem` stays.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : rest_(bytes) {}

  // The line's text behind `prefix`.
  std::string_view text(std::string_view prefix) {
    const std::size_t end = rest_.substr(0, kLargestHeader).find('\n');
    if (end == std::string_view::npos) return fail(prefix, "the end of the file");
    const std::string_view line = rest_.substr(0, end);
    if (!line.starts_with(prefix)) return fail(prefix, line);
    rest_.remove_prefix(end + 1);
    return line.substr(prefix.size());
  }

  void exactly(std::string_view lines) {
    while (problem_.empty() && !lines.empty()) {
      const std::size_t end = lines.find('\n');
      if (!text(lines.substr(0, end)).empty()) fail(lines.substr(0, end), "more");
      lines.remove_prefix(end + 1);
    }
  }

  // Numbers between single blanks, all of the line behind the prefix.
  template <class... Numbers>
  void numbers(std::string_view prefix, Numbers&... number) {
    const std::string_view all = text(prefix);
    std::string_view left = all;
    const bool good = (take(left, number) && ...) && left.empty();
    if (problem_.empty() && !good) fail(prefix, all);
  }

  std::uint64_t hexadecimal(std::string_view prefix) {
    const std::string_view digits = text(prefix);
    std::uint64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    // As it is written, and no other way: capitals would be another file of the same content.
    if (problem_.empty() && digits != fmt::format("{:016x}", value)) fail(prefix, digits);
    return value;
  }

  std::string_view rest() const { return rest_; }
  const std::string& problem() const { return problem_; }

 private:
  template <class T>
  static bool take(std::string_view& left, T& number) {
    const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), number);
    if (error != std::errc()) return false;
    left.remove_prefix(static_cast<std::size_t>(end - left.data()));
    if (left.starts_with(' ')) left.remove_prefix(1);
    return true;
  }

  std::string_view fail(std::string_view expected, std::string_view found) {
    if (problem_.empty()) {
      problem_ = fmt::format("its header must continue with '{}', found '{}'", expected,
                             one_line(found.substr(0, 60)));
    }
    return {};
  }

  std::string_view rest_;
  std::string problem_;
};

bool are_settings(const VertexCache& cache) {
  RadiositySettings settings;
  settings.replicates = std::max(4, cache.replicates);
  settings.first_paths = cache.first_paths;
  settings.max_paths = cache.paths;
  return cache.replicates >= 1 && validate(settings).empty() && cache.channels >= 1 &&
         cache.channels <= std::numeric_limits<std::uint16_t>::max();
}

// The batches' lines; their vertex counts go to `counts`.
std::string read_batches(HeaderReader& header, VertexCache& cache,
                         std::vector<std::uint64_t>& counts) {
  for (int r = 0; r < cache.replicates; ++r) {
    std::uint64_t first = 0;
    for (std::uint64_t last = cache.first_paths; last <= cache.paths; last *= 2) {
      VertexCacheBatch& batch = cache.batches.emplace_back();
      header.numbers("comment batch ", batch.replicate, batch.first, batch.last,
                     counts.emplace_back(), batch.absorbed_lm, batch.escaped_lm);
      if (!header.problem().empty()) return header.problem();
      if (batch.replicate != static_cast<std::uint64_t>(r) || batch.first != first ||
          batch.last != last || !(batch.absorbed_lm >= 0.0) || !std::isfinite(batch.absorbed_lm) ||
          !(batch.escaped_lm >= 0.0) || !std::isfinite(batch.escaped_lm)) {
        return fmt::format("its batch of paths {} to {} of replicate {} is not the expected one",
                           first, last, r);
      }
      first = last;
    }
  }
  return "";
}

std::string read_vertices(std::string_view bytes, const std::vector<std::uint64_t>& counts,
                          VertexCache& cache) {
  const char* at = bytes.data();
  for (std::size_t b = 0; b < counts.size(); ++b) {
    VertexCacheBatch& batch = cache.batches[b];
    const float scale = 1.0f / share_of(cache, batch);
    for (std::uint64_t k = 0; k < counts[b]; ++k) {
      LightVertex v{};
      at += 3 * sizeof(float);
      for (int i = 0; i < 3; ++i) v.normal[i] = get<float>(at);
      v.flux_lm = get<float>(at) * scale;
      at += 3;
      const auto bounce = get<std::uint32_t>(at);
      const auto path = get<std::uint32_t>(at);
      batch.luminaire.push_back(get<std::uint32_t>(at));
      v.channel = get<std::uint16_t>(at);
      const auto replicate = get<std::uint8_t>(at);
      for (int i = 0; i < 3; ++i) v.position_m[i] = get<float>(at);
      const bool is_sound = v.flux_lm > 0.0f && std::isfinite(v.flux_lm) && bounce >= 1 &&
                            path >= batch.first && path < batch.last &&
                            v.channel < cache.channels && replicate == batch.replicate &&
                            std::abs(glm::dot(v.normal, v.normal) - 1.0f) < 1e-3f &&
                            std::isfinite(v.position_m.x + v.position_m.y + v.position_m.z);
      if (!is_sound) {
        return fmt::format("vertex {} of replicate {} has values that a light vertex cannot have",
                           k, batch.replicate);
      }
      batch.vertices.push_back(v);
      batch.origins.push_back({path, bounce - 1});
    }
  }
  return "";
}

std::string read_ply(std::string_view bytes, VertexCache& cache) {
  if (!bytes.starts_with(kAnyPly)) return "it is not a PLY file";
  if (!bytes.starts_with(kStart)) {
    return "it is a PLY file, but it does not hold light vertices of this version of luxgate";
  }
  HeaderReader header(bytes.substr(kStart.size()));
  cache.made_by = header.text("comment made by ");
  cache.space_id = header.text("comment space ");
  cache.scene = header.hexadecimal("comment scene ");
  header.numbers("comment seed ", cache.seed);
  header.numbers("comment replicates ", cache.replicates);
  header.numbers("comment paths per replicate ", cache.paths);
  header.numbers("comment paths of the first look ", cache.first_paths);
  header.numbers("comment light groups ", cache.channels);
  header.numbers("comment origin ", cache.origin_m.x, cache.origin_m.y, cache.origin_m.z);
  if (!header.problem().empty()) return header.problem();
  if (!are_settings(cache))
    return "its numbers of paths, replicates or light groups are not allowed";
  std::vector<std::uint64_t> counts;
  std::string problem = read_batches(header, cache, counts);
  if (!problem.empty()) return problem;
  const std::string_view before =
      bytes.substr(0, static_cast<std::size_t>(header.rest().data() - bytes.data()));
  const std::uint64_t stated = header.hexadecimal("comment checksum ");
  const std::string_view after = header.rest();
  std::uint64_t vertices = 0;
  header.numbers("element vertex ", vertices);
  header.exactly(kProperties);
  header.exactly(kEnd);
  if (!header.problem().empty()) return header.problem();

  const std::size_t present = header.rest().size();
  if (vertices > kMostVertices * counts.size() || present != vertices * kVertexBytes) {
    return fmt::format(
        "it has {} bytes of vertices, where {} vertices take {:.0f}: it was cut off or "
        "changed",
        present, vertices, static_cast<double>(vertices) * kVertexBytes);
  }
  if (checksum(before, after) != stated) return "its checksum is wrong: the file was changed";
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts) {
    if (count > vertices) return "its batches have more vertices than the file";
    sum += count;
  }
  if (sum != vertices) {
    return fmt::format("its batches have {} vertices, the file has {}", sum, vertices);
  }
  return read_vertices(header.rest(), counts, cache);
}

}  // namespace

std::uint64_t vertex_ply_bytes(const VertexCache& cache) { return cache.vertices() * kVertexBytes; }

std::string render_vertex_ply(const VertexCache& cache) {
  std::string before(kStart);
  before += fmt::format(
      "comment made by {}\ncomment space {}\ncomment scene {:016x}\ncomment seed {}\n"
      "comment replicates {}\ncomment paths per replicate {}\n"
      "comment paths of the first look {}\ncomment light groups {}\n"
      "comment origin {:.17g} {:.17g} {:.17g}\n",
      one_line(cache.made_by), one_line(cache.space_id), cache.scene, cache.seed, cache.replicates,
      cache.paths, cache.first_paths, cache.channels, cache.origin_m.x, cache.origin_m.y,
      cache.origin_m.z);
  for (const VertexCacheBatch& batch : cache.batches) {
    before +=
        fmt::format("comment batch {} {} {} {} {:.17g} {:.17g}\n", batch.replicate, batch.first,
                    batch.last, batch.vertices.size(), batch.absorbed_lm, batch.escaped_lm);
  }
  std::string after = fmt::format("element vertex {}\n", cache.vertices());
  after += kProperties;
  after += kEnd;
  after.reserve(after.size() + vertex_ply_bytes(cache));
  for (const VertexCacheBatch& batch : cache.batches) {
    for (std::size_t k = 0; k < batch.vertices.size(); ++k) put_vertex(after, cache, batch, k);
  }
  return before + fmt::format("comment checksum {:016x}\n", checksum(before, after)) + after;
}

TracedCache parse_vertex_ply(std::string_view bytes) {
  VertexCache cache;
  std::string problem = read_ply(bytes, cache);
  if (!problem.empty()) return {std::nullopt, std::move(problem)};
  return {std::move(cache), ""};
}

}  // namespace calc
