#pragma once

#include <optional>
#include <string>

#include "pongsim/expect/expectation.hh"

namespace pongsim::sim {

/// A field's value: a number or a text; neither: the field is not there, such as beyond the end of a list.
struct FieldValue {
  std::optional<double> number;
  std::optional<std::string> text;
};

/// @param isAngle Whether the field is an angle [rad], of which full turns do not count in kNear and kRecorded.
/// @return How far the value is from meeting the criterion: 0 if it meets it; 1 for a wrong text; infinite without a
/// value. A strict bound is missed by its smallest distance.
double missOf(const Criterion& criterion, const FieldValue& value, Time time, bool isAngle);

/// @return "x = 4.93".
std::string wordsOf(const Criterion& criterion, const FieldValue& value, Time time);

/// @return "12.3 s".
std::string secondsText(Time time);

}  // namespace pongsim::sim
