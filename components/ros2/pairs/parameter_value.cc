#include "ros2/pairs/parameter_value.hh"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pongsim::ros2 {

using ignition::msgs::Any;
using Type = rcl_interfaces::ParameterType;

void convert(const Any& from, rcl_interfaces::ParameterValue& to) {
  to = {};
  switch (from.type()) {
    case Any::BOOLEAN:
      to.type = Type::kParameterBool;
      to.bool_value = from.bool_value();
      break;
    case Any::INT32:
      to.type = Type::kParameterInteger;
      to.integer_value = from.int_value();
      break;
    case Any::DOUBLE:
      to.type = Type::kParameterDouble;
      to.double_value = from.double_value();
      break;
    case Any::STRING:
      to.type = Type::kParameterString;
      to.string_value = from.string_value();
      break;
    default:
      break;
  }
}

void convert(const rcl_interfaces::ParameterValue& from, Any& to) {
  to.Clear();
  switch (from.type) {
    case Type::kParameterBool:
      to.set_type(Any::BOOLEAN);
      to.set_bool_value(from.bool_value);
      break;
    case Type::kParameterInteger: {
      using Limits = std::numeric_limits<std::int32_t>;
      to.set_type(Any::INT32);
      to.set_int_value(
          static_cast<std::int32_t>(std::clamp<std::int64_t>(from.integer_value, Limits::min(), Limits::max())));
      break;
    }
    case Type::kParameterDouble:
      to.set_type(Any::DOUBLE);
      to.set_double_value(from.double_value);
      break;
    case Type::kParameterString:
      to.set_type(Any::STRING);
      to.set_string_value(from.string_value);
      break;
    default:
      to.set_type(Any::NONE);
      break;
  }
}

}  // namespace pongsim::ros2
