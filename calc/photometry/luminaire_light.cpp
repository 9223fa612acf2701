#include "calc/photometry/luminaire_light.h"

namespace calc {

double LuminaireLight::flux_lm() const {
  double flux_lm = 0.0;
  for (const EmitterLight& emitter : emitters) flux_lm += emitter.web.flux_lm();
  return flux_lm;
}

double LuminaireLight::power_w() const {
  double power_w = 0.0;
  for (const EmitterLight& emitter : emitters) {
    const double own_w = emitter.web.source().input_power_w;
    if (!(own_w > 0.0)) return 0.0;
    power_w += own_w;
  }
  return power_w;
}

}  // namespace calc
