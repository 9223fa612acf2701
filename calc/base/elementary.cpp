#include "calc/base/elementary.h"

#include <emmintrin.h>
#include <sleef.h>

#include <cmath>

namespace calc {

double sin(double x) { return Sleef_cinz_sind1_u35purec(x); }
double cos(double x) { return Sleef_cinz_cosd1_u35purec(x); }
double tan(double x) { return Sleef_cinz_tand1_u35purec(x); }
double asin(double x) { return Sleef_cinz_asind1_u35purec(x); }
double acos(double x) { return Sleef_cinz_acosd1_u35purec(x); }
double atan(double x) { return Sleef_cinz_atand1_u35purec(x); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u35purec(y, x); }
std::array<double, 2> atan2(const std::array<double, 2>& y, const std::array<double, 2>& x) {
  std::array<double, 2> angle;
  _mm_storeu_pd(angle.data(),
                Sleef_cinz_atan2d2_u35sse2(_mm_loadu_pd(y.data()), _mm_loadu_pd(x.data())));
  return angle;
}
float cos(float x) { return Sleef_cinz_cosf1_u35purec(x); }
float acos(float x) { return Sleef_cinz_acosf1_u35purec(x); }

double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double exp2(double x) { return Sleef_cinz_exp2d1_u10purec(x); }
double log(double x) { return Sleef_cinz_logd1_u10purec(x); }
double log1p(double x) { return Sleef_cinz_log1pd1_u10purec(x); }
double log2(double x) { return Sleef_cinz_log2d1_u10purec(x); }
double log10(double x) { return Sleef_cinz_log10d1_u10purec(x); }
double pow(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }

double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace calc
