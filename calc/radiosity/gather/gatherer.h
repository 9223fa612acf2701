#pragma once
// The batch seam between the calculation and whatever evaluates connections: CPU here, OpenGL in
// gpu/.

#include "calc/radiosity/paths/draws.h"
#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/radiosity/sampling/tiles.h"

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace calc {

// A tile of receivers with its connections, in order of receivers.
struct GatherBatch {
  const Tracer& tracer;
  std::span<const LightVertex> vertices;
  const VertexBounds& bounds;
  std::span<const Receiver> receivers;
  std::span<const Connection> connections;
  bool has_shadows = true;  // false: all receivers are proved to see all vertices
  // VertexTree::identity() of the vertices: a gatherer may keep what it made of them. 0 = none.
  std::uint64_t vertices_identity = 0;
  // Of gather_all(), see is_past(): the rest is then left undone, to be thrown away.
  double deadline_s = 0.0;
};

// Where the results go: [channel * stride + receiver].
struct GatherSums {
  double* lx;
  std::size_t stride;
  float* largest_lx;  // [receiver], raised to the largest single contribution
};

// Some tiles of a plane, whose receivers draw their connections from one pool.
struct DrawBatch {
  const Tracer& tracer;
  const VertexTree& tree;
  const VertexBounds& bounds;
  CutRequest cut;           // of every tile
  std::uint32_t draws = 0;  // of every receiver
  bool has_shadows = true;  // as in GatherBatch
  double deadline_s = 0.0;  // see is_past(); the rest is then left undone, to be thrown away
  // Of the plane's points: shift_of() keys their draws.
  RandomKey key;
  const ReceiverTiles& tiles;  // all of the plane; each shares one cut
  std::size_t first_tile = 0;
  std::span<const GatherSums> sums;  // of each tile from there on that is asked for

  const ReceiverGroup& group(std::size_t k) const { return tiles.groups()[first_tile + k]; }
  // In [0, 1), see draw_connections().
  double shift_of(std::uint32_t point) const { return key.with(point).uniform(); }
};

// Thrown by a Gatherer when the backend cannot go on: what the sums hold is then worthless.
class BackendFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What gather_all() did.
struct SharedGather {
  std::vector<std::uint32_t> pairs;     // [receiver], with a vertex that it faces
  double maps_s = 0.0, gather_s = 0.0;  // without waiting for the device
};

// What waits to be drawn, for Gatherer::tiles_per_batch().
struct TileWork {
  std::uint32_t draws = 0;     // of each receiver
  std::size_t nodes = 0;       // most of a tile's cut
  std::size_t receivers = 0;   // of a tile, on average
  std::size_t tiles_each = 0;  // for each thread, if all have the same
};

class Gatherer {
 public:
  virtual ~Gatherer() = default;

  // Adds to sums.lx, for every connection,
  //   weight * flux_v / pi * min(G, bound_v) * V,   G = k(w) cos_v / d^2 (see receiver.h),
  // always summed in the order of connections, so that the result is the same in bits for any
  // number of threads and any other receivers. May be called from several threads at once. Returns
  // the number of shadow rays traced. May throw BackendFailure.
  virtual std::uint64_t gather(const GatherBatch& batch, const GatherSums& sums) = 0;

  // The same sum over the connections that draw_connections() gives each receiver: the same draws
  // by every gatherer, but that cumulated probabilities are doubles, whose rounding (1e-16) is each
  // gatherer's own and moves a draw to a neighbouring vertex once in some 1e10.
  virtual std::uint64_t draw_and_gather(const DrawBatch& batch) = 0;
  // In one batch, to be worth its way: a hint, results do not depend on it.
  virtual std::size_t tiles_per_batch(const TileWork&) const { return 1; }

  // Whether instant radiosity is to hand over all points of a space at once, by gather_all(): what
  // is made for a vertex, a shadow map, then serves them all.
  virtual bool connects_all() const { return false; }

  // As gather(), for every receiver with every vertex, each with weight 1; batch.connections is
  // empty. Only if connects_all().
  virtual SharedGather gather_all(const GatherBatch&, const GatherSums&) {
    throw BackendFailure("this gatherer takes connections one by one");
  }

  // For reports: "cpu".
  virtual std::string description() const = 0;
};

// Shadow rays of the tracer, sixteen at a time.
std::unique_ptr<Gatherer> make_cpu_gatherer();

}  // namespace calc
