#pragma once

#include <cstdint>

namespace pongsim {

/// `<propagation_model>`
struct SonarLinkSettings {
  /// Of the transmitter [W].
  double sourcePower = 2000;
  /// At the receiver [dB].
  double noiseLevel = 1;
  /// [bit/s/Hz]
  double spectralEfficiency = 7;
};

/// @param distance From the transmitter [m].
/// @return Signal-to-noise ratio by the sonar equation, for a source that radiates in all directions (Urick,
/// "Principles of Underwater Sound", 3rd ed., 2 and 4): 170.8 dB + 10 log10(P) - 20 log10(r) - NL [dB].
double signalToNoise(const SonarLinkSettings& settings, double distance);

/// @param bytes Size of a packet.
/// @return Probability that the packet is lost, as Gazebo computes it: 1 - (1 - e)^bytes, with the bit error rate e =
/// erfc(SNR / spectral efficiency) / 2 of BPSK, in which it uses decibels as they are.
double packetLoss(const SonarLinkSettings& settings, double distance, std::uint64_t bytes);

}  // namespace pongsim
