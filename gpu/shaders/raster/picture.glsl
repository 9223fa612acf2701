// Surfaces: a value for each corner. Cover: all in the picture's own coordinates already.

#if IS_VERTEX

#if IS_COVER
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
layout(location = 2) in vec4 rim;
layout(location = 3) in vec3 disc;  // place in a disc of radius 1, and its radius in pixels; 0 = none
out vec4 colour_, rim_;
out vec3 disc_;
void main() {
  gl_Position = vec4(place, 1.0);
  colour_ = colour;
  rim_ = rim;
  disc_ = disc;
}
#else
layout(location = 0) in vec3 position_m;
layout(location = 1) in float value;
uniform mat4 clip_from_local;
out float value_;
void main() {
  gl_Position = clip_from_local * vec4(position_m, 1.0);
  value_ = value;
}
#endif

#else

layout(location = 0) out float out_value;
layout(location = 1) out vec4 out_cover;
#if IS_COVER
uniform float opacity;
in vec4 colour_, rim_;
in vec3 disc_;
void main() {
  vec4 colour = colour_;
  if (disc_.z > 0.0) {
    const float r = length(disc_.xy);
    if (r > 1.0) discard;
    if (r * disc_.z > disc_.z - max(1.0, 0.22 * disc_.z)) colour = rim_;
  }
  colour.a *= opacity;
  out_value = 0.0;
  out_cover = vec4(colour.rgb * colour.a, colour.a);
}
#else
in float value_;
void main() {
  out_value = value_;
  out_cover = vec4(0.0);
}
#endif

#endif
