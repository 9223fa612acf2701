#pragma once
// Elementary functions that give the same bits on every processor. Those of the C library come in
// several versions, with and without fused multiplications, which differ in the last bit; a test
// (tree.elementary_functions) keeps them out of calc, rules, report and gpu. sqrt, fabs, fmod,
// floor and the like are exact everywhere and stay std::. [SLEEF: the functions named cinz, which
// use no fused multiplication on any processor]
//
// Angles in radians. Special values as in the C library: atan2(0, -1) is pi, log(0) -infinity,
// acos(1.1) NaN.

#include <array>

namespace calc {

// Results are within 3.5 units of the last place; sines and cosines for |x| up to 1e9.
double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
// Returns two results with the same bits, in the time of one.
std::array<double, 2> atan2(const std::array<double, 2>& y, const std::array<double, 2>& x);
float cos(float x);
float acos(float x);

// Results are within 1 unit of the last place. pow of whole numbers and log10 of powers of ten are
// exact where the result is a double, up to 10^22.
double exp(double x);
double exp2(double x);
double log(double x);
double log1p(double x);
double log2(double x);
double log10(double x);
double pow(double base, double exponent);

double hypot(double x, double y);  // sqrt(x x + y y), no scaling: overflows from 1e154 on

}  // namespace calc
