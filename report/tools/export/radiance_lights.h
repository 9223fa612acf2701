#pragma once
// Luminaires as Radiance sources: surfaces with the photometry's intensities, by brightdata and the
// functions of luxgate.cal, without ies2rad.

#include "calc/scene/prepared_scene.h"

#include <string>
#include <utility>
#include <vector>

namespace cli::radiance {

// Radiance counts in W/(sr m2); its programs turn them into light with 179 lm/W.
inline constexpr double kLumensPerWatt = 179.0;
// Radius of the spheres for luminaires without size.
inline constexpr double kPointRadius_m = 0.005;

// The text of luxgate.cal. Arguments: 1 a factor in W/(sr m2) per cd; 2 to 4, 5 to 7, 8 to 10 the
// directions of C0, C90 and gamma = 180 in the world; for bodies 11 to 13 the areas of their flat
// faces across those, m2; for prisms for cylinders 14 and 15: area of the side seen along the first
// and the second direction across the axis, m2, in the order x, y, z, x.
extern const char* const kFunctions;

// Number of faces around a cylinder. Radiance's own `cylinder` is not used: some of the rays it
// aims into the body meet an end before the side, and their light is lost (R / L of it at 45
// degrees, with radius R and length L).
inline constexpr int kPrismFaces = 16;

struct LightFiles {
  std::string scene;  // luminaires.rad
  struct Data {
    std::string name, text;  // "light-1.dat"
  };
  std::vector<Data> data;            // one per web, as brightdata wants it
  std::vector<std::string> changed;  // what is not exactly as luxgate has it, in words
};

// Returns a number in Radiance's form, without a minus before zero.
std::string number(double value);

// Writes every luminaire with its maintenance factor, in world coordinates. levels: factors on the
// light of dimming groups, in [0, 1]; groups not named are at 1. Luminaires at 0 are omitted and
// named in the scene's text.
LightFiles write_lights(const calc::PreparedScene& scene,
                        const std::vector<std::pair<std::string, double>>& levels);

// Writes a web for brightdata: C and gamma in degrees, gamma fastest, cd; 0 outside the table.
// Returns false without a change if the web cannot be written so (a lateral table whose beam falls
// between the angles; angles that are equal as float, which Radiance reads).
bool web_data(const calc::PhotometricWeb& web, std::string& text, bool& is_axial);

}  // namespace cli::radiance
