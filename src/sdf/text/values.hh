#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "description/color.hh"
#include "description/limits.hh"
#include "pongsim/element.hh"
#include "pongsim/types.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Limit of the physics for positions [m] and joint angles [rad].
using description::kLargestPosition;

/// A pose as written in the file, not resolved yet.
struct PoseText {
  Pose value;
  /// Name of the frame that it is relative to; empty: the element's default.
  std::string relativeTo;
  SourcePosition position;
};

// Each function reads the first child with this name. The result is `fallback` if the child is missing, empty, or
// wrong, which adds an error. As in Fortress, a number ends at the first character that does not belong to it: "5m" is
// 5, with a warning.

/// A finite number.
double readNumber(const Element& parent, std::string_view child, double fallback, Context& context);

/// A finite positive number: a size, a mass.
double readPositive(const Element& parent, std::string_view child, double fallback, Context& context);

/// A finite number that is not negative.
double readNotNegative(const Element& parent, std::string_view child, double fallback, Context& context);

/// A number that may be infinite. Magnitudes of 1e16 and more mean infinity, as in the format's own defaults.
double readLimit(const Element& parent, std::string_view child, double fallback, Context& context);

/// An integer within bounds, decimal or as "0x1f".
long long readInteger(const Element& parent, std::string_view child, long long fallback, long long least,
                      long long most, Context& context);

/// A non-negative integer of 32 bits: a count, a mask.
std::uint32_t readUnsigned(const Element& parent, std::string_view child, std::uint32_t fallback, Context& context);

bool readFlag(const Element& parent, std::string_view child, bool fallback, Context& context);

/// Like `readFlag`, for an attribute of the element itself.
bool readFlagAttribute(const Element& element, std::string_view attribute, bool fallback, Context& context);

std::string readText(const Element& parent, std::string_view child, std::string_view fallback);

/// One of several words.
/// @return Its index among them.
std::size_t readWord(const Element& parent, std::string_view child, std::size_t fallback,
                     std::span<const std::string_view> words, Context& context);

/// Like `readWord`, for an attribute of the element itself.
std::size_t readWordAttribute(const Element& element, std::string_view attribute, std::size_t fallback,
                              std::span<const std::string_view> words, Context& context);

/// Red, green, blue and optionally alpha, not negative.
description::Color readColor(const Element& parent, std::string_view child, const description::Color& fallback,
                             Context& context);

/// An integer within bounds, from an attribute of the element itself.
long long readIntegerAttribute(const Element& element, std::string_view attribute, long long fallback, long long least,
                               long long most, Context& context);

/// A finite number, from an attribute of the element itself.
double readNumberAttribute(const Element& element, std::string_view attribute, double fallback, Context& context);

/// Two finite numbers.
Eigen::Vector2d readVector2(const Element& parent, std::string_view child, const Eigen::Vector2d& fallback,
                            Context& context);

/// Three finite numbers.
Vector3 readVector(const Element& parent, std::string_view child, const Vector3& fallback, Context& context);

/// `<pose>`: translation and rotation; the identity if there is none.
PoseText readPose(const Element& parent, Context& context);

/// Reads a given number of finite numbers.
/// @param expected What they are, for the error: "a pose: six finite numbers".
/// @return Nothing, with an error, if they are not.
std::optional<std::vector<double>> readNumbers(const Element& element, std::size_t count, std::string_view expected,
                                               Context& context);

/// "true", "1", "false", "0"; nothing for other texts.
std::optional<bool> parseFlag(std::string_view text);

/// @return The child's text; empty if there is none.
std::string_view childText(const Element& parent, std::string_view child);

}  // namespace pongsim::sdf
