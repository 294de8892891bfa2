#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pongsim/message.hh"

namespace google::protobuf {
class FieldDescriptor;
}

namespace pongsim::msgs {

/// Reads the fields of a message of a known type by their names, where its class may not be at hand. To ask for a field
/// that the type does not have, or that is of another kind, is a mistake of the program.
class FieldReader {
 public:
  /// @param message Must outlive this.
  explicit FieldReader(const Message& message) : message_(&message) {}

  /// @return Of a field of type double or float.
  double number(const char* field) const;
  /// @return Of a field of whole numbers of up to 32 bits, of int64 or of an enumeration.
  std::int64_t whole(const char* field) const;
  /// @return Of a repeated field of type double.
  std::vector<double> numbers(const char* field) const;
  /// @return Of a field of bytes.
  std::string bytes(const char* field) const;
  /// @return Of a message within it; of an empty one where that is not set.
  FieldReader inside(const char* field) const;

 private:
  const google::protobuf::FieldDescriptor* find(const char* field) const;

  const Message* message_;
};

}  // namespace pongsim::msgs
