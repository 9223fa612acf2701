#pragma once
// What a Tracer holds of Embree; for rays.cpp and rays_distance.cpp, the only files that know it.

#include "calc/radiosity/rays.h"

#include <embree3/rtcore.h>

namespace calc {

struct Tracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

}  // namespace calc
