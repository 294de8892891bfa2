#pragma once

#include <ignition/msgs/dataframe.pb.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/service.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/system.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Base class of systems that carry messages between robots, like the brokers of Fortress's comms. A derived class
/// decides what happens to a message on its way.
///
/// An address is bound to topics, for a model, by a service. A message on the broker's topic is delivered in the next
/// step to all topics of its destination address, if both addresses are bound to existing models. Models are looked up
/// at the end of each step, so an address takes part from the step after it was bound.
class PONGSIM_API CommsSystem : public System {
 public:
  /// A derived class adds its parameters and its description.
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override;
  /// Removes all bindings: endpoints bind themselves again.
  void reset() override;
  void transfer(StateArchive& archive) override;

 protected:
  /// An address in messages, at the time of a step.
  struct Radio {
    const std::string& address;
    const Model& model;
  };

  /// Decides what happens to a message. Called once for each message to a bound address, in the order of the senders'
  /// addresses, then of arrival.
  /// @param now Time of the step in which it is delivered.
  /// @param message May be changed.
  /// @return Whether it is delivered.
  virtual bool carries(const Radio& from, const Radio& to, Time now, ignition::msgs::Dataframe& message) = 0;

  /// Publishes a message on all topics of an address: for a derived class that delivers later what it `carries`.
  void deliver(const std::string& address, const ignition::msgs::Dataframe& message);
  /// @return The model of an address; nothing if it is not bound to an existing one.
  std::optional<Model> modelOf(const std::string& address) const;

  /// Warns at most once per simulated second.
  void warnSeldom(const std::string& text);

 private:
  using Dataframe = ignition::msgs::Dataframe;

  /// What is known of an address.
  struct Binding {
    std::string modelName;
    /// Empty until it is looked up, and if it does not exist.
    std::optional<Model> model;
    std::map<std::string, Publisher> topics;
    /// Messages from it that wait for the next step.
    std::vector<Dataframe> outbound;
  };
  struct Saved;

  ServiceAnswer bind(const std::string& address, const std::string& model, const std::string& topic);
  ServiceAnswer unbind(const std::string& address, const std::string& topic);
  void receive(const Dataframe& message);
  void carryAll();
  void carry(const std::string& address, const Binding& from, Dataframe& message);
  std::string whyDetached(const std::string& address, const Binding& binding) const;
  std::optional<Model> find(const std::string& name) const;
  void restore(const std::vector<Saved>& all, StateArchive& archive);

  std::optional<double> stepSize_;
  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  Node* node_ = nullptr;
  /// By address.
  std::map<std::string, Binding> bindings_;
  std::size_t waitingCount_ = 0;
  std::size_t waitingBytes_ = 0;
  Time now_{0};
  Time nextWarning_{0};
  /// Warnings left out since the last one.
  std::uint64_t unmentioned_ = 0;
  Service bind_;
  Service unbind_;
  Subscription messages_;
};

}  // namespace pongsim
