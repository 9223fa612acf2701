#pragma once
// Who computes which part of the calculation.

#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/path_tracer.h"
#include "calc/radiosity/short_rays.h"

namespace calc {

// All of them must outlive the calculation.
struct Stages {
  // A gatherer alone is the usual case.
  Stages(Gatherer& connections, PathTracer* paths = nullptr, ShortRayCaster* near = nullptr)
      : gatherer(connections), path_tracer(paths), short_rays(near) {}

  Gatherer& gatherer;
  PathTracer* path_tracer;     // null: trace_light_paths()
  ShortRayCaster* short_rays;  // null: add_near_field() traces them itself
};

}  // namespace calc
