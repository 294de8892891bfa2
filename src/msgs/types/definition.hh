#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::msgs {

/// @param comments A file with protobuf's descriptors of all types and the comments that stand beside them, as `protoc
/// --include_source_info` makes it. Where it is not there, or lacks the type, the definition has no comments.
/// @return The definition of the message type that `name` stands for, as protobuf's language has it and with the types
/// nested in it; nothing where there is no such type.
std::optional<std::string> definition(std::string_view name, const std::filesystem::path& comments = {});

/// @return The file of protobuf's language that defines the message type: "ignition/msgs/twist.proto"; nothing where
/// there is no such type.
std::optional<std::string> definitionFile(std::string_view name);

}  // namespace pongsim::msgs
