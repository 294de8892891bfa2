#include "pongsim/messages/message_schema.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>

#include <set>

#include "pongsim/message.hh"

namespace pongsim {

namespace {

using google::protobuf::FileDescriptor;
using google::protobuf::FileDescriptorSet;

void addFile(const FileDescriptor& file, std::set<const FileDescriptor*>& added, FileDescriptorSet& set) {
  if (!added.insert(&file).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) addFile(*file.dependency(i), added, set);
  file.CopyTo(set.add_file());
}

}  // namespace

std::string messageSchema(const google::protobuf::Descriptor& type) {
  FileDescriptorSet set;
  std::set<const FileDescriptor*> added;
  addFile(*type.file(), added, set);
  return set.SerializeAsString();
}

std::string messageSchema(std::string_view name) {
  const MessagePointer message = newMessage(name);
  return message ? messageSchema(*message->GetDescriptor()) : std::string();
}

}  // namespace pongsim
