#include "web/gz/definitions.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <set>

#include "pongsim/message.hh"

namespace pongsim::web::gz {

std::string definitions() {
  constexpr const char* kPackage = "ignition.msgs";
  std::string text = "syntax = \"proto3\";\npackage " + std::string(kPackage) + ";\n";
  std::set<const google::protobuf::FileDescriptor*> files;
  for (const std::string& type : messageTypes()) {
    const MessagePointer message = newMessage(type);
    files.insert(message->GetDescriptor()->file());
  }
  for (const auto* file : files) {
    if (file->package() != kPackage) continue;
    for (int i = 0; i < file->enum_type_count(); ++i) text += file->enum_type(i)->DebugString();
    for (int i = 0; i < file->message_type_count(); ++i) text += file->message_type(i)->DebugString();
  }
  return text;
}

}  // namespace pongsim::web::gz
