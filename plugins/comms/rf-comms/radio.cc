#include "radio.hh"

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim {

namespace {

constexpr std::chrono::seconds kEpoch{1};

/// @return Watts.
double powerOf(double dBm) { return 1e-3 * math::exp(dBm / 10 * std::numbers::ln10); }

}  // namespace

double meanReceivedPower(const RadioSettings& settings, double distance) {
  if (settings.maxRange > 0 && distance > settings.maxRange) return -std::numeric_limits<double>::infinity();
  return settings.sendingPower -
         (settings.lossAtOneMetre + 10 * settings.fadingExponent * math::log(distance) / std::numbers::ln10);
}

double bitErrorRate(const RadioSettings& settings, double receivedPower) {
  return math::erfc(std::sqrt(powerOf(receivedPower) / powerOf(settings.noiseFloor)));
}

double lossProbability(double bitErrorRate, std::uint64_t bytes) {
  // avoids 0 times infinity if every bit is wrong
  if (bytes == 0) return bitErrorRate < 1 ? 0 : 1;
  return -math::expm1(static_cast<double>(bytes) * math::log1p(-bitErrorRate));
}

std::optional<double> RateWindow::add(Time now, std::uint64_t bytes, double capacity) {
  while (!packets_.empty() && packets_.front().time <= now - kEpoch) {
    bytes_ -= packets_.front().bytes;
    packets_.pop_front();
  }
  const double bits = static_cast<double>(bytes_ + bytes) * 8;
  if (bits > capacity * toSeconds(kEpoch)) return bits;
  packets_.push_back({now, bytes});
  bytes_ += bytes;
  return std::nullopt;
}

}  // namespace pongsim
