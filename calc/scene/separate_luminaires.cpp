#include "calc/scene/separate_luminaires.h"

#include <utility>

namespace calc {

void separate_luminaires(PreparedScene& scene) {
  std::vector<LightChannel> channels;
  for (PlacedLuminaire& luminaire : scene.luminaires) {
    channels.push_back(scene.channels[luminaire.channel]);
    luminaire.channel = static_cast<std::uint32_t>(channels.size() - 1);
  }
  scene.channels = std::move(channels);
}

}  // namespace calc
