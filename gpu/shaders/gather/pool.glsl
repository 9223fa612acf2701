// A pool of light vertices, see device_pool.h.

layout(std430, binding = 2) readonly buffer VertexPositions { vec4 vertex_position[]; };  // w: flux
layout(std430, binding = 3) readonly buffer VertexNormals { vec4 vertex_normal[]; };
