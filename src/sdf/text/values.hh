#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "description/color.hh"
#include "pongsim/element.hh"
#include "pongsim/types.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// A pose as the file gives it, not resolved yet.
struct PoseText {
  Pose value;
  /// Name of the frame that it is measured in; empty: the default of the element.
  std::string relativeTo;
  SourcePosition position;
};

// Each reads the first child of that name. Where there is none, or it is empty, and where it is wrong, which is an
// error added, the result is `fallback`. As in Fortress a number ends where the next letter is none of it: "5m" is 5,
// and a warning.

/// A finite number.
double readNumber(const Element& parent, std::string_view child, double fallback, Context& context);

/// A finite number above zero: a size, a mass.
double readPositive(const Element& parent, std::string_view child, double fallback, Context& context);

/// A finite number, not negative.
double readNotNegative(const Element& parent, std::string_view child, double fallback, Context& context);

/// A number, perhaps infinite. Magnitudes from 1e16 on mean infinity, as in the format's own defaults.
double readLimit(const Element& parent, std::string_view child, double fallback, Context& context);

/// An integer within bounds, decimal or as "0x1f".
long long readInteger(const Element& parent, std::string_view child, long long fallback, long long least,
                      long long most, Context& context);

/// A whole number from zero up that 32 bits can hold: a count, a mask.
std::uint32_t readUnsigned(const Element& parent, std::string_view child, std::uint32_t fallback, Context& context);

bool readFlag(const Element& parent, std::string_view child, bool fallback, Context& context);

/// As `readFlag`, of an attribute of the element itself.
bool readFlagAttribute(const Element& element, std::string_view attribute, bool fallback, Context& context);

std::string readText(const Element& parent, std::string_view child, std::string_view fallback);

/// One of some words.
/// @return Its place among them.
std::size_t readWord(const Element& parent, std::string_view child, std::size_t fallback,
                     std::span<const std::string_view> words, Context& context);

/// As `readWord`, of an attribute of the element itself.
std::size_t readWordAttribute(const Element& element, std::string_view attribute, std::size_t fallback,
                              std::span<const std::string_view> words, Context& context);

/// Red, green, blue and perhaps alpha, from zero up.
description::Color readColor(const Element& parent, std::string_view child, const description::Color& fallback,
                             Context& context);

/// An integer within bounds, in an attribute of the element itself.
long long readIntegerAttribute(const Element& element, std::string_view attribute, long long fallback, long long least,
                               long long most, Context& context);

/// A finite number, in an attribute of the element itself.
double readNumberAttribute(const Element& element, std::string_view attribute, double fallback, Context& context);

/// Two finite numbers.
Eigen::Vector2d readVector2(const Element& parent, std::string_view child, const Eigen::Vector2d& fallback,
                            Context& context);

/// Three finite numbers.
Vector3 readVector(const Element& parent, std::string_view child, const Vector3& fallback, Context& context);

/// `<pose>`: translation and rotation, the identity where there is none.
PoseText readPose(const Element& parent, Context& context);

/// Reads that many finite numbers.
/// @param expected What they are, for the error: "a pose: six finite numbers".
/// @return Nothing, and an error added, where they are not.
std::optional<std::vector<double>> readNumbers(const Element& element, std::size_t count, std::string_view expected,
                                               Context& context);

/// "true", "1", "false", "0"; nothing for any other text.
std::optional<bool> parseFlag(std::string_view text);

/// @return The child's text, empty where there is none.
std::string_view childText(const Element& parent, std::string_view child);

}  // namespace pongsim::sdf
