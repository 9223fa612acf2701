// Of a request's ray: first_ray() of near_field.cpp.
dvec3 ray_direction(Request request, uint index) {
  const double u0 = sobol_sample(index, 0u, request.scramble.x);
  const double u1 = sobol_sample(index, 32u, request.scramble.y);
  return request.kernel == KERNEL_PLANAR ? cosine_direction(request.axis, u0, u1)
                                         : sphere_direction(u0, u1);
}

double ray_weight(Request request, uint index) {
  const double each = DBL(1.0) / double(request.rays);
  if (request.kernel == KERNEL_PLANAR) return each;
  const dvec3 direction = ray_direction(request, index);
  return each * (DBL(4.0) * response_times_distance(request.kernel, request.axis, direction));
}
