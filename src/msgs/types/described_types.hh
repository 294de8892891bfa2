#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor_database.h>
#include <google/protobuf/dynamic_message.h>

#include <filesystem>
#include <string>

#include "msgs/types/type_source.hh"

namespace pongsim::msgs {

/// Message types described in a file, each read on first use. Their messages are accessible only by reflection: there
/// is no class to cast to.
class DescribedTypes {
 public:
  /// @param file Written by `protoc --include_imports --descriptor_set_out`.
  /// @throws std::runtime_error if it can't be read or is not such a file.
  explicit DescribedTypes(const std::filesystem::path& file);
  // the database points to the bytes
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
