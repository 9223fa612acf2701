#pragma once
// Which OpenGL draws sooner, pictures of rooms and shadow maps: hardware, or software, which is the
// CPU.

namespace calc {

struct DeviceRates;
struct Prediction;
struct SpaceWorkload;

// Software draws no more rooms in a run: nobody should wait for pictures alone.
inline constexpr int kMostRoomsOnSoftware = 24;

// Of any number of rooms. The light of pictures is the CPU's, whatever draws them.
struct DrawingWork {
  double rooms = 0;                          // with pictures
  double pixels = 0, triangles = 0;          // of their pictures
  double map_texels = 0, map_triangles = 0;  // of shadow maps, on all their faces
  double lookups = 0;                        // of points in maps

  // The maps of instant radiosity in a space, texels along a cube's edge.
  void add_shadow_maps(const Prediction& prediction, const SpaceWorkload& space, double texels);
};

struct DrawingCost {
  double software_s = 0;  // with opening it
  double open_s = 0;      // of hardware
  double hardware_s = 0;  // with opening it
};

// rates: of the hardware, all known; of these only the way to it counts, because no rate of drawing
// is measured. threads: of the machine.
DrawingCost weigh_drawing(const DrawingWork& work, const DeviceRates& rates, int threads);
// The least that any hardware could take.
DrawingCost weigh_ideal_drawing(const DrawingWork& work, int threads);

// Either is as good, so the sooner one. More rooms than software draws are for hardware, whatever
// it takes: they would be missing.
bool is_hardware_to_draw(const DrawingWork& work, const DrawingCost& cost);

}  // namespace calc
