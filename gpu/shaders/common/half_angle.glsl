// Sine and cosine of x / 2 for x in [0, pi], for calc/photometry/sine_segment.glsl: Taylor's series
// at x / 4, and the double angle.
SineCosine half_angle(double x) {
  const double a = DBL(0.25) * x;
  const double b = a * a;
  const double s =
      a * (DBL(1.0) +
           b * (DBL(-1.0) / DBL(6.0) +
                b * (DBL(1.0) / DBL(120.0) +
                     b * (DBL(-1.0) / DBL(5040.0) +
                          b * (DBL(1.0) / DBL(362880.0) +
                               b * (DBL(-1.0) / DBL(39916800.0) +
                                    b * (DBL(1.0) / DBL(6227020800.0) -
                                         b / DBL(1307674368000.0))))))));
  const double c =
      DBL(1.0) +
      b * (DBL(-0.5) +
           b * (DBL(1.0) / DBL(24.0) +
                b * (DBL(-1.0) / DBL(720.0) +
                     b * (DBL(1.0) / DBL(40320.0) +
                          b * (DBL(-1.0) / DBL(3628800.0) +
                               b * (DBL(1.0) / DBL(479001600.0) -
                                    b / DBL(87178291200.0)))))));
  SineCosine result;
  result.sine = DBL(2.0) * s * c;
  result.cosine = DBL(1.0) - DBL(2.0) * s * s;
  return result;
}
