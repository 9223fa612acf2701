#include "gpu/rays/path_rounds.h"

#include "gpu/opengl/gl_error.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace gpu {

void PathInbox::put(PathRound round) {
  const std::scoped_lock lock(mutex_);
  rounds_.push_back(std::move(round));
  changed_.notify_one();
}

void PathInbox::end(const std::string& problem) {
  const std::scoped_lock lock(mutex_);
  problem_ = problem;
  has_ended_ = true;
  changed_.notify_one();
}

std::optional<PathRound> PathInbox::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return has_ended_ || !rounds_.empty(); });
  if (rounds_.empty()) return std::nullopt;
  std::optional<PathRound> round = std::move(rounds_.front());
  rounds_.pop_front();
  return round;
}

// All at once, with some to spare: what grows is copied, and fresh memory costs more than a copy.
// Those that live are taken to go on as all did so far.
void RoundCollector::make_room(std::size_t count, double share_alive) {
  if (vertices_.size() + count <= vertices_.capacity()) return;
  const double own = static_cast<double>(count) / std::max(0.5, 1.0 - share_alive);
  const double expected = (static_cast<double>(begin_) + own) / share_;
  vertices_.reserve(std::max(vertices_.size() + count, static_cast<std::size_t>(1.1 * expected)));
}

void RoundCollector::add(const PathRound& round) {
  const std::size_t count = round.vertices.bytes().size() / sizeof(calc::LightVertex);
  const bool is_first = chunk_vertices_.empty();
  if (is_first) make_room(count, round.share_alive);
  calc::LightVertices& to = is_first ? vertices_ : later_.emplace_back().vertices;
  (is_first ? chunk_vertices_ : later_.back().chunk_vertices) = round.chunk_vertices;
  to.reserve(to.size() + count);
  // A chunk at a time, which the nearest cache holds until it was looked at.
  const auto* from = reinterpret_cast<const calc::LightVertex*>(round.vertices.bytes().data());
  for (const std::uint32_t chunk : round.chunk_vertices) {
    to.insert(to.end(), from, from + chunk);
    for (std::size_t k = to.size() - chunk; k < to.size(); ++k) {
      if (std::bit_cast<std::uint32_t>(to[k].flux_lm) == ~0u) throw_not_done();
    }
    from += chunk;
  }
}

// From the end, so that the first round stays where it is but for the way up.
void RoundCollector::finish() {
  if (later_.empty()) return;
  std::size_t from = vertices_.size(), to = from;
  for (const LaterRound& round : later_) to += round.vertices.size();
  vertices_.resize(to);
  const auto at = [&](std::size_t k) { return vertices_.begin() + static_cast<std::ptrdiff_t>(k); };
  for (std::size_t c = chunk_vertices_.size(); c-- > 0;) {
    for (auto round = later_.rbegin(); round != later_.rend(); ++round) {
      const std::size_t count = round->chunk_vertices[c];
      to -= count;
      std::copy(round->vertices.end() - static_cast<std::ptrdiff_t>(count), round->vertices.end(),
                at(to));
      round->vertices.resize(round->vertices.size() - count);
    }
    const std::size_t count = chunk_vertices_[c];
    std::copy_backward(at(from - count), at(from), at(to));
    from -= count;
    to -= count;
  }
}

}  // namespace gpu
