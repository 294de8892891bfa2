#pragma once

namespace google::protobuf {
class DescriptorDatabase;
class DescriptorPool;
class MessageFactory;
}  // namespace google::protobuf

namespace pongsim::msgs {

/// Where a program gets its message types from.
struct TypeSource {
  const google::protobuf::DescriptorPool& pool;
  /// The same types: can list their names.
  google::protobuf::DescriptorDatabase& database;
  google::protobuf::MessageFactory& factory;
};

/// @return This program's source: compiled types (`generated_types.cc`), or, for programs that only need reflection,
/// types described in a file (`DescribedTypes`), which start faster.
const TypeSource& typeSource();

}  // namespace pongsim::msgs
