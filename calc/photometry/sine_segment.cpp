#include "calc/photometry/sine_segment.h"

#include "calc/base/elementary.h"
#include "calc/base/turns.h"

#include <algorithm>
#include <cmath>

#include "calc/base/shader_words.h"

namespace calc {
namespace {

using std::abs;
using std::clamp;
using std::max;
using std::min;
using std::sqrt;

SineCosine half_angle(double x_rad) { return {calc::sin(0.5 * x_rad), calc::cos(0.5 * x_rad)}; }

#include "calc/photometry/sine_segment.glsl"

SegmentShape shape_of(const SineSegment& segment) {
  return {segment.start_cd, (segment.end_cd - segment.start_cd) / segment.width_rad,
          calc::sin(segment.gamma_rad), calc::cos(segment.gamma_rad)};
}

}  // namespace

double integral_to(const SineSegment& segment, double x_rad) {
  return segment_at(shape_of(segment), x_rad).integral;
}

double integral(const SineSegment& segment) { return integral_to(segment, segment.width_rad); }

double invert_integral(const SineSegment& segment, double target) {
  return invert_segment(shape_of(segment), segment.width_rad, target);
}

double invert_linear_density(double start, double end, double u) {
  return share_of_linear_density(start, end, u);
}

}  // namespace calc

#include "calc/base/shader_words_end.h"
