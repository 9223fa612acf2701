#pragma once
// Limits on texts in our XML files, for their reader and their schemas, because ids and texts are
// copied into everything that is made of an element.

#include <cstddef>

namespace calc {

inline constexpr std::size_t kLongestId = 200;     // bytes
inline constexpr std::size_t kLongestText = 4000;  // bytes; schemas count characters

}  // namespace calc
