#pragma once
// Sine and cosine of an angle given in turns, fast.

namespace calc {

struct SineCosine {
  double sine, cosine;
};

// Of 2 pi u, u in [0, 1): Taylor's series within 45 degrees of the middle of each quadrant.
// Absolute error below 1e-15.
inline SineCosine sine_cosine_of_turns(double u) {
  const double quarters = 4.0 * u;
  const int quadrant = static_cast<int>(quarters);
  const double a = (quarters - quadrant - 0.5) * 1.57079632679489661923;
  const double b = a * a;
  const double s =
      a * (1.0 + b * (-1.0 / 6 +
                      b * (1.0 / 120 + b * (-1.0 / 5040 + b * (1.0 / 362880 +
                                                               b * (-1.0 / 39916800 +
                                                                    b * (1.0 / 6227020800.0 -
                                                                         b / 1307674368000.0)))))));
  const double c =
      1.0 +
      b * (-1.0 / 2 +
           b * (1.0 / 24 +
                b * (-1.0 / 720 +
                     b * (1.0 / 40320 + b * (-1.0 / 3628800 + b * (1.0 / 479001600 +
                                                                   b * (-1.0 / 87178291200.0 +
                                                                        b / 20922789888000.0)))))));
  constexpr double kHalfRoot = 0.70710678118654752440;
  const double sine = kHalfRoot * (c + s);  // of 45 degrees + a
  const double cosine = kHalfRoot * (c - s);
  switch (quadrant & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace calc
