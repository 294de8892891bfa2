#include "log/mcap/definition.hh"

#include "pongsim/messages/message_schema.hh"

namespace pongsim::log {

Definition protobufDefinition(std::string_view type) {
  Definition definition{"", messageSchema(type), "protobuf"};
  if (!definition.schema.empty()) definition.schemaEncoding = "protobuf";
  return definition;
}

}  // namespace pongsim::log
