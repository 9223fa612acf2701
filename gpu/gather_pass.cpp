#include "gpu/gather_pass.h"

#include "gpu/gl_error.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cfloat>
#include <iterator>

namespace gpu {
namespace {

static_assert(sizeof(GpuReceiver) == 48);
static_assert(sizeof(calc::Connection) == 12);
static_assert(sizeof(calc::LightVertex) == 32);

// After those of DeviceScene.
enum Binding : unsigned { kVertices = 2, kReceivers, kConnections, kResults };

// The replicates of a look are computed side by side.
constexpr std::size_t kMostPools = 128;
constexpr std::size_t kMostPoolBytes = std::size_t{1} << 30;

template <class T>
std::span<const std::byte> bytes_of(const T& items) {
  return std::as_bytes(std::span(items));
}

// Moves the entry with this identity to the front; false if there is none.
template <class List>
bool use_again(List& list, std::uint64_t identity) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const auto& entry) { return entry.identity == identity; });
  if (identity == 0 || found == list.end()) return false;
  list.splice(list.begin(), list, found);
  return true;
}

}  // namespace

GatherPass::GatherPass()
    : receivers_("calculation points"), connections_("connections"), results_("results") {}

void GatherPass::run(DeviceState& device, std::span<GatherJob* const> jobs) {
  try {
    upload(jobs);
    std::size_t connection = 0, receiver = 0;
    for (const GatherJob* job : jobs) {
      dispatch(device, *job, connection, receiver);
      connection += job->connections.size();
      receiver += job->receivers.size();
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    fetch(jobs);
    device.check("gathering light");
  } catch (const OutOfMemory&) {
    pools_.clear();  // what is kept for later may be what leaves no room
    throw;
  }
}

void GatherPass::upload(std::span<GatherJob* const> jobs) {
  std::size_t connections = 0, receivers = 0;
  for (const GatherJob* job : jobs) {
    connections += job->connections.size();
    receivers += job->receivers.size();
  }
  connections_.reserve(connections * sizeof(calc::Connection));
  receivers_.reserve(receivers * sizeof(GpuReceiver));
  results_.reserve(connections * sizeof(std::uint32_t));
  results_.fill(connections * sizeof(std::uint32_t), kNotDone);
  connections = receivers = 0;
  for (const GatherJob* job : jobs) {
    connections_.write(connections * sizeof(calc::Connection), bytes_of(job->connections));
    receivers_.write(receivers * sizeof(GpuReceiver), bytes_of(job->receivers));
    connections += job->connections.size();
    receivers += job->receivers.size();
  }
  connections_.bind(kConnections);
  receivers_.bind(kReceivers);
  results_.bind(kResults);
  check_gl("sending connections");
}

void GatherPass::dispatch(DeviceState& device, const GatherJob& job, std::size_t first_connection,
                          std::size_t first_receiver) {
  const bool has_shadows = job.has_shadows && !job.tracer->scene().triangle.empty();
  const GlProgram& shader = program(has_shadows);
  shader.use();
  if (has_shadows) {
    const DeviceScene& scene = device.scenes.of(*job.tracer);
    scene.bind();
    shader.set("node_count", scene.nodes);
    shader.set("offset_m", static_cast<float>(job.tracer->offset_m()));
  }
  pool_of(job).vertex.bind(kVertices);
  const auto count = static_cast<std::uint32_t>(job.connections.size());
  shader.set("first_connection", static_cast<std::uint32_t>(first_connection));
  shader.set("connection_count", count);
  shader.set("first_receiver", static_cast<std::uint32_t>(first_receiver));
  shader.set("bounded_from_per_m2", std::min(job.bounded_from_per_m2, FLT_MAX));
  glDispatchCompute((count + kGroupSize - 1) / kGroupSize, 1, 1);
  check_gl("tracing shadow rays");
}

void GatherPass::fetch(std::span<GatherJob* const> jobs) {
  std::size_t first = 0;
  for (const GatherJob* job : jobs) {
    results_.read(first * sizeof(std::uint32_t), std::as_writable_bytes(job->results));
    first += job->results.size();
  }
}

const GlProgram& GatherPass::program(bool has_shadows) {
  std::unique_ptr<GlProgram>& made = program_[has_shadows ? 1 : 0];
  if (!made) made = std::make_unique<GlProgram>("gather", gather_shader(has_shadows));
  return *made;
}

const GatherPass::Pool& GatherPass::pool_of(const GatherJob& job) {
  if (use_again(pools_, job.vertices_identity)) return pools_.front();
  std::size_t bytes = bytes_of(job.vertices).size();
  for (const Pool& pool : pools_) bytes += pool.vertex.bytes();
  while (!pools_.empty() && (pools_.size() >= kMostPools || bytes > kMostPoolBytes)) {
    bytes -= pools_.back().vertex.bytes();
    pools_.pop_back();
  }
  Pool pool{job.vertices_identity, GlBuffer("light vertices")};
  pool.vertex.reserve(bytes_of(job.vertices).size());
  pool.vertex.write(0, bytes_of(job.vertices));
  check_gl("sending light vertices");
  pools_.push_front(std::move(pool));
  return pools_.front();
}

}  // namespace gpu
