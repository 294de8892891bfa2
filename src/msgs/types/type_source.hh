#pragma once

namespace google::protobuf {
class DescriptorDatabase;
class DescriptorPool;
class MessageFactory;
}  // namespace google::protobuf

namespace pongsim::msgs {

/// Where a program has its message types from.
struct TypeSource {
  const google::protobuf::DescriptorPool& pool;
  /// Of the same types: it can list their names.
  google::protobuf::DescriptorDatabase& database;
  google::protobuf::MessageFactory& factory;
};

/// @return This program's source: types that were compiled (`generated_types.cc`), or, where nothing but their fields
/// is asked for, types that a file describes (`DescribedTypes`), for those start quicker.
const TypeSource& typeSource();

}  // namespace pongsim::msgs
