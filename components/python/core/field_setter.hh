#pragma once

#include <string>
#include <vector>

#include "pongsim/message.hh"

namespace google::protobuf {
class FieldDescriptor;
}

namespace pongsim::python {

/// Sets a number inside messages of a type: "linear.x".
class FieldSetter {
 public:
  /// Raises ValueError if the type has no such number, or it is in a list.
  FieldSetter(const std::string& type, const std::string& path);
  /// @param number Rounded for integer fields; a boolean is true from 0.5 on.
  void set(Message& message, double number) const;

 private:
  std::vector<const google::protobuf::FieldDescriptor*> way_;
};

}  // namespace pongsim::python
