#pragma once
// Interface between the calculation and the code that traces light paths: CPU here, OpenGL in gpu/.

#include "calc/radiosity/paths/light_paths.h"

namespace calc {

class PathTracer {
 public:
  virtual ~PathTracer() = default;

  // Traces like trace_light_paths(): the same vertices in the same order, up to rounding and to
  // paths that rounding sends another way. Always the same bits for any number of threads and any
  // other batches. May be called from several threads at once. May throw BackendFailure.
  virtual TracedPaths trace(const Tracer& tracer, const Emitter& emitter,
                            const PathBatch& batch) = 0;
};

}  // namespace calc
