#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Parameters of the radios and of propagation.
struct RadioSettings {
  /// Maximum range [m]; 0: no limit.
  double maxRange = 50;
  /// Exponent of the distance, 2 in free space.
  double fadingExponent = 2.5;
  /// Loss at 1 m [dB].
  double lossAtOneMetre = 40;
  /// Standard deviation of the received power [dB].
  double sigma = 10;
  /// Bits that a radio sends, or receives, per second.
  double capacity = 54e6;
  /// [dBm]
  double sendingPower = 27;
  double noiseFloor = -90;
};

/// @return Mean received power [dBm], by the log-distance path loss model (Rappaport, "Wireless Communications", 2nd
/// ed., 4.9.1): the loss at one metre plus 10 n log10(d). Minus infinity beyond the maximum range.
double meanReceivedPower(const RadioSettings& settings, double distance);

/// @param receivedPower [dBm]
/// @return Bit error rate of QPSK as computed by Fortress: erfc(sqrt(P / N)), which is 1 without power.
double bitErrorRate(const RadioSettings& settings, double receivedPower);

/// @return Probability that a packet is lost. As in Fortress, bytes count as bits: 1 - (1 - rate)^bytes.
double lossProbability(double bitErrorRate, std::uint64_t bytes);

/// The traffic in one direction of a radio within the last second.
class RateWindow {
 public:
  /// Adds a packet, unless the capacity would be exceeded.
  /// @return The bits within that second with the packet, if they exceed the capacity; else nothing.
  std::optional<double> add(Time now, std::uint64_t bytes, double capacity);

  void transfer(StateArchive& archive) {
    archive(packets_);
    archive(bytes_);
    std::uint64_t sum = 0;
    for (const Packet& packet : packets_) sum += packet.bytes;
    archive.check(bytes_ == sum);
  }

 private:
  struct Packet {
    Time time{0};
    std::uint64_t bytes = 0;

    void transfer(StateArchive& archive) {
      archive(time);
      archive(bytes);
    }
  };
  std::deque<Packet> packets_;
  std::uint64_t bytes_ = 0;
};

}  // namespace pongsim
