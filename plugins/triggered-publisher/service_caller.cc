#include "service_caller.hh"

#include <exception>
#include <optional>
#include <utility>

#include "pongsim/parameters.hh"
#include "typed_name.hh"

namespace pongsim {

ServiceCall::ServiceCall(const Element& element)
    : name(requiredAttribute(element, "name")),
      request(newMessage(typeAttribute(element, "reqType"))),
      reply(newMessage(typeAttribute(element, "repType"))) {
  Element time = element;
  time.name = "service timeout";
  time.text = requiredAttribute(element, "timeout");
  const int milliseconds = time.as<int>();
  if (milliseconds <= 0) refuse(element, "the 'timeout' of a <service> must be above zero");
  timeout = std::chrono::milliseconds(milliseconds);
  if (const std::optional<MessageError> error = parseMessage(element.attributeOr("reqMsg", ""), *request)) {
    refuse(element,
           "the 'reqMsg' of this <service> is no " + element.attributeOr("reqType", "") + ": " + error->message,
           error->hint);
  }
}

ServiceCaller::ServiceCaller(std::vector<ServiceCall> calls, const Node& node, const Logger& log)
    : calls_(std::move(calls)), node_(node), log_(log), worker_([this](const std::stop_token& stop) { work(stop); }) {}

void ServiceCaller::call() {
  {
    const std::lock_guard lock(mutex_);
    ++waiting_;
  }
  changed_.notify_one();
}

void ServiceCaller::work(const std::stop_token& stop) {
  while (true) {
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return waiting_ > 0; })) return;
      --waiting_;
    }
    callAll(stop);
  }
}

void ServiceCaller::callAll(const std::stop_token& stop) {
  for (ServiceCall& call : calls_) {
    if (stop.stop_requested()) return;
    try {
      const CallResult result = node_.call(call.name, *call.request, *call.reply, call.timeout);
      if (!result) log_.warning(result.error);
    } catch (const std::exception& error) {
      log_.warning("service '" + call.name + "' can't be called: " + error.what());
    }
  }
}

}  // namespace pongsim
