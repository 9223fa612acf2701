#pragma once
// Interface between the calculation and the code that evaluates connections in batches: CPU here,
// OpenGL in gpu/.

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
  // VertexTree::identity() of the vertices, for data that a gatherer keeps. 0 = none.
  std::uint64_t vertices_identity = 0;
  // Only for gather_all(), see is_past(): the rest is then left undone, to be discarded.
  double deadline_s = 0.0;
};

// The arrays for the results: [channel * stride + receiver].
struct GatherSums {
  double* lx;
  std::size_t stride;
  float* largest_lx;  // [receiver], raised to the largest single contribution
};

// Some tiles of a plane, whose receivers draw their connections from the same pool.
struct DrawBatch {
  const Tracer& tracer;
  const VertexTree& tree;
  const VertexBounds& bounds;
  CutRequest cut;           // of every tile
  std::uint32_t draws = 0;  // of every receiver
  bool has_shadows = true;  // as in GatherBatch
  double deadline_s = 0.0;  // see is_past(); the rest is then left undone, to be thrown away
  // Key of the plane's points: shift_of() keys their draws.
  RandomKey key;
  const ReceiverTiles& tiles;  // all of the plane; each shares one cut
  std::size_t first_tile = 0;
  std::span<const GatherSums> sums;  // of each tile from there on that is asked for

  const ReceiverGroup& group(std::size_t k) const { return tiles.groups()[first_tile + k]; }
  // Returns a shift in [0, 1), see draw_connections().
  double shift_of(std::uint32_t point) const { return key.with(point).uniform(); }
};

// Thrown by a Gatherer when the backend cannot go on: the sums are then useless.
class BackendFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The counts and times of gather_all().
struct SharedGather {
  std::vector<std::uint32_t> pairs;     // [receiver], with a vertex that it faces
  double maps_s = 0.0, gather_s = 0.0;  // without waiting for the device
};

// Work waiting to be drawn, for Gatherer::tiles_per_batch().
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
  // always in the order of connections, so that the result has the same bits for any number of
  // threads and any other receivers. May be called from several threads at once. Returns the number
  // of shadow rays traced. May throw BackendFailure.
  virtual std::uint64_t gather(const GatherBatch& batch, const GatherSums& sums) = 0;

  // Adds the same sum over the connections that draw_connections() gives each receiver. Every
  // gatherer makes the same draws, except that each rounds the cumulated probabilities, doubles, in
  // its own way (1e-16), which moves a draw to a neighbouring vertex once in some 1e10.
  virtual std::uint64_t draw_and_gather(const DrawBatch& batch) = 0;
  // Returns the tiles for an efficient batch: a hint, results do not depend on it.
  virtual std::size_t tiles_per_batch(const TileWork&) const { return 1; }

  // Returns whether instant radiosity should pass all points of a space at once to gather_all():
  // data for a vertex, a shadow map, then serves all points.
  virtual bool connects_all() const { return false; }

  // Does gather() for every receiver with every vertex, each with weight 1; batch.connections is
  // empty. Requires connects_all().
  virtual SharedGather gather_all(const GatherBatch&, const GatherSums&) {
    throw BackendFailure("this gatherer takes connections one by one");
  }

  // Returns a name for reports: "cpu".
  virtual std::string description() const = 0;
};

// Returns a gatherer with shadow rays of the tracer, sixteen at a time.
std::unique_ptr<Gatherer> make_cpu_gatherer();

}  // namespace calc
