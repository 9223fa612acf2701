#pragma once
// What follows from a street and its planes: arrangement, which observer decides, and power and
// energy by EN 13201-5. Made once for all formats.
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

// Of the rows: all on one side; two, face to face or with the second one in the gaps of the first;
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
  // Of what this one decides; REI: at the edge beside this lane.
  struct Observer {
    bool of_average = false, of_uo = false, of_ul = false, of_ti = false;
    std::optional<calc::Estimate> edge_ratio;
    bool of_edge_ratio = false;
    // One before it that sees the same values, from the other end of the road.
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
  // Empty: power or an average is not known, areas overlap, or it is no finite number.
  std::optional<calc::Estimate> power_density_w_lx_m2;

  // Empty: power is not known, or it is no finite number.
  std::optional<double> power_w_km(const RoadPart& road) const;
  // In so many hours at full output; empty likewise.
  std::optional<double> energy_kwh_m2(double hours) const;
};

// On which side of the road a row stands: that which is nearer.
bool is_on_the_left(const RoadPart& road, const RoadRowPart& row);
// How far its luminaires reach over the edge on that side, and how far the side that looks to the
// street is lifted.
double overhang_m(const RoadPart& road, const RoadRowPart& row);
double street_tilt_deg(const RoadPart& road, const RoadRowPart& row);
// The same luminaires: from a shift to that of the first one behind 0, in [0, spacing). spacing_m:
// above 0.
double first_shift_m(double shift_m, double spacing_m);

// What `metric` is required to be on the carriageway, the strictest; null: nothing.
const rules::Requirement* road_requirement(const RoadFacts& facts, rules::Metric metric);

// Points into the space. Of no road: nothing.
RoadFacts road_facts(const SpacePart& space);

}  // namespace report
