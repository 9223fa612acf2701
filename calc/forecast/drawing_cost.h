#pragma once
// Compares hardware with software OpenGL, which is the CPU, for pictures of rooms and shadow maps.

namespace calc {

struct DeviceRates;
struct Prediction;
struct SpaceWorkload;

// The most rooms that software draws in a run, because nobody should wait only for pictures.
inline constexpr int kMostRoomsOnSoftware = 24;

// The drawing of any number of rooms. The CPU computes the light of pictures, whatever draws them.
struct DrawingWork {
  double rooms = 0;                          // with pictures
  double pixels = 0, triangles = 0;          // of their pictures
  double map_texels = 0, map_triangles = 0;  // of shadow maps, on all their faces
  double lookups = 0;                        // of points in maps

  // Adds the maps of instant radiosity in a space. texels: along a cube's edge.
  void add_shadow_maps(const Prediction& prediction, const SpaceWorkload& space, double texels);
};

struct DrawingCost {
  double software_s = 0;  // with opening it
  double open_s = 0;      // of hardware
  double hardware_s = 0;  // with opening it
};

// Returns both costs. rates: of the hardware, all known; only the transfer rates count, because no
// rate of drawing is measured. threads: of the machine.
DrawingCost weigh_drawing(const DrawingWork& work, const DeviceRates& rates, int threads);
// Returns the lower bound for any hardware.
DrawingCost weigh_ideal_drawing(const DrawingWork& work, int threads);

// Returns whether hardware draws, which is if it is faster, because the pictures are as good. It
// also draws more rooms than software would, whatever the time, because they would be missing.
bool is_hardware_to_draw(const DrawingWork& work, const DrawingCost& cost);

}  // namespace calc
