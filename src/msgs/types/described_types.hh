#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor_database.h>
#include <google/protobuf/dynamic_message.h>

#include <filesystem>
#include <string>

#include "msgs/types/type_source.hh"

namespace pongsim::msgs {

/// Message types that a file describes; each is read when it is first asked for. Their messages know their fields by
/// reflection only: there is no class to cast to.
class DescribedTypes {
 public:
  /// @param file What `protoc --include_imports --descriptor_set_out` writes.
  /// @throws std::runtime_error where that can't be read, or is something else.
  explicit DescribedTypes(const std::filesystem::path& file);
  // the database knows where the bytes are
  DescribedTypes(const DescribedTypes&) = delete;
  DescribedTypes& operator=(const DescribedTypes&) = delete;

  const TypeSource& source() const { return source_; }

 private:
  std::string bytes_;
  google::protobuf::EncodedDescriptorDatabase database_;
  google::protobuf::DescriptorPool pool_{&database_};
  google::protobuf::DynamicMessageFactory factory_{&pool_};
  TypeSource source_{pool_, database_, factory_};
};

}  // namespace pongsim::msgs
