#pragma once
// turns.glsl as C++: sine and cosine of an angle given in turns, fast.

#include "calc/base/shader_words.h"

namespace calc {

#include "calc/base/turns.glsl"

}  // namespace calc

#include "calc/base/shader_words_end.h"
