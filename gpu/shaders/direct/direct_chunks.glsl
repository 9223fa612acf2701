// Samples of openings of which nothing is proved, some at a time: chunks. list: for every point its
// first chunk, and one more; then four words for every chunk: point, luminaire, first sample of it
// over all rounds and cells, how many.

layout(std430, binding = 8) readonly buffer List { uint list[]; };
// [chunk][replicate]: sum (double), largest (float), flags and rays.
layout(std430, binding = 9) CHUNK_ACCESS buffer ChunkSums { uvec4 chunk_sum[]; };

uniform uint listed_points, replicate_count, first_round, last_round;

uvec4 chunk_at(uint chunk) {
  const uint at = listed_points + 1u + 4u * chunk;
  return uvec4(list[at], list[at + 1u], list[at + 2u], list[at + 3u]);
}
