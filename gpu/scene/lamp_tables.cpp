#include "gpu/scene/lamp_tables.h"

#include "calc/base/units.h"
#include "calc/photometry/web.h"
#include "calc/photometry/web_sketch.h"
#include "gpu/scene/number_table.h"

#include <cassert>
#include <cstddef>
#include <map>

namespace gpu {
namespace {

double number(std::size_t count) { return static_cast<double>(count); }

struct WebPlace {
  std::size_t web_at, sketch_at;
};

// Of the webs of some luminaires, each once, in the order of first use.
class Webs {
 public:
  // first_at: where the first one will begin.
  explicit Webs(std::size_t first_at) : next_at_(first_at) {}

  WebPlace place_of(const calc::PhotometricWeb& web) {
    const auto [entry, is_new] =
        place_.try_emplace(&web, WebPlace{next_at_ + entries_.size(), sketches_.size()});
    if (is_new) add_web(web);
    return entry->second;
  }

  const std::vector<double>& entries() const { return entries_; }
  const std::vector<float>& sketches() const { return sketches_; }

 private:
  void add_web(const calc::PhotometricWeb& web) {
    entries_.insert(entries_.end(),
                    {number(web.c_rad().size()), number(web.gamma_rad().size()),
                     web.axis() == calc::TableAxis::lateral ? 1.0 : 0.0,
                     web.at_table_angles_cd(0.0, 0.0), web.at_table_angles_cd(0.0, calc::kPi)});
    add(entries_, web.c_rad());
    add(entries_, web.gamma_rad());
    for (std::size_t plane = 0; plane < web.c_rad().size(); ++plane) {
      for (std::size_t gamma = 0; gamma < web.gamma_rad().size(); ++gamma) {
        entries_.push_back(web.table_cd(plane, gamma));
      }
    }
    const calc::WebSketch::Table sketch = web.sketch().table();
    sketches_.insert(sketches_.end(), sketch.cd.begin(), sketch.cd.end());
  }

  std::size_t next_at_;
  std::map<const calc::PhotometricWeb*, WebPlace> place_;
  std::vector<double> entries_;
  std::vector<float> sketches_;
};

void add_lamp(std::vector<double>& table, const calc::PlacedLuminaire& lamp,
              const WebPlace& place) {
  const std::size_t begin = table.size();
  const calc::WebSketch::Table sketch = lamp.web->sketch().table();
  const calc::LightReach reach = lamp.reach.value_or(calc::LightReach{});
  add_placement(table, lamp);
  table.insert(table.end(),
               {static_cast<double>(lamp.channel), number(place.web_at), lamp.flux_scale,
                lamp.web->max_intensity_cd(), lamp.web->sketch().largest_error_share(),
                lamp.reach ? 1.0 : 0.0, reach.along.x, reach.along.y, reach.distance_m,
                number(place.sketch_at), number(sketch.planes), number(sketch.gammas),
                static_cast<double>(sketch.begin), static_cast<double>(sketch.end)});
  assert(table.size() - begin == kLampSize);
  static_cast<void>(begin);
}

}  // namespace

LampTables lamp_tables(const calc::Tracer& tracer) {
  const std::vector<calc::PlacedLuminaire>& luminaires = tracer.scene().luminaires;
  LampTables tables;
  tables.entries = {tracer.offset_m(), tracer.sight_margin_m(), tracer.sight_clear_m()};
  assert(tables.entries.size() == kLampsAt);
  Webs webs(kLampsAt + kLampSize * luminaires.size());
  for (const calc::PlacedLuminaire& lamp : luminaires) {
    add_lamp(tables.entries, lamp, webs.place_of(*lamp.web));
  }
  add(tables.entries, webs.entries());
  tables.sketches = webs.sketches();
  return tables;
}

}  // namespace gpu
