#include "gpu/rays/path_tables.h"

#include "calc/base/elementary.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/scene/number_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gpu {
namespace {

void add_luminaire(std::vector<double>& table, const calc::Emitter& emitter, std::size_t luminaire,
                   std::size_t web_at) {
  const calc::PlacedLuminaire& placed = emitter.scene().luminaires[luminaire];
  add_placement(table, placed);
  table.push_back(emitter.path_flux_lm(luminaire));
  table.push_back(static_cast<double>(placed.channel));
  table.push_back(static_cast<double>(web_at));
}

void add_web(std::vector<double>& table, const calc::WebSampler& sampler) {
  const calc::PhotometricWeb& web = sampler.web();
  table.push_back(static_cast<double>(web.c_rad().size()));
  table.push_back(static_cast<double>(web.gamma_rad().size()));
  table.push_back(web.axis() == calc::TableAxis::lateral ? 1.0 : 0.0);
  add(table, web.c_rad());
  add(table, sampler.c_prefix());
  add(table, web.gamma_rad());
  for (const double gamma : web.gamma_rad()) table.push_back(calc::sin(gamma));
  for (const double gamma : web.gamma_rad()) table.push_back(calc::cos(gamma));
  for (std::size_t plane = 0; plane < web.c_rad().size(); ++plane) {
    for (std::size_t gamma = 0; gamma < web.gamma_rad().size(); ++gamma) {
      table.push_back(web.table_cd(plane, gamma));
    }
  }
  add(table, sampler.gamma_prefix());
}

std::size_t size_of(const calc::WebSampler& sampler) {
  std::vector<double> table;
  add_web(table, sampler);
  return table.size();
}

}  // namespace

std::vector<double> path_tables(const calc::Emitter& emitter, double offset_m) {
  const std::size_t luminaires = emitter.scene().luminaires.size();
  std::vector<std::size_t> web_at;
  std::size_t at = 2 + luminaires + kLuminaireSize * luminaires;
  for (const calc::WebSampler& sampler : emitter.samplers()) {
    web_at.push_back(at);
    at += size_of(sampler);
  }
  std::vector<double> table{offset_m};
  table.reserve(at);
  add(table, emitter.cumulative());
  for (std::size_t l = 0; l < luminaires; ++l) {
    add_luminaire(table, emitter, l, web_at[emitter.sampler_of(l)]);
  }
  for (const calc::WebSampler& sampler : emitter.samplers()) add_web(table, sampler);
  return table;
}

}  // namespace gpu
