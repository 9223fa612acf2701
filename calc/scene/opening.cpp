#include "calc/scene/opening.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace calc {
namespace {

int cylinder_axis(OpeningShape shape) {
  if (shape == OpeningShape::cylinder_c0) return 0;
  return shape == OpeningShape::cylinder_c90 ? 1 : 2;
}

// Areas that each face of a body shows along a direction, in the luminaire's axes: {across x, y, z,
// side}.
std::array<double, 4> shown_m2(const LuminousOpening& opening, const glm::dvec3& half_m,
                               const glm::dvec3& direction) {
  const glm::dvec3 d = glm::abs(direction);
  const glm::dvec3 across_m2(half_m.y * half_m.z, half_m.z * half_m.x, half_m.x * half_m.y);
  switch (opening.shape) {
    case OpeningShape::box:
      return {4.0 * across_m2.x * d.x, 4.0 * across_m2.y * d.y, 4.0 * across_m2.z * d.z, 0.0};
    case OpeningShape::ellipsoid:
      return {0.0, 0.0, 0.0, kPi * glm::length(across_m2 * direction)};
    default: {
      const int axis = cylinder_axis(opening.shape);
      std::array<double, 4> shown{};
      shown[static_cast<std::size_t>(axis)] = kPi * across_m2[axis] * d[axis];
      glm::dvec3 aside = across_m2 * direction;
      aside[axis] = 0.0;
      // The outline of the side is a rectangle: the length by the section's width.
      shown[3] = 4.0 * glm::length(aside);
      return shown;
    }
  }
}

double outline_m2(const LuminousOpening& opening, const glm::dvec3& half_m,
                  const glm::dvec3& direction) {
  double sum = 0.0;
  for (const double shown : shown_m2(opening, half_m, direction)) sum += shown;
  return sum;
}

}  // namespace

glm::dvec2 unit_disk(double s, double t) {
  const double radius = std::sqrt(s);  // area-preserving
  return radius * glm::dvec2(calc::cos(2.0 * kPi * t), calc::sin(2.0 * kPi * t));
}

glm::dvec3 opening_point_m(const PlacedLuminaire& luminaire, double s, double t) {
  const LuminousOpening& opening = luminaire.opening;
  glm::dvec2 unit(0.0);  // in [-1/2, 1/2]^2
  if (opening.shape == OpeningShape::rectangle) unit = glm::dvec2(s - 0.5, t - 0.5);
  if (opening.shape == OpeningShape::disk) unit = 0.5 * unit_disk(s, t);
  if (unit == glm::dvec2(0.0)) return luminaire.position_m;
  return luminaire.position_m + unit.x * opening.along_c0_m * luminaire.world_from_luminaire[0] +
         unit.y * opening.along_c90_m * luminaire.world_from_luminaire[1];
}

bool is_inside_opening(const PlacedLuminaire& luminaire, const glm::dvec3& point_m,
                       double distance_m) {
  if (!luminaire.opening.is_body()) return false;
  const glm::dvec3 half_m = 0.5 * luminaire.opening.size_m() + distance_m;
  const glm::dvec3 p =
      glm::transpose(luminaire.world_from_luminaire) * (point_m - luminaire.position_m) / half_m;
  if (glm::any(glm::greaterThan(glm::abs(p), glm::dvec3(1.0)))) return false;
  switch (luminaire.opening.shape) {
    case OpeningShape::box:
      return true;
    case OpeningShape::ellipsoid:
      return glm::dot(p, p) <= 1.0;
    default: {
      glm::dvec3 across = p;
      across[cylinder_axis(luminaire.opening.shape)] = 0.0;
      return glm::dot(across, across) <= 1.0;
    }
  }
}

WebSketch::Band intensities_towards(const PlacedLuminaire& luminaire, const glm::dvec3& place_m,
                                    double radius_m, const glm::dvec3& point_m) {
  const glm::dvec3 way_m = glm::transpose(luminaire.world_from_luminaire) * (point_m - place_m);
  const double distance_m = glm::length(way_m);
  const PhotometricWeb& web = *luminaire.web;
  if (!(radius_m < distance_m)) return {luminaire.flux_scale * web.max_intensity_cd(), true};
  const glm::dvec3 way = way_m / distance_m;
  const double gamma_rad = angles_of(web.to_table({way.x, way.y, way.z})).gamma_rad;
  const double around_rad = calc::asin(radius_m / distance_m);
  WebSketch::Band band = web.sketch().band(gamma_rad - around_rad, gamma_rad + around_rad);
  band.most_cd *= luminaire.flux_scale;
  return band;
}

double seen_opening_m2(const PlacedLuminaire& luminaire, const glm::dvec3& towards) {
  const LuminousOpening& opening = luminaire.opening;
  const glm::dvec3 direction = glm::transpose(luminaire.world_from_luminaire) * towards;
  if (opening.is_body()) return outline_m2(opening, 0.5 * opening.size_m(), direction);
  const double fill = opening.shape == OpeningShape::disk ? 0.25 * kPi : 1.0;
  const glm::dvec3 size_m = opening.size_m();
  return fill * size_m.x * size_m.y * std::abs(direction.z);
}

OpeningView::OpeningView(const PlacedLuminaire& luminaire, const glm::dvec3& towards)
    : luminaire_(luminaire),
      is_flat_(!luminaire.opening.is_body()),
      towards_(towards),
      local_towards_(glm::transpose(luminaire.world_from_luminaire) * towards),
      half_m_(0.5 * luminaire.opening.size_m()) {
  if (is_flat_) return;
  // A body without thickness, seen edge-on, shows nothing and counts as a point.
  const std::array<double, 4> shown = shown_m2(luminaire.opening, half_m_, local_towards_);
  outline_m2_ = outline_m2(luminaire.opening, half_m_, local_towards_);
  if (!(outline_m2_ > 0.0)) return;
  pieces_ = 0;
  double sum_m2 = 0.0;
  for (int face = 0; face < 4; ++face) {
    const double area_m2 = shown[static_cast<std::size_t>(face)];
    if (!(area_m2 > 0.0)) continue;
    sum_m2 += area_m2;
    face_[pieces_] = face;
    end_[++pieces_] = std::min(1.0, sum_m2 / outline_m2_);
  }
  end_[pieces_] = 1.0;
}

OpeningView::LocalPoint OpeningView::box_point(std::size_t piece, double s, double t) const {
  const int axis = face_[piece];
  glm::dvec3 unit(0.0), normal(0.0);
  normal[axis] = local_towards_[axis] >= 0.0 ? 1.0 : -1.0;
  unit[axis] = normal[axis];
  unit[(axis + 1) % 3] = 2.0 * s - 1.0;
  unit[(axis + 2) % 3] = 2.0 * t - 1.0;
  return {half_m_ * unit, normal};
}

OpeningView::LocalPoint OpeningView::cylinder_point(std::size_t piece, double s, double t) const {
  const int axis = cylinder_axis(luminaire_.opening.shape);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  glm::dvec3 unit(0.0), normal(0.0);
  if (face_[piece] != kSide) {
    const glm::dvec2 disk = unit_disk(s, t);
    normal[axis] = local_towards_[axis] >= 0.0 ? 1.0 : -1.0;
    unit[axis] = normal[axis];
    unit[a] = disk.x;
    unit[b] = disk.y;
    return {half_m_ * unit, normal};
  }
  // On the unit circle that the section is an image of: evenly across the direction's outline.
  const double middle = calc::atan2(local_towards_[b] / half_m_[b], local_towards_[a] / half_m_[a]);
  const double angle = middle + calc::asin(std::clamp(2.0 * s - 1.0, -1.0, 1.0));
  unit[axis] = 2.0 * t - 1.0;
  unit[a] = calc::cos(angle);
  unit[b] = calc::sin(angle);
  normal[a] = unit[a] / half_m_[a];
  normal[b] = unit[b] / half_m_[b];
  return {half_m_ * unit, glm::normalize(normal)};
}

OpeningView::LocalPoint OpeningView::ellipsoid_point(double s, double t) const {
  // On the unit sphere that the ellipsoid is an image of; parallel projections keep even densities.
  const glm::dvec3 m = glm::normalize(local_towards_ / half_m_);
  const glm::dvec3 aside = std::abs(m.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(m, aside));
  const glm::dvec2 disk = unit_disk(s, t);
  const glm::dvec3 unit = disk.x * x + disk.y * glm::cross(m, x) +
                          std::sqrt(std::max(0.0, 1.0 - glm::dot(disk, disk))) * m;
  return {half_m_ * unit, glm::normalize(unit / half_m_)};
}

OpeningView::Point OpeningView::point(double s, double t) const {
  const glm::dmat3& axes = luminaire_.world_from_luminaire;
  if (is_flat_) {
    const double side = local_towards_.z > 0.0 ? 1.0 : -1.0;
    return {opening_point_m(luminaire_, s, t), side * axes[2]};
  }
  if (face_[0] == kNothing) return {luminaire_.position_m, towards_};
  std::size_t piece = 0;
  while (piece + 1 < pieces_ && s >= end_[piece + 1]) ++piece;
  const double within = (s - end_[piece]) / (end_[piece + 1] - end_[piece]);
  LocalPoint local;
  switch (luminaire_.opening.shape) {
    case OpeningShape::box:
      local = box_point(piece, within, t);
      break;
    case OpeningShape::ellipsoid:
      local = ellipsoid_point(within, t);
      break;
    default:
      local = cylinder_point(piece, within, t);
  }
  return {luminaire_.position_m + axes * local.position_m, axes * local.normal};
}

double OpeningView::weight(const Point& at, const glm::dvec3& direction) const {
  if (is_flat_ || face_[0] == kNothing) return 1.0;
  const double leaving = glm::dot(at.normal, direction);
  const double facing = glm::dot(at.normal, towards_);
  if (!(leaving > 0.0) || !(facing > 0.0)) return 0.0;
  const glm::dvec3 local = glm::transpose(luminaire_.world_from_luminaire) * direction;
  return outline_m2_ / outline_m2(luminaire_.opening, half_m_, local) * leaving / facing;
}

}  // namespace calc
