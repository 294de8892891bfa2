#include "transport/delivery.hh"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "transport/deadline.hh"
#include "transport/dispatch_queue.hh"
#include "transport/gate.hh"
#include "transport/network/endpoint.hh"
#include "transport/publisher.hh"

namespace pongsim::transport {

namespace {

/// @param from Null for another process.
/// @return Whether a message goes into that inbox: not if it is not for the subscription, or was heard at once.
bool isFor(const Inbox& inbox, const PublisherState* from) {
  if (from == nullptr) return !inbox.ownOnly;
  const bool isOwn = &inbox.queue == &from->queue;
  if (!isOwn && (inbox.ownOnly || from->options.ownOnly)) return false;
  return inbox.accepts(*from) && !(isOwn && inbox.isAtOnce());
}

/// @return Whether it is from outside of the queue's transport, or brought by a carrier.
bool isOutside(const DispatchQueue& queue, const PublisherState* from) {
  return from == nullptr || from->options.relays || &from->queue != &queue;
}

}  // namespace

SpareParcels& Delivery::spareOf(const std::string& type) {
  const WaitingLock lock(mutex);
  return spare_[type];
}

Inbox& Delivery::add(std::unique_ptr<Inbox> owned) {
  Inbox& inbox = *owned;
  Channel& channel = inbox.channel;
  const WaitingLock lock(mutex);
  bool isCounted = false;
  try {
    inboxes_.emplace(&inbox, std::move(owned));
    channel.inboxes.push_back(&inbox);
    channel.countSubscription(inbox, 1);
    isCounted = true;
    const bool isLatched = channel.latched != nullptr && (!inbox.ownOnly || channel.latched->sender == kThisProcess);
    if (isLatched) put(inbox, channel.latched, channel.latched->sender != kThisProcess);
  } catch (...) {
    if (isCounted) {
      takeOut(inbox);
    } else {
      std::erase(channel.inboxes, &inbox);
    }
    inboxes_.erase(&inbox);
    throw;
  }
  return inbox;
}

void Delivery::takeOut(Inbox& inbox) {
  std::erase(inbox.channel.inboxes, &inbox);
  inbox.channel.countSubscription(inbox, -1);
  std::erase(inbox.queue.inboxesWithArrivals, &inbox);
  inbox.forgetUnread(parcels_);
}

void Delivery::undoAdd(Inbox& inbox) {
  const WaitingLock lock(mutex);
  takeOut(inbox);
  inboxes_.erase(&inbox);
}

void Delivery::remove(Inbox& inbox) {
  const WaitingLock lock(mutex);
  takeOut(inbox);
  inbox.ended = true;
  if (inbox.queue.inDispatch) {
    inbox.queue.endedInboxes.push_back(&inbox);
  } else {
    inboxes_.erase(&inbox);
  }
}

void Delivery::endLater(Inbox& inbox) {
  const WaitingLock lock(mutex);
  inbox.ended = true;
  inbox.queue.endedWhileHearing.push_back(&inbox);
  inbox.queue.waiting = true;
}

Parcel* Delivery::take(const Channel& channel, std::size_t size) {
  const WaitingLock lock(mutex);
  return parcels_.take(channel.spare, size);
}

void Delivery::giveBack(const std::vector<Parcel*>& parcels) {
  const WaitingLock lock(mutex);
  for (Parcel* parcel : parcels) parcels_.giveBack(parcel);
}

void Delivery::deliver(Channel& channel, Parcel* parcel, bool latched, const PublisherState* from) {
  DispatchQueue* first = nullptr;
  {
    const WaitingLock lock(mutex);
    for (Inbox* inbox : channel.inboxes) {
      if (!isFor(*inbox, from)) continue;
      put(*inbox, parcel, isOutside(inbox->queue, from));
      if (first == nullptr) first = &inbox->queue;
      if (first != &inbox->queue) inbox->queue.arrived.notify_one();
    }
    if (gate_ != nullptr && isOutside(gate_->queue(), from)) gate_->arrived(channel, nextArrival_);
    if (latched) {
      if (channel.latched != nullptr) parcels_.giveBack(channel.latched);
      channel.latched = parcel;
    } else {
      parcels_.giveBack(parcel);
    }
  }
  // without the mutex, or the woken thread would wait for it
  if (first != nullptr) first->arrived.notify_one();
}

void Delivery::deliverInside(Channel& channel, Parcel* parcel, const DispatchQueue& queue, bool isCarried) {
  const WaitingLock lock(mutex);
  for (Inbox* inbox : channel.inboxes) {
    if (&inbox->queue == &queue && !inbox->ownOnly && !(isCarried && inbox->relays)) put(*inbox, parcel, false);
  }
  parcels_.giveBack(parcel);
}

void Delivery::giveBack(Parcel* parcel) {
  const WaitingLock lock(mutex);
  parcels_.giveBack(parcel);
}

void Delivery::put(Inbox& inbox, Parcel* parcel, bool isOutside) {
  if (inbox.size() == 0) inbox.queue.inboxesWithArrivals.push_back(&inbox);
  inbox.add(nextArrival_++, parcel, isOutside, dropped_);
  ++parcel->users;
  for (Parcel* each : dropped_) parcels_.giveBack(each);
  dropped_.clear();
  inbox.queue.waiting = true;
}

void Delivery::forgetLatched(Channel& channel, const std::function<bool(const ParticipantId& sender)>& isMeant) {
  const WaitingLock lock(mutex);
  if (channel.latched == nullptr || !isMeant(channel.latched->sender)) return;
  parcels_.giveBack(std::exchange(channel.latched, nullptr));
}

void Delivery::collect(DispatchQueue& queue) {
  const WaitingLock lock(mutex);
  if (gate_ != nullptr && &gate_->queue() == &queue) {
    std::erase_if(queue.inboxesWithArrivals, [&](Inbox* inbox) REQUIRES(dispatchingRole, waitingRole) {
      inbox->moveTo(queue.arrivals, gate_->limitOf(inbox->channel));
      return inbox->size() == 0;
    });
  } else {
    for (Inbox* inbox : queue.inboxesWithArrivals) inbox->moveTo(queue.arrivals);
    queue.inboxesWithArrivals.clear();
  }
  // types may have been found, and subscriptions ended, since they were looked at
  queue.waiting = !queue.foundTypes.empty() || !queue.endedWhileHearing.empty();
  std::ranges::sort(queue.arrivals, {}, &Arrival::number);
}

void Delivery::setGate(Gate* gate) {
  const WaitingLock lock(mutex);
  gate_ = gate;
  if (gate == nullptr) return;
  // what came before it is held, and counts, too
  std::vector<Arrival> came;
  for (const Inbox* inbox : gate->queue().inboxesWithArrivals) {
    std::ranges::copy_if(inbox->waiting(), std::back_inserter(came), &Arrival::isOutside);
  }
  std::ranges::sort(came, {}, &Arrival::number);
  for (std::size_t i = 0; i < came.size(); ++i) {
    const bool isLastOfMessage = i + 1 == came.size() || came[i + 1].parcel != came[i].parcel;
    if (isLastOfMessage) gate->arrived(came[i].inbox->channel, came[i].number + 1);
  }
}

void Delivery::discard(DispatchQueue& queue) {
  const WaitingLock lock(mutex);
  if (gate_ != nullptr && &gate_->queue() == &queue) gate_->forget();
  std::erase_if(queue.inboxesWithArrivals, [this](Inbox* inbox) REQUIRES(waitingRole) {
    inbox->forgetUnread(parcels_, inbox->channel.latched);
    return inbox->size() == 0;
  });
}

void Delivery::release(DispatchQueue& queue) {
  const WaitingLock lock(mutex);
  for (const Arrival& arrival : queue.arrivals) parcels_.giveBack(arrival.parcel);
  queue.arrivals.clear();
  for (Inbox* inbox : queue.endedInboxes) inboxes_.erase(inbox);
  queue.endedInboxes.clear();
  queue.inDispatch = false;
}

void Delivery::wait(DispatchQueue& queue, std::chrono::nanoseconds timeout) {
  WaitingLock lock(mutex);
  queue.arrived.wait_until(lock, deadlineAfter(timeout),
                           [&queue]() REQUIRES(waitingRole) { return queue.woken || !queue.isIdle(); });
  queue.woken = false;
}

void Delivery::wake(DispatchQueue& queue) {
  {
    const WaitingLock lock(mutex);
    queue.woken = true;
  }
  queue.arrived.notify_one();
}

void Delivery::notify(DispatchQueue& queue) {
  // locked once, so that a thread that is about to wait, and has seen nothing yet, does not miss the notification
  { const WaitingLock lock(mutex); }
  queue.arrived.notify_one();
}

bool Delivery::waitForSubscribers(const PublisherState& publisher, std::chrono::nanoseconds timeout) {
  WaitingLock lock(mutex);
  return subscribersChanged_.wait_until(lock, deadlineAfter(timeout),
                                        [&publisher] { return publisher.hasSubscribers(); });
}

void Delivery::subscribersChanged() {
  // as in `notify`
  { const WaitingLock lock(mutex); }
  subscribersChanged_.notify_all();
}

std::uint64_t Delivery::received(const Inbox& inbox) {
  const WaitingLock lock(mutex);
  return inbox.received();
}

std::uint64_t Delivery::dropped(const Inbox& inbox) {
  const std::uint64_t lost = inbox.reader == nullptr ? 0 : inbox.reader->lost() - inbox.lostBefore;
  const WaitingLock lock(mutex);
  return inbox.dropped() + lost;
}

}  // namespace pongsim::transport
