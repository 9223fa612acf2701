#pragma once
// Computes the approximate light in many directions at once.

#include "calc/photometry/web.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace calc {

// A web as a table of even steps in C and gamma, in single precision, read in vectors: many times
// as fast as PhotometricWeb::intensity_cd(), the same bits on every processor, and within
// largest_error_share() of it (at a pole where the table has several values: one of them). It
// guides the calculation; no result may rest on it alone.
class WebSketch {
 public:
  explicit WebSketch(const PhotometricWeb& web);

  // Returns the error as a share of the largest intensity: 1e-5 where even steps meet all angles of
  // the web; else as found at those angles and between them.
  double largest_error_share() const { return largest_error_share_; }

  // Returns about half the width of the narrowest beam, rad; infinite where every beam is so wide
  // (11 degrees) that the calculation's sample places on an opening cannot miss it.
  double finest_rad() const { return finest_rad_; }

  // The light at table angles gamma in [from, to]: the highest intensity (none beyond the table),
  // and whether one of these angles is dark for all C, as far as the table's own angles tell.
  struct Band {
    double most_cd = 0.0;
    bool is_partly_dark = true;
  };
  Band band(double from_rad, double to_rad) const;

  // Computes lx[i] = factor[i] * intensity / distance^3, finite, for n directions from the
  // luminaire in the frame of the web's table (PhotometricWeb::to_table()), of lengths from 1e-9 to
  // 1e12 m.
  void light_of(std::size_t n, const float* x_m, const float* y_m, const float* z_m,
                const float* factor, float* lx) const;

  // The data of light_of(), to compute the same elsewhere: begin and end in steps of gamma, dark
  // outside; cd[plane * (gammas + 1) + gamma], planes + 1 of them.
  struct Table {
    std::size_t planes, gammas;  // steps
    float begin, end;
    std::span<const float> cd;
  };
  Table table() const;

 private:
  void fill(const PhotometricWeb& web);
  double measured_error_cd(const PhotometricWeb& web) const;

  std::size_t planes_ = 0, gammas_ = 0;  // steps, one less than entries
  double begin_rad_, end_rad_;           // the web's first and last gamma: dark outside
  double largest_error_share_ = 1e-5;
  double finest_rad_;
  std::vector<double> gamma_rad_, most_cd_;  // of the web: its angles, the most over C at each
  std::vector<float> cd_;                    // [plane][gamma]
};

class LazyWebSketch {
 public:
  const WebSketch& of(const PhotometricWeb& web) {
    std::call_once(once_, [&] { sketch_.emplace(web); });
    return *sketch_;
  }

 private:
  std::once_flag once_;
  std::optional<WebSketch> sketch_;
};

// Directions from luminaires to a receiver, and their light.
struct SketchLanes {
  std::vector<float> x_m, y_m, z_m, factor, lx;  // as light_of() takes them
  std::vector<const WebSketch*> sketch;

  void clear();
  void add(const WebSketch& its_sketch, const glm::dvec3& way_m, double its_factor);
};
void evaluate(SketchLanes& lanes);

}  // namespace calc
