// SPDX-License-Identifier: Apache-2.0
#include "render/rest.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trihedron::render {
namespace {

constexpr double kTwoPi = 6.283185307179586, kDegree = kTwoPi / 360;
constexpr double kSupportMargin_mm = 3;  // of a centre of mass over what carries it
constexpr double kLift_mm = 1e-3;        // keeps bodies that touch from counting as overlapping
constexpr double kContact_mm = 0.01;     // a leaning body stops this near to the other
constexpr double kStep_mm = 2;           // of the push, below the smallest part of an object
constexpr double kTiltLow_rad = 8 * kDegree, kTiltHigh_rad = 35 * kDegree;
constexpr double kFall_rad = 0.5 * kDegree;

Eigen::Matrix3d about_z(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Body body_at(const Model& model, const Transform& world_from_model) {
  return make_body({&model, world_from_model, 1});
}

// A random one of the edges of the body's lowest face: two points, the body's inside to the left.
std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> support_edge(const Body& body,
                                                                        Random& random) {
  std::vector<Eigen::Vector2d> low;
  for (const Eigen::Vector3d& v : body.vertices)
    if (v.z() < 2 * kLift_mm) low.push_back(v.head<2>());
  const std::vector<Eigen::Vector2d> outline = convex_hull(low);
  if (outline.size() < 3) return std::nullopt;
  const std::size_t i = random.below(static_cast<int>(outline.size()));
  return std::make_pair(outline[i], outline[(i + 1) % outline.size()]);
}

double extent_along(const Body& body, const Eigen::Vector3d& direction, bool high) {
  double extent = direction.dot(body.vertices[0]);
  for (const Eigen::Vector3d& v : body.vertices)
    extent = high ? std::max(extent, direction.dot(v)) : std::min(extent, direction.dot(v));
  return extent;
}

Transform moved(const Transform& pose, const Eigen::Vector3d& by) { return {pose.R, pose.t + by}; }

// How far the body can be pushed along `direction` before it meets `other`; nothing when it
// passes by.
std::optional<double> push(const Model& model, const Transform& start,
                           const Eigen::Vector3d& direction, const Body& other, double length) {
  auto meets = [&](double s) {
    return interpenetrate(body_at(model, moved(start, s * direction)), other);
  };
  double free = 0, hit = kStep_mm;
  while (hit <= length && !meets(hit)) {
    free = hit;
    hit += kStep_mm;
  }
  if (hit > length) return std::nullopt;
  while (hit - free > kContact_mm) {
    const double middle = (free + hit) / 2;
    (meets(middle) ? hit : free) = middle;
  }
  return free;
}

}  // namespace

std::optional<Transform> rest_on_table(const Model& model, const StablePose& pose,
                                       const Field& field, Random& random) {
  const Eigen::Matrix3d R = about_z(random.uniform(0, kTwoPi)) * pose.R;
  const Eigen::Vector2d at{random.uniform(-1, 1) * field.half_size.x(),
                           random.uniform(-1, 1) * field.half_size.y()};
  Transform world_from_model{R, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d mass = R * centre_of_mass(model.mesh);
  world_from_model.t << field.centre + at - mass.head<2>(), -pose.lowest;
  return world_from_model;
}

std::optional<Transform> rest_on_top(const Model& model, const StablePose& pose, const Body& base,
                                     Random& random) {
  const double z = extent_along(base, Eigen::Vector3d::UnitZ(), true);
  std::vector<Eigen::Vector2d> top;
  for (const Eigen::Vector3d& v : base.vertices)
    if (v.z() > z - kLift_mm) top.push_back(v.head<2>());
  const std::vector<Eigen::Vector2d> outline = convex_hull(top);
  if (outline.size() < 3) return std::nullopt;
  Eigen::Vector2d low = outline[0], high = outline[0];
  for (const Eigen::Vector2d& p : outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector2d at{random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y())};
  if (depth_inside(outline, at) < kSupportMargin_mm) return std::nullopt;

  Transform place{about_z(random.uniform(0, kTwoPi)) * pose.R, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d mass = place.R * centre_of_mass(model.mesh);
  place.t << at - mass.head<2>(), z - pose.lowest;
  const auto contact = contact_outline(base, body_at(model, place), z);
  if (depth_inside(contact, at) < kSupportMargin_mm) return std::nullopt;
  place.t.z() += kLift_mm;
  return place;
}

std::optional<Transform> lean_against(const Model& model, const StablePose& pose, const Body& other,
                                      Random& random) {
  const Transform flat{about_z(random.uniform(0, kTwoPi)) * pose.R, {0, 0, -pose.lowest}};
  const auto edge = support_edge(body_at(model, flat), random);
  if (!edge) return std::nullopt;
  const Eigen::Vector2d along = (edge->second - edge->first).normalized();
  const Eigen::Vector3d axis(along.x(), along.y(), 0), forward(-along.y(), along.x(), 0);
  const Eigen::Vector3d pivot(edge->first.x(), edge->first.y(), 0);
  auto tilted = [&](double angle) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    return Transform{R, pivot - R * pivot} * flat;
  };
  const double tilt = random.uniform(kTiltLow_rad, kTiltHigh_rad);
  Transform start = tilted(tilt);
  Body body = body_at(model, start);
  const bool below_table = extent_along(body, Eigen::Vector3d::UnitZ(), false) < -kLift_mm;
  if (below_table || forward.dot(body.mass - pivot) < kSupportMargin_mm) return std::nullopt;

  // Well behind the other body, aimed at its middle or a little beside it.
  const double back = extent_along(other, forward, false) - extent_along(body, forward, true) - 1;
  const double side = axis.dot(other.mass - body.mass) + random.uniform(-20, 20);
  const Eigen::Vector3d offset = back * forward + side * axis;
  start = moved(start, offset);
  const double length = extent_along(other, forward, true) - extent_along(other, forward, false) +
                        extent_along(body, forward, true) - extent_along(body, forward, false);
  const auto distance = push(model, start, forward, other, length);
  if (!distance) return std::nullopt;
  const Eigen::Vector3d shift = offset + *distance * forward;
  if (!interpenetrate(body_at(model, moved(tilted(tilt - kFall_rad), shift)), other))
    return std::nullopt;  // nothing below it: it would fall back
  return moved(tilted(tilt), shift);
}

}  // namespace trihedron::render
