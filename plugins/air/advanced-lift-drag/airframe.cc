#include "airframe.hh"

#include <algorithm>
#include <cmath>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

constexpr double kSlowestFlight = 1e-9;
/// How sharply the models before and after the stall are blended [1/rad].
constexpr double kBlending = 15;

/// @return The part of the model after the stall, 0 to 1 (R. Beard and T. McLain, Small Unmanned Aircraft, 2012,
/// equation 4.10).
double stalledPart(double alpha, double stall) {
  const double above = math::exp(-kBlending * (alpha - stall));
  const double below = math::exp(kBlending * (alpha + stall));
  return (1 + above + below) / ((1 + above) * (1 + below));
}

/// @return Drag coefficient of a flat plate across the flow, fitted to Ostowari and Naik's data.
double plateDrag(double aspectRatio) {
  return 2 / (1 + math::exp(-0.224 - 0.115 * std::max(aspectRatio, 1 / aspectRatio)));
}

/// The flow in terms of the aircraft.
struct Attitude {
  double alpha = 0;
  double beta = 0;
};

SixCoefficients coefficientsAt(const Airframe& airframe, const Attitude& flow, const SixCoefficients& control) {
  const double stalled = stalledPart(flow.alpha, airframe.stallAngle);
  const auto [sine, cosine] = math::sinCos(flow.alpha);
  SixCoefficients sum;
  sum.add(flow.alpha, airframe.alpha);
  sum.add(flow.beta, airframe.beta);
  // as in Gazebo, only sideslip and control surfaces turn it in pitch
  sum.pitch = flow.beta * airframe.beta.pitch;
  sum.lift = (1 - stalled) * (airframe.lift0 + airframe.alpha.lift * flow.alpha) +
             stalled * 2 * std::copysign(sine * sine, flow.alpha) * cosine + flow.beta * airframe.beta.lift +
             control.lift;
  const double induced = sum.lift * sum.lift / (std::numbers::pi * airframe.aspectRatio * airframe.efficiency);
  sum.drag = (1 - stalled) * (airframe.drag0 + induced) +
             stalled * std::abs(plateDrag(airframe.aspectRatio) * (0.5 - 0.5 * math::cos(2 * flow.alpha)));
  SixCoefficients others = control;
  others.lift = 0;
  sum.add(1, others);
  return sum;
}

}  // namespace

void SixCoefficients::add(double factor, const SixCoefficients& other) {
  drag += factor * other.drag;
  side += factor * other.side;
  lift += factor * other.lift;
  roll += factor * other.roll;
  pitch += factor * other.pitch;
  yaw += factor * other.yaw;
}

Wrench airframeWrench(const Airframe& airframe, const Vector3& velocity, const Vector3& rates,
                      const SixCoefficients& control) {
  // axes of the aircraft: ahead, to the right, down
  const Vector3& ahead = airframe.forward;
  const Vector3 down = -airframe.upward;
  const Vector3 right = down.cross(ahead);
  const Vector3 inPlane = velocity - velocity.dot(right) * right;
  const double speed = inPlane.norm();
  if (!(speed > kSlowestFlight)) return {};
  const Vector3 flight = inPlane / speed;
  const Attitude flow{.alpha = math::atan2(flight.dot(down), flight.dot(ahead)),
                      .beta = math::atan2(velocity.dot(right), velocity.dot(ahead))};

  const double span = std::sqrt(airframe.area * airframe.aspectRatio);
  const double chord = airframe.chord > 0 ? airframe.chord : airframe.area / span;
  // of rates, multiplied by the dynamic pressure later: rate * length / (2 speed)
  SixCoefficients sum = coefficientsAt(airframe, flow, control);
  sum.add(rates.x() * span / (2 * speed), airframe.p);
  sum.add(-rates.y() * chord / (2 * speed), airframe.q);
  sum.add(-rates.z() * span / (2 * speed), airframe.r);

  const double pressure = airframe.density / 2 * speed * speed * airframe.area;
  const Vector3 lift = -flight.cross(right);
  return {.force = pressure * (sum.lift * lift - sum.drag * flight + sum.side * right),
          .torque = pressure * (span * sum.roll * ahead + chord * sum.pitch * right + span * sum.yaw * down)};
}

}  // namespace pongsim
