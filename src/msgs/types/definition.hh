#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::msgs {

/// @param comments A file with protobuf descriptors of all types including comments, made with `protoc
/// --include_source_info`. If it is missing or lacks the type, the definition has no comments.
/// @return The definition of the named message type in protobuf's language, with the types nested in it; nothing if
/// there is no such type.
std::optional<std::string> definition(std::string_view name, const std::filesystem::path& comments = {});

/// @return The .proto file that defines the message type: "ignition/msgs/twist.proto"; nothing if there is no such
/// type.
std::optional<std::string> definitionFile(std::string_view name);

}  // namespace pongsim::msgs
