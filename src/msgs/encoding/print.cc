#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <stdexcept>

#include "pongsim/message.hh"

namespace pongsim {

std::string messageText(const Message& message) { return message.DebugString(); }

std::string messageJson(const Message& message) {
  std::string text;
  const auto status = google::protobuf::util::MessageToJsonString(message, &text);
  if (!status.ok()) throw std::runtime_error("no JSON for this message: " + status.ToString());
  return text;
}

}  // namespace pongsim
