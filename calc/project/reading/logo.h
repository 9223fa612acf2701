#pragma once
// Checks pictures for reports: small, intact, and without scripts or references to other files.

#include "calc/scene/about_project.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace calc {

inline constexpr std::size_t kMostLogoBytes = std::size_t{1} << 20;
inline constexpr unsigned kMostLogoPixels = 4096;  // of a side of a PNG

// Returns whether the name ends in .png or .svg, in any case, and sets the format.
bool is_logo_name(std::string_view file, LogoFormat& format);

// Returns why a page does not accept these bytes, a clause; "" if it does. A PNG is checked by its
// chunks; its pixels are not decoded. An SVG may hold only shapes, texts and colours.
std::string logo_problem(std::string_view bytes, LogoFormat format);

}  // namespace calc
