#pragma once

#include <string>
#include <string_view>

#include "pongsim/export.hh"

namespace google::protobuf {
class Descriptor;
}

namespace pongsim {

/// Describes a message type.
/// @param type Any type, not only pongsim's.
/// @return A google.protobuf.FileDescriptorSet in binary form: the type's file and its imports, each after its own
/// imports.
PONGSIM_API std::string messageSchema(const google::protobuf::Descriptor& type);

/// @return The same for the message type named `name`; empty if there is no such type.
PONGSIM_API std::string messageSchema(std::string_view name);

}  // namespace pongsim
