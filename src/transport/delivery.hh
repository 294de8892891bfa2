#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "transport/channel.hh"
#include "transport/inbox.hh"
#include "transport/locks.hh"
#include "transport/parcel.hh"

namespace pongsim::transport {

class DispatchQueue;
class Gate;

/// Puts messages into inboxes, and gives what waits there to `dispatch`. Thread-safe.
class Delivery {
 public:
  /// Guards what waits, in inboxes and queues; never held while a function of a user or DDS is called.
  std::mutex mutex;

  /// @return The unused parcels of a type, which exist as long as this.
  SpareParcels& spareOf(const std::string& type);

  /// Adds a subscription to its channel, with the latched message, and owns it.
  Inbox& add(std::unique_ptr<Inbox> inbox) REQUIRES(setUpRole);
  /// Takes a subscription out of its channel with what waits for it. It is kept while its queue is in `dispatch`.
  void remove(Inbox& inbox) REQUIRES(dispatchingRole, setUpRole);
  /// The same for one whose setting up has failed.
  void undoAdd(Inbox& inbox) REQUIRES(setUpRole);
  /// Lets the next `dispatch` end a subscription at once, which may be running.
  void endLater(Inbox& inbox);

  /// @return A parcel for the channel's messages, with a buffer of that size.
  Parcel* take(const Channel& channel, std::size_t size);
  /// Ends one use of each.
  void giveBack(const std::vector<Parcel*>& parcels);
  /// Puts a message into the inboxes that it is for.
  /// @param from Null for another process.
  void deliver(Channel& channel, Parcel* parcel, bool latched, const PublisherState* from);
  /// Puts a message into the queue's inboxes only, as one that no gate holds.
  /// @param isCarried Whether a carrier has brought it: then other carriers do not get it.
  void deliverInside(Channel& channel, Parcel* parcel, const DispatchQueue& queue, bool isCarried);
  /// Ends a use of a parcel that was taken.
  void giveBack(Parcel* parcel);
  /// Forgets a latched message of such a sender.
  void forgetLatched(Channel& channel, const std::function<bool(const ParticipantId& sender)>& isMeant);

  /// Drops what waits, except latched messages.
  void discard(DispatchQueue& queue);

  /// Lets a gate hold what comes from outside to its queue; null: nothing is held.
  void setGate(Gate* gate);
  /// @return The number of the next message, counted over all inboxes.
  std::uint64_t nextArrival() const REQUIRES(waitingRole) { return nextArrival_; }

  /// Moves what waits to the queue's arrivals, in the order of arrival; `release` ends their use.
  void collect(DispatchQueue& queue) REQUIRES(dispatchingRole);
  void release(DispatchQueue& queue) REQUIRES(dispatchingRole);

  /// Waits until `wake`, or something waits for `dispatch`.
  void wait(DispatchQueue& queue, std::chrono::nanoseconds timeout);
  void wake(DispatchQueue& queue);
  /// Ends such a wait after a request or response has arrived.
  void notify(DispatchQueue& queue);
  bool waitForSubscribers(const PublisherState& publisher, std::chrono::nanoseconds timeout);
  void subscribersChanged();

  std::uint64_t received(const Inbox& inbox);
  std::uint64_t dropped(const Inbox& inbox);

 private:
  void put(Inbox& inbox, Parcel* parcel, bool isOutside) REQUIRES(waitingRole);
  void takeOut(Inbox& inbox) REQUIRES(setUpRole, waitingRole);

  std::condition_variable subscribersChanged_;
  std::map<const Inbox*, std::unique_ptr<Inbox>> inboxes_ GUARDED_BY(waitingRole);
  std::map<std::string, SpareParcels> spare_ GUARDED_BY(waitingRole);
  ParcelPool parcels_ GUARDED_BY(waitingRole);
  std::vector<Parcel*> dropped_ GUARDED_BY(waitingRole);
  std::uint64_t nextArrival_ GUARDED_BY(waitingRole) = 0;
  Gate* gate_ GUARDED_BY(waitingRole) = nullptr;
};

}  // namespace pongsim::transport
