#include "msgs/fields/number_check.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>

namespace pongsim::msgs {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Reflection;

// The sum of two of these is still less than the 292 years that fit in 64 bits of nanoseconds.
constexpr std::int64_t kMostSeconds = 4'000'000'000;

bool isTime(const Descriptor& type) {
  const std::string_view name = type.full_name();
  return name == "ignition.msgs.Time" || name == "ignition.msgs.Duration";
}

std::string shortest(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}

/// @param index Index in a list; negative: not a list.
std::string nameOf(const FieldDescriptor& field, int index) {
  return index < 0 ? field.name() : field.name() + "[" + std::to_string(index) + "]";
}

/// One value of a message: a field, or an element of a list.
class Value {
 public:
  Value(const Message& message, const FieldDescriptor& field, int index)
      : message_(message), reflection_(*message.GetReflection()), field_(field), index_(index) {}

  std::optional<std::string> fault(double largest) const {
    switch (field_.cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
      case FieldDescriptor::CPPTYPE_FLOAT: {
        const double number = real();
        if (std::abs(number) <= largest) return std::nullopt;
        return nameOf(field_, index_) + " is " + shortest(number);
      }
      case FieldDescriptor::CPPTYPE_INT64: {
        if (index_ >= 0 || field_.name() != "sec" || !isTime(*field_.containing_type())) return std::nullopt;
        const std::int64_t seconds = reflection_.GetInt64(message_, &field_);
        if (seconds >= -kMostSeconds && seconds <= kMostSeconds) return std::nullopt;
        return nameOf(field_, index_) + " is " + std::to_string(seconds) + " (more than " +
               std::to_string(kMostSeconds) + ")";
      }
      case FieldDescriptor::CPPTYPE_MESSAGE: {
        std::optional<std::string> found = unusableNumber(inner(), largest);
        if (found) found->insert(0, nameOf(field_, index_) + ".");
        return found;
      }
      default:
        return std::nullopt;
    }
  }

 private:
  double real() const {
    if (field_.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
      return index_ < 0 ? reflection_.GetDouble(message_, &field_)
                        : reflection_.GetRepeatedDouble(message_, &field_, index_);
    }
    return static_cast<double>(index_ < 0 ? reflection_.GetFloat(message_, &field_)
                                          : reflection_.GetRepeatedFloat(message_, &field_, index_));
  }
  const Message& inner() const {
    return index_ < 0 ? reflection_.GetMessage(message_, &field_)
                      : reflection_.GetRepeatedMessage(message_, &field_, index_);
  }

  const Message& message_;
  const Reflection& reflection_;
  const FieldDescriptor& field_;
  int index_;
};

}  // namespace

std::optional<std::string> unusableNumber(const Message& message, double largest) {
  const Descriptor& type = *message.GetDescriptor();
  const Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (field.is_repeated()) {
      const int size = reflection.FieldSize(message, &field);
      for (int k = 0; k < size; ++k) {
        if (std::optional<std::string> found = Value(message, field, k).fault(largest)) return found;
      }
      continue;
    }
    // following unset fields would never end if a type contains itself
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && !reflection.HasField(message, &field)) continue;
    if (std::optional<std::string> found = Value(message, field, -1).fault(largest)) return found;
  }
  return std::nullopt;
}

}  // namespace pongsim::msgs
