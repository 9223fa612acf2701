// Sine and cosine of an angle given in turns: one text for C++ (turns.h) and GLSL (gpu/).

struct SineCosine {
  double sine, cosine;
};

// Of 2 pi u, u in [0, 1): Taylor's series within 45 degrees of the middle of each quadrant.
// Absolute error below 1e-15.
TERM SineCosine sine_cosine_of_turns(double u) {
  const double quarters = DBL(4.0) * u;
  const int quadrant = int(quarters);
  const double a = (quarters - quadrant - DBL(0.5)) * DBL(1.57079632679489661923);
  const double b = a * a;
  const double s =
      a *
      (DBL(1.0) +
       b * (DBL(-1.0) / DBL(6.0) +
            b * (DBL(1.0) / DBL(120.0) +
                 b * (DBL(-1.0) / DBL(5040.0) +
                      b * (DBL(1.0) / DBL(362880.0) +
                           b * (DBL(-1.0) / DBL(39916800.0) +
                                b * (DBL(1.0) / DBL(6227020800.0) -
                                     b / DBL(1307674368000.0))))))));
  const double c =
      DBL(1.0) +
      b * (DBL(-1.0) / DBL(2.0) +
           b * (DBL(1.0) / DBL(24.0) +
                b * (DBL(-1.0) / DBL(720.0) +
                     b * (DBL(1.0) / DBL(40320.0) +
                          b * (DBL(-1.0) / DBL(3628800.0) +
                               b * (DBL(1.0) / DBL(479001600.0) +
                                    b * (DBL(-1.0) / DBL(87178291200.0) +
                                         b / DBL(20922789888000.0))))))));
  const double half_root = DBL(0.70710678118654752440);
  const double sine = half_root * (c + s);  // of 45 degrees + a
  const double cosine = half_root * (c - s);
  SineCosine result;
  switch (quadrant & 3) {
    case 0:
      result.sine = sine;
      result.cosine = cosine;
      break;
    case 1:
      result.sine = cosine;
      result.cosine = -sine;
      break;
    case 2:
      result.sine = -sine;
      result.cosine = -cosine;
      break;
    default:
      result.sine = -cosine;
      result.cosine = sine;
  }
  return result;
}
