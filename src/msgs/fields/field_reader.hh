#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pongsim/message.hh"

namespace google::protobuf {
class FieldDescriptor;
}

namespace pongsim::msgs {

/// Reads the fields of a message of a known type by name, for programs without the message's class. Asking for a field
/// that the type does not have, or that is of another kind, is a programming error.
class FieldReader {
 public:
  /// @param message Must outlive this.
  explicit FieldReader(const Message& message) : message_(&message) {}

  /// @return Value of a double or float field.
  double number(const char* field) const;
  /// @return Value of an integer field of up to 32 bits, of int64, or of an enumeration.
  std::int64_t whole(const char* field) const;
  /// @return Values of a repeated double field.
  std::vector<double> numbers(const char* field) const;
  /// @return Value of a bytes field.
  std::string bytes(const char* field) const;
  /// @return The nested message, or an empty one if it is not set.
  FieldReader inside(const char* field) const;

 private:
  const google::protobuf::FieldDescriptor* find(const char* field) const;

  const Message* message_;
};

}  // namespace pongsim::msgs
