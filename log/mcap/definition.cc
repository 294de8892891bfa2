#include "log/mcap/definition.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>

#include <set>

#include "pongsim/message.hh"

namespace pongsim::log {

namespace {

using google::protobuf::FileDescriptor;
using google::protobuf::FileDescriptorSet;

void addFile(const FileDescriptor& file, std::set<const FileDescriptor*>& added, FileDescriptorSet& set) {
  if (!added.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) addFile(*file.dependency(i), added, set);
  file.CopyTo(set.add_file());
}

}  // namespace

Definition protobufDefinition(std::string_view type) {
  Definition definition{"", "", "protobuf"};
  const MessagePointer message = newMessage(type);
  if (message == nullptr) return definition;
  FileDescriptorSet set;
  std::set<const FileDescriptor*> added;
  addFile(*message->GetDescriptor()->file(), added, set);
  definition.schemaEncoding = "protobuf";
  definition.schema = set.SerializeAsString();
  return definition;
}

}  // namespace pongsim::log
