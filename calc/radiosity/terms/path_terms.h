#pragma once
// Includes path_terms.glsl as C++.

#include "calc/base/turns.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "calc/base/shader_words.h"

namespace calc {
namespace path_terms {
using std::max;
using std::sqrt;

#include "calc/radiosity/terms/path_terms.glsl"
}  // namespace path_terms

using path_terms::cosine_direction;
using path_terms::nested_scramble;
using path_terms::nested_scramble_reversed;
using path_terms::reverse_bits;
using path_terms::roulette_number;
using path_terms::sphere_direction;

}  // namespace calc

#include "calc/base/shader_words_end.h"
