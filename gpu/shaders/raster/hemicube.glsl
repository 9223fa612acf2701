// The half of a cube that a light vertex sees: a whole face straight ahead and the upper halves of
// the four around it. Written to and read from with the same formulas.

// A frame about a unit normal, its third axis. [Duff17]
mat3 frame_about(vec3 n) {
  const float s = n.z >= 0.0 ? 1.0 : -1.0;
  const float a = -1.0 / (s + n.z);
  const float b = n.x * n.y * a;
  return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// (u, v, w) of a point in the frame for one of the five faces: it lies on the face if |u| <= w,
// |v| <= w, and w is its depth. v spans the half face.
vec3 on_face(uint face, vec3 p) {
  switch (face) {
    case 1u: return vec3(p.y, 2.0 * p.z - p.x, p.x);
    case 2u: return vec3(p.y, 2.0 * p.z + p.x, -p.x);
    case 3u: return vec3(p.x, 2.0 * p.z - p.y, p.y);
    case 4u: return vec3(p.x, 2.0 * p.z + p.y, -p.y);
  }
  return p;
}

// Towards (u, v) of a face, at depth 1: the inverse of on_face().
vec3 from_face(uint face, vec2 uv) {
  const float up = 0.5 * (uv.y + 1.0);
  switch (face) {
    case 1u: return vec3(1.0, uv.x, up);
    case 2u: return vec3(-1.0, uv.x, up);
    case 3u: return vec3(uv.x, 1.0, up);
    case 4u: return vec3(uv.x, -1.0, up);
  }
  return vec3(uv, 1.0);
}

uint face_of(vec3 p) {
  const vec3 size = abs(p);
  if (size.z >= max(size.x, size.y)) return 0u;
  if (size.x >= size.y) return p.x > 0.0 ? 1u : 2u;
  return p.y > 0.0 ? 3u : 4u;
}

// Where a face lies in the atlas, in texels: x, y, width, height. A map takes 3 N x N texels.
uvec4 face_texels(uint map, uint face, uint maps_per_row, uint n) {
  const uvec2 corner = uvec2(map % maps_per_row * 3u * n, map / maps_per_row * n);
  if (face == 0u) return uvec4(corner, n, n);
  const uint column = (face + 1u) / 2u, half_row = (face + 1u) % 2u;
  return uvec4(corner + uvec2(column * n, half_row * (n / 2u)), n, n / 2u);
}
