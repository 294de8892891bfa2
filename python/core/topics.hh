#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "core/life.hh"

namespace pongsim::python {

/// What hears a topic for Python, until it is closed or the simulation is.
class Ear final : public Life::Pending {
 public:
  /// @param type As `messageAs` takes it.
  static std::shared_ptr<Ear> open(const std::shared_ptr<Life>& life, const std::string& topic, py::object callback,
                                   py::object type, std::size_t length);
  /// Hears nothing any more.
  void close();
  void letGo() override;
  std::uint64_t received() const { return subscription_.received(); }
  std::uint64_t dropped() const { return subscription_.dropped(); }
  bool isOpen() const { return static_cast<bool>(subscription_); }
  const std::string& topic() const { return topic_; }

 private:
  void hear(Life& life, std::string_view type, std::span<const std::byte> bytes);

  std::string topic_;
  std::weak_ptr<Life> life_;
  std::shared_ptr<Kept> callback_;
  std::shared_ptr<Kept> type_;
  Subscription subscription_;
};

/// @return The full name of a message type, or where none is given that which the topic has in this simulation. Raises
/// ValueError where there is none, or several.
std::string typeFor(Life& life, const std::string& topic, const std::string& type);

/// Publishes a message, of the type that is asked for, that of its class, or that which the topic has.
void publish(Life& life, const std::string& topic, py::handle message, const std::string& type);

/// Asks a service and waits for the answer.
py::object request(const std::shared_ptr<Life>& life, const std::string& service, py::handle message,
                   const std::string& requestType, py::handle replyType, double timeout);

/// Adds what has to do with topics and services.
void bindTopics(py::module_& module);

}  // namespace pongsim::python
