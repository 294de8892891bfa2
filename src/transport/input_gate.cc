// What comes from outside a world, noted or replaced where a dispatch hands it over.
#include "transport/input_gate.hh"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "pongsim/node.hh"
#include "transport/any_type.hh"
#include "transport/bus.hh"

namespace pongsim::transport {

namespace {

/// Number of the calls that replaced requests stand for: nobody waits for them.
constexpr std::uint64_t kNobodysCall = std::numeric_limits<std::uint64_t>::max();

bool isOutside(const Arrival& arrival, const DispatchQueue& queue) { return arrival.parcel->origin != &queue; }

/// @return The place of an inbox of the queue's world.
Intake::Place placeOf(const Inbox& inbox) REQUIRES(waitingRole) {
  std::uint64_t before = 0;
  for (const Inbox* each : inbox.channel.inboxes) {
    if (each == &inbox) break;
    if (&each->queue == &inbox.queue && each->isOfWorld()) ++before;
  }
  return {inbox.channel.topic, inbox.channel.type, before};
}

}  // namespace

void Intake::clear() {
  messages.clear();
  left.clear();
  requests.clear();
}

InputGate::InputGate(Transport& transport, Use use) : bus_(*transport.bus_), queue_(*transport.queue_), use_(use) {
  const DispatchLock lock(queue_.dispatching);
  queue_.gate = this;
}

InputGate::~InputGate() {
  const DispatchLock lock(queue_.dispatching);
  queue_.gate = nullptr;
  // of other processes
  queue_.requestsWaiting = true;
}

void InputGate::handOver(Intake next) {
  intake = std::move(next);
  missing.clear();
  if (intake.isEmpty()) return;
  queue_.waiting = true;
  queue_.requestsWaiting = true;
}

void InputGate::serve() { bus_.serve(queue_, Inbox::kNoLimit); }

void Bus::note(DispatchQueue& queue) {
  Intake& intake = queue.gate->intake;
  std::vector<const Inbox*> reached;
  const WaitingLock lock(delivery_.mutex);
  std::uint64_t position = 0;
  for (const Arrival& arrival : queue.arrivals) {
    if (!arrival.inbox->isOfWorld()) continue;
    if (isOutside(arrival, queue)) {
      const std::span<const std::byte> bytes = arrival.parcel->bytes->bytes;
      intake.messages.push_back({position, placeOf(*arrival.inbox), {bytes.begin(), bytes.end()}});
      if (std::ranges::find(reached, arrival.inbox) == reached.end()) reached.push_back(arrival.inbox);
    }
    ++position;
  }
  for (const Inbox* inbox : reached) {
    const auto own = std::ranges::count_if(
        queue.arrivals, [&](const Arrival& each) { return each.inbox == inbox && !isOutside(each, queue); });
    intake.left.push_back({placeOf(*inbox), static_cast<std::uint64_t>(own)});
  }
}

/// @return The world's subscription at that place, which is made where a subscription to any type has not met the type;
/// null without one.
Inbox* Bus::findInbox(DispatchQueue& queue, const Intake::Place& place) {
  const SetUpLock lock(setUp_);
  for (AnyType* any : anyTypesOn(place.topic)) {
    if (any->queue == &queue) hear(*any, place.type);
  }
  const auto found = channels_.find(std::pair(place.topic, place.type));
  if (found == channels_.end()) return nullptr;
  const WaitingLock inboxesLock(delivery_.mutex);
  std::uint64_t before = 0;
  for (Inbox* inbox : found->second->inboxes) {
    if (&inbox->queue == &queue && inbox->isOfWorld() && before++ == place.subscription) return inbox;
  }
  return nullptr;
}

void Bus::replace(DispatchQueue& queue) {
  const Intake intake = std::exchange(queue.gate->intake, {{}, {}, queue.gate->intake.requests});
  std::vector<Parcel*> unused;
  std::erase_if(queue.arrivals, [&](const Arrival& arrival) REQUIRES(dispatchingRole) {
    const bool isDropped = arrival.inbox->isOfWorld() && isOutside(arrival, queue);
    if (isDropped) unused.push_back(arrival.parcel);
    return isDropped;
  });
  for (const Intake::Left& left : intake.left) {
    const Inbox* const inbox = findInbox(queue, left.place);
    auto more = static_cast<std::uint64_t>(std::ranges::count(queue.arrivals, inbox, &Arrival::inbox));
    std::erase_if(queue.arrivals, [&](const Arrival& arrival) {
      const bool isDropped = arrival.inbox == inbox && more > left.count;
      if (isDropped) unused.push_back(arrival.parcel);
      if (isDropped) --more;
      return isDropped;
    });
  }
  delivery_.giveBack(unused);

  std::vector<Arrival> all;
  all.reserve(queue.arrivals.size() + intake.messages.size());
  auto next = intake.messages.begin();
  std::uint64_t position = 0;
  const auto addUpTo = [&](std::uint64_t last) REQUIRES(dispatchingRole) {
    for (; next != intake.messages.end() && next->position <= last; ++next, ++position) {
      Inbox* const inbox = findInbox(queue, next->place);
      if (inbox == nullptr) {
        queue.gate->missing.push_back("a subscription to '" + next->place.topic + "' of type " + next->place.type);
        continue;
      }
      Parcel* const parcel = delivery_.take(inbox->channel, next->bytes.size());
      std::ranges::copy(next->bytes, parcel->bytes->bytes.begin());
      all.push_back({0, inbox, parcel, true});
    }
  };
  for (const Arrival& arrival : queue.arrivals) {
    if (arrival.inbox->isOfWorld()) {
      while (next != intake.messages.end() && next->position <= position) addUpTo(position);
      ++position;
    }
    all.push_back(arrival);
  }
  addUpTo(std::numeric_limits<std::uint64_t>::max());
  queue.arrivals = std::move(all);
}

void ServiceServer::note(DispatchQueue& queue, const std::vector<Ready>& ready) {
  std::uint64_t position = 0;
  for (const Ready& each : ready) {
    if (!each.offer->isOfWorld) continue;
    if (each.request.origin != &queue) {
      queue.gate->intake.requests.push_back({position, each.offer->name, each.request.message});
    }
    ++position;
  }
}

void ServiceServer::replace(DispatchQueue& queue, std::vector<Ready>& ready) {
  const std::vector<Intake::Request> requests = std::exchange(queue.gate->intake.requests, {});
  std::erase_if(ready, [&](const Ready& each) REQUIRES(dispatchingRole) {
    const bool isDropped = each.offer->isOfWorld && each.request.origin != &queue;
    if (isDropped) answerOwn_(queue, each.request.call, std::nullopt, {});
    return isDropped;
  });
  std::vector<Ready> all;
  auto next = requests.begin();
  std::uint64_t position = 0;
  const auto addUpTo = [&](std::uint64_t last) REQUIRES(dispatchingRole) {
    for (; next != requests.end() && next->position <= last; ++next, ++position) {
      Offer* offer = nullptr;
      {
        const RequestsLock lock(mutex_);
        offer = find(queue, next->service);
      }
      if (offer == nullptr || &offer->queue != &queue) {
        queue.gate->missing.push_back("the service '" + next->service + "'");
        continue;
      }
      all.push_back({offer, {0, {}, kNobodysCall, std::chrono::steady_clock::now(), next->bytes}});
    }
  };
  for (Ready& each : ready) {
    if (each.offer->isOfWorld) {
      while (next != requests.end() && next->position <= position) addUpTo(position);
      ++position;
    }
    all.push_back(std::move(each));
  }
  addUpTo(std::numeric_limits<std::uint64_t>::max());
  ready = std::move(all);
}

}  // namespace pongsim::transport
