// The angle of a direction: one text for C++ (web_sketch.cpp), which reads it in vectors, and for
// GLSL (gpu/). What it may use: TERM, ABSOLUTE.

// atan2 to 1e-7 rad without a branch; 0 of (0, 0).  [AbramowitzStegun, 4.4.49]
TERM float turn_of(float y, float x) {
  const float pi = 3.14159265358979f;
  const float ay = ABSOLUTE(y), ax = ABSOLUTE(x);
  const float low = ay < ax ? ay : ax, high = ay < ax ? ax : ay;
  const float t = low / (high > 1e-30f ? high : 1e-30f);
  const float u = t * t;
  float p = 0.0028662257f;
  p = p * u - 0.0161657367f;
  p = p * u + 0.0429096138f;
  p = p * u - 0.0752896400f;
  p = p * u + 0.1065626393f;
  p = p * u - 0.1420889944f;
  p = p * u + 0.1999355085f;
  p = p * u - 0.3333314528f;
  p = p * u + 1.0f;
  float turn = p * t;
  turn = ay > ax ? 0.5f * pi - turn : turn;
  turn = x < 0.0f ? pi - turn : turn;
  return y < 0.0f ? -turn : turn;
}
