#pragma once
// Compares two webs up to a scale and a quarter turn or mirror image: for a luminaire delivered in
// two files, whose C0 may not point the same way.

#include "calc/photometry/web.h"

#include <cstddef>
#include <string>
#include <vector>

namespace calc {

// The turn B(C) = A(C - quarters x 90 degrees), or mirrored B(C) = A(quarters x 90 degrees - C).
// Turns count counter-clockwise seen from above, as C does.
struct WebTurn {
  int quarters = 0;  // 0 to 3
  bool mirrored = false;
};
inline bool operator==(const WebTurn& a, const WebTurn& b) {
  return a.quarters == b.quarters && a.mirrored == b.mirrored;
}

// Differences of intensity per flux, over the higher of the two maxima of that. They are taken at
// the angles of the coarser table, and at the finer one's gamma angles beyond the coarser one's
// range; every angle where either web has 1 % of its maximum counts the same.
struct TurnFit {
  WebTurn turn;
  double rms = 0.0;
  double largest = 0.0;
};

// How the openings' sizes along C0 and C90, and two bodies' heights, match after a turn; equal
// means within 5 mm or 3 %.
enum class OpeningRelation {
  not_stated,   // one of them is a point
  agree,        // equal after the turn, and not without
  exchanged,    // equal only with the two axes of one opening exchanged after the turn
  indifferent,  // both have equal sides: a turn does not show
  differ,
};
OpeningRelation relate_openings(const LuminousOpening& a, const LuminousOpening& b, WebTurn turn);

inline constexpr double kIndistinguishable = 0.001;  // of rms

struct WebComparison {
  double flux_ratio = 1.0;    // B over A
  std::vector<TurnFit> fits;  // all eight
  // The number of fits at the front within kIndistinguishable of the smallest rms. Among them, fits
  // that agree with the openings come first, then turns before mirror images, then the smallest
  // turn; all others follow by rms.
  std::size_t alike = 1;
  OpeningRelation openings = OpeningRelation::not_stated;  // after fits.front().turn
};
WebComparison compare_webs(const PhotometricWeb& a, const PhotometricWeb& b);

// Returns "turned by 90 degrees about the vertical axis (C = C + 90)" or "not turned".
std::string turn_words(WebTurn turn);

}  // namespace calc
