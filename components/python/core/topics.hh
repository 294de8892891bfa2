#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "core/life.hh"

namespace pongsim::python {

/// A subscription to a topic in Python, until it or the simulation is closed.
class PythonSubscription final : public Life::Pending {
 public:
  /// @param type See `messageAs`.
  static std::shared_ptr<PythonSubscription> open(const std::shared_ptr<Life>& life, const std::string& topic,
                                                  py::object callback, py::object type, std::size_t length);
  /// Ends the subscription.
  void close();
  void letGo() override;
  std::uint64_t received() const { return subscription_.received(); }
  std::uint64_t dropped() const { return subscription_.dropped(); }
  bool isOpen() const { return static_cast<bool>(subscription_); }
  const std::string& topic() const { return topic_; }

 private:
  void receive(Life& life, std::string_view type, std::span<const std::byte> bytes);

  std::string topic_;
  std::weak_ptr<Life> life_;
  std::shared_ptr<Kept> callback_;
  std::shared_ptr<Kept> type_;
  Subscription subscription_;
};

/// @return The full name of a message type, or if none is given, the topic's type in this simulation. Raises ValueError
/// if there is none, or more than one.
std::string typeFor(Life& life, const std::string& topic, const std::string& type);

/// Publishes a message of the requested type, else of its class's type, else of the topic's type.
void publish(Life& life, const std::string& topic, py::handle message, const std::string& type);

/// Raises what `publish` would raise, and publishes nothing.
void checkMessage(Life& life, const std::string& topic, py::handle message, const std::string& type);

/// Calls a service and waits for the reply.
py::object request(const std::shared_ptr<Life>& life, const std::string& service, py::handle message,
                   const std::string& requestType, py::handle replyType, double timeout);

/// Binds topics and services.
void bindTopics(py::module_& module);

}  // namespace pongsim::python
