#include "service_call.hh"

#include <optional>
#include <utility>

#include "pongsim/parameters.hh"
#include "typed_name.hh"

namespace pongsim {

BackgroundCalls::Call serviceCall(const Element& element) {
  BackgroundCalls::Call call;
  call.service = requiredAttribute(element, "name");
  MessagePointer request = newMessage(typeAttribute(element, "reqType"));
  call.replyType = typeAttribute(element, "repType");
  Element time = element;
  time.name = "service timeout";
  time.text = requiredAttribute(element, "timeout");
  const int milliseconds = time.as<int>();
  if (milliseconds <= 0) refuse(element, "the 'timeout' of a <service> must be above zero");
  call.timeout = std::chrono::milliseconds(milliseconds);
  if (const std::optional<MessageError> error = parseMessage(element.attributeOr("reqMsg", ""), *request)) {
    refuse(
        element,
        "the 'reqMsg' of this <service> is not of type " + element.attributeOr("reqType", "") + ": " + error->message,
        error->hint);
  }
  call.request = std::move(request);
  return call;
}

}  // namespace pongsim
