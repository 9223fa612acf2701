#pragma once
// Facts derived from a street and its planes, made once for all formats: arrangement, the deciding
// observer, and power and energy by EN 13201-5.
//
//   power density indicator  PDI  = P / sum of E A      W / (lx m2)
//   annual energy            AECI = P t / sum of A      kWh / m2
//
// P: of the luminaires of one spacing, at full output. E, A: maintained average illuminance and
// size of each area over one spacing, at full output. [EN 13201-5]

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "report/document/document.h"
#include "rules/catalogue/finding.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace report {

// The arrangement of the rows: all on one side; two, face to face or staggered by half a spacing;
// anything else.
enum class RoadArrangement { right, left, opposite, staggered, other };

struct RoadFacts {
  struct Area {
    const RoadAreaPart* area = nullptr;
    const PlanePart* plane = nullptr;  // null: it was not chosen
    double m2 = 0;                     // over one spacing
    std::optional<calc::Estimate> average_lx;
    std::vector<calc::Message> classes;  // rows of rule packs that are asked of it, each once
  };
  // The values that this observer decides; REI: at the edge beside this lane.
  struct Observer {
    bool of_average = false, of_uo = false, of_ul = false, of_ti = false;
    std::optional<calc::Estimate> edge_ratio;
    bool of_edge_ratio = false;
    // An earlier observer with the same values, from the other end of the road.
    std::optional<std::size_t> same_as;

    bool decides() const { return of_average || of_uo || of_ul || of_ti || of_edge_ratio; }
  };

  RoadArrangement arrangement = RoadArrangement::other;
  int luminaires = 0;             // in one spacing: one of each row
  std::optional<double> power_w;  // of these; empty: of one it is not stated
  std::vector<Area> areas;        // as RoadPart::areas
  double m2 = 0;                  // of them together, what several share once
  bool do_areas_overlap = false;  // then what light falls on all of them is not known
  std::vector<Observer> observers;
  // Empty: power or an average is not known, areas overlap, or the result is not finite.
  std::optional<calc::Estimate> power_density_w_lx_m2;

  // Returns the power per kilometre; empty: power is not known, or the result is not finite.
  std::optional<double> power_w_km(const RoadPart& road) const;
  // Returns the energy for this many hours at full output; empty for the same reasons.
  std::optional<double> energy_kwh_m2(double hours) const;
};

// Returns whether the row is nearer to the left side of the road.
bool is_on_the_left(const RoadPart& road, const RoadRowPart& row);
// Return how far the luminaires reach over the edge on that side, and by which angle the side
// towards the street is lifted.
double overhang_m(const RoadPart& road, const RoadRowPart& row);
double street_tilt_deg(const RoadPart& road, const RoadRowPart& row);
// Returns the shift in [0, spacing) that describes the same luminaires. spacing_m: above 0.
double first_shift_m(double shift_m, double spacing_m);

// Returns the strictest requirement on `metric` for the carriageway; null: there is none.
const rules::Requirement* road_requirement(const RoadFacts& facts, rules::Metric metric);

// Returns the facts, which point into the space; nothing if it is not a road.
RoadFacts road_facts(const SpacePart& space);

}  // namespace report
