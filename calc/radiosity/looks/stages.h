#pragma once
// The implementations of the stages of the calculation.

#include "calc/radiosity/direct/direct_tracer.h"
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/paths/path_tracer.h"
#include "calc/radiosity/sampling/short_rays.h"

namespace calc {

// All of them must outlive the calculation.
struct Stages {
  // Usually only a gatherer is given.
  Stages(Gatherer& connections, PathTracer* paths = nullptr, ShortRayCaster* near = nullptr,
         DirectTracer* direct = nullptr)
      : gatherer(connections), path_tracer(paths), short_rays(near), direct_tracer(direct) {}

  Gatherer& gatherer;
  PathTracer* path_tracer;      // null: trace_light_paths()
  ShortRayCaster* short_rays;   // null: add_near_field() traces them itself
  DirectTracer* direct_tracer;  // null: add_point_sources(), add_openings()
};

}  // namespace calc
