#pragma once
// turns.glsl as C++: sine and cosine of an angle given in turns, fast.

#include "calc/shader_words.h"

namespace calc {

#include "calc/turns.glsl"

}  // namespace calc

#include "calc/shader_words_end.h"
