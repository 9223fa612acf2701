#pragma once
// Includes turns.glsl as C++: fast sine and cosine of an angle given in turns.

#include "calc/base/shader_words.h"

namespace calc {

#include "calc/base/turns.glsl"

}  // namespace calc

#include "calc/base/shader_words_end.h"
