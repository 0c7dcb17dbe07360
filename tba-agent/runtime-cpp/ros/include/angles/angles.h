#pragma once

#include <algorithm>
#include <cmath>

namespace angles {

constexpr double sitaf_pi = 3.14159265358979323846;

static inline double from_degrees(double degrees) {return degrees * sitaf_pi / 180;}
static inline double to_degrees(double radians) {return radians * 180 / sitaf_pi;}
/// An angle from 0 up to 2 pi.
static inline double normalize_angle_positive(double angle)
{
  const double rest = std::fmod(angle, 2 * sitaf_pi);
  return rest < 0 ? std::fmod(rest + 2 * sitaf_pi, 2 * sitaf_pi) : rest;
}
/// An angle above -pi, up to pi.
static inline double normalize_angle(double angle)
{
  const double rest = std::fmod(angle + sitaf_pi, 2 * sitaf_pi);
  return rest <= 0 ? rest + sitaf_pi : rest - sitaf_pi;
}
static inline double shortest_angular_distance(double from, double to) {return normalize_angle(to - from);}
/// The same angle from the other side: 2 pi away.
static inline double two_pi_complement(double angle)
{
  if (angle > 2 * sitaf_pi || angle < -2 * sitaf_pi) {
    angle = std::fmod(angle, 2 * sitaf_pi);
  }
  return angle < 0 ? 2 * sitaf_pi + angle : angle > 0 ? -2 * sitaf_pi + angle : 2 * sitaf_pi;
}
/// How far an angle is from the limits; false if it lies outside of them.
static inline bool find_min_max_delta(
  double from, double left_limit, double right_limit, double & result_min_delta, double & result_max_delta)
{
  double delta[4];
  delta[0] = shortest_angular_distance(from, left_limit);
  delta[1] = shortest_angular_distance(from, right_limit);
  delta[2] = two_pi_complement(delta[0]);
  delta[3] = two_pi_complement(delta[1]);
  if (delta[0] == 0) {
    result_min_delta = delta[0];
    result_max_delta = std::max(delta[1], delta[3]);
    return true;
  }
  if (delta[1] == 0) {
    result_max_delta = delta[1];
    result_min_delta = std::min(delta[0], delta[2]);
    return true;
  }
  double least = delta[0], second = delta[2];
  if (delta[2] < least) {
    std::swap(least, second);
  }
  double most = delta[1], other = delta[3];
  if (delta[3] > most) {
    std::swap(most, other);
  }
  if (least <= other || most >= second) {
    result_min_delta = most;
    result_max_delta = least;
    return left_limit == -sitaf_pi && right_limit == sitaf_pi;
  }
  result_min_delta = least;
  result_max_delta = most;
  return true;
}
/// The shortest way that stays within the limits; false if there is none.
static inline bool shortest_angular_distance_with_limits(
  double from, double to, double left_limit, double right_limit, double & shortest_angle)
{
  double least = -2 * sitaf_pi, most = 2 * sitaf_pi, to_least = -2 * sitaf_pi, to_most = 2 * sitaf_pi;
  const bool from_inside = find_min_max_delta(from, left_limit, right_limit, least, most);
  const double delta = shortest_angular_distance(from, to), around = two_pi_complement(delta);
  if (!from_inside) {
    if (find_min_max_delta(to, left_limit, right_limit, to_least, to_most)) {
      shortest_angle = std::max(std::min(delta, around), std::min(delta, most));
    } else {
      shortest_angle = delta;
    }
    return false;
  }
  if (delta >= least && delta <= most) {
    shortest_angle = delta;
    return true;
  }
  if (around >= least && around <= most) {
    shortest_angle = around;
    return true;
  }
  if (find_min_max_delta(to, left_limit, right_limit, to_least, to_most)) {
    shortest_angle = delta;
    return true;
  }
  shortest_angle = delta;
  return false;
}

}  // namespace angles
