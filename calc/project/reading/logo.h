#pragma once
// Pictures that stand in reports: small, whole, and with nothing in them that acts or that fetches.

#include "calc/scene/about_project.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace calc {

inline constexpr std::size_t kMostLogoBytes = std::size_t{1} << 20;
inline constexpr unsigned kMostLogoPixels = 4096;  // of a side of a PNG

// By the end of the file's name, small letters or capitals. False: neither .png nor .svg.
bool is_logo_name(std::string_view file, LogoFormat& format);

// "" or why a page does not take these bytes, a clause. A PNG is looked at from chunk to chunk, its
// pixels are not decoded. An SVG holds shapes, texts and colours alone.
std::string logo_problem(std::string_view bytes, LogoFormat format);

}  // namespace calc
