#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/node.hh"

namespace pongsim {

namespace transport {
class Interceptor;
}

/// Takes the messages of a topic on their way, as long as it exists: to drop, change, repeat or delay them, for faults
/// on purpose. Without one, topics cost nothing more. It takes what the transport's own publishers send, before anybody
/// receives it, and what comes from elsewhere, before the transport's subscriptions receive it within
/// `Transport::dispatch`; not what subscriptions at once receive from carriers.
class PONGSIM_API Interception {
 public:
  /// A message on its way. Valid during the call.
  struct Crossing {
    /// Full name.
    std::string_view type;
    /// In protobuf's binary form.
    std::span<const std::byte> bytes;
    /// Whether it comes from elsewhere, and whether a carrier has brought it.
    bool isIncoming = false;
    bool isCarried = false;
    /// Sends such bytes on. May be called several times or never.
    const std::function<void(std::span<const std::byte>)>& pass;
  };
  using Taken = std::function<void(const Crossing&)>;

  /// @param topic Relative names are in the node's namespace.
  /// @param taken Called with each message, by the thread that publishes or dispatches.
  /// @throws std::invalid_argument for an invalid name, or if the topic is already intercepted.
  Interception(const Node& node, std::string_view topic, Taken taken);
  ~Interception();
  Interception(const Interception&) = delete;
  Interception& operator=(const Interception&) = delete;

  /// Sends a message on later, as `Crossing::pass` does: to all receivers or, if it is incoming, with the next
  /// `Transport::dispatch` to the transport's subscriptions.
  void send(std::string_view type, std::span<const std::byte> bytes, bool isIncoming, bool isCarried);

 private:
  std::unique_ptr<transport::Interceptor> interceptor_;
};

}  // namespace pongsim
