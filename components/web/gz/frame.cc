#include "web/gz/frame.hh"

#include <google/protobuf/message.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <array>

namespace pongsim::web::gz {

std::optional<Call> readCall(std::string_view bytes) {
  std::array<std::string_view, 3> parts;
  for (std::string_view& part : parts) {
    const std::size_t comma = bytes.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    part = bytes.substr(0, comma);
    bytes.remove_prefix(comma + 1);
  }
  return Call{parts[0], parts[1], parts[2], bytes};
}

std::string head(std::string_view operation, std::string_view topic, std::string_view type) {
  std::string text;
  for (const std::string_view part : {operation, topic, type}) text.append(part).append(",");
  return text;
}

Frame frame(std::string_view operation, std::string_view topic, const Message& message) {
  return {head(operation, topic, message.GetTypeName()), Payload(message.SerializeAsString())};
}

Frame textFrame(std::string_view operation, std::string_view topic, std::string_view text) {
  ignition::msgs::StringMsg message;
  message.set_data(std::string(text));
  return frame(operation, topic, message);
}

}  // namespace pongsim::web::gz
