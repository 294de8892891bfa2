#include "transport/inbox.hh"

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "msgs/fields/number_check.hh"
#include "transport/channel.hh"
#include "transport/network/endpoint.hh"
#include "transport/publisher.hh"

namespace pongsim::transport {

namespace {

// Most bytes that wait for one subscription; a single message may be larger.
constexpr std::size_t kMostInboxBytes = 64 << 20;

}  // namespace

Inbox::Inbox(Channel& itsChannel, DispatchQueue& itsQueue, Function function, const SubscriptionOptions& options,
             CallGuard* guard)
    : channel(itsChannel),
      queue(itsQueue),
      relays(options.relays),
      ownOnly(options.ownOnly),
      except(excepted(options)),
      function_(std::move(function)),
      guard_(guard),
      queueLength_(std::max<std::size_t>(options.queueLength, 1)),
      largestNumber_(options.largestNumber) {}

Inbox::~Inbox() = default;

const void* Inbox::excepted(const SubscriptionOptions& options) {
  return options.except == nullptr ? nullptr : options.except->state_.get();
}

bool Inbox::accepts(const PublisherState& publisher) const {
  return except != &publisher && !(relays && publisher.options.relays);
}

void Inbox::add(std::uint64_t number, Parcel* parcel, bool isOutside, std::vector<Parcel*>& dropped) {
  ++added_;
  waitingBytes_ += parcel->bytes->bytes.size();
  while (size() >= queueLength_ || (size() > 0 && waitingBytes_ > kMostInboxBytes)) dropped.push_back(removeOldest());
  waiting_.push_back({number, this, parcel, isOutside});
}

Parcel* Inbox::removeOldest() {
  Parcel* oldest = waiting_[first_++].parcel;
  ++dropped_;
  waitingBytes_ -= oldest->bytes->bytes.size();
  // reuses the room of dropped ones; amortized, since at least half of the elements are dropped ones
  if (first_ >= size()) {
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
  return oldest;
}

void Inbox::moveTo(std::vector<Arrival>& arrivals, std::uint64_t limit) {
  const auto first = waiting_.begin() + static_cast<std::ptrdiff_t>(first_);
  if (limit == kNoLimit) {
    arrivals.insert(arrivals.end(), first, waiting_.end());
    clear();
    return;
  }
  waiting_.erase(waiting_.begin(), first);
  first_ = 0;
  std::erase_if(waiting_, [&](const Arrival& arrival) REQUIRES(waitingRole) {
    if (arrival.isOutside && arrival.number >= limit) return false;
    waitingBytes_ -= arrival.parcel->bytes->bytes.size();
    arrivals.push_back(arrival);
    return true;
  });
}

void Inbox::forgetUnread(ParcelPool& pool, const Parcel* kept) {
  std::optional<Arrival> stays;
  for (std::size_t i = first_; i < waiting_.size(); ++i) {
    if (waiting_[i].parcel == kept) {
      stays = waiting_[i];
    } else {
      pool.giveBack(waiting_[i].parcel);
    }
  }
  clear();
  if (!stays) return;
  // within the memory that it was in
  waiting_.push_back(*stays);
  waitingBytes_ = stays->parcel->bytes->bytes.size();
}

void Inbox::clear() {
  waiting_.clear();
  first_ = 0;
  waitingBytes_ = 0;
}

template <class Call>
void Inbox::call(CallGuard::Moment moment, const Call& function) const {
  if (guard_ == nullptr) return function();
  guard_->call(moment, function);
}

std::optional<std::string> Inbox::handOver(Parcel& parcel) {
  constexpr auto kDispatch = CallGuard::Moment::kDispatch;
  const std::span<const std::byte> bytes = parcel.bytes->bytes;
  if (const auto* received = std::get_if<std::function<void(std::span<const std::byte>)>>(&function_)) {
    call(kDispatch, [&] { (*received)(bytes); });
  } else if (const auto* any = std::get_if<std::shared_ptr<const ReceivedOfAnyType>>(&function_)) {
    call(kDispatch, [&] { (**any)(channel.type, bytes); });
  } else if (const auto* heard = std::get_if<HeardBytesAtOnce>(&function_)) {
    const Hearing hearing(channel);
    const auto write = [bytes](std::span<std::byte> place) { std::ranges::copy(bytes, place.begin()); };
    if (!ended) call(kDispatch, [&] { (*heard)(bytes.size(), write); });
  } else {
    return handOverMessage(parcel);
  }
  return std::nullopt;
}

std::optional<std::string> Inbox::handOverMessage(Parcel& parcel) {
  constexpr auto kDispatch = CallGuard::Moment::kDispatch;
  const Message* message = parcel.parsed(channel.type);
  if (message == nullptr) return "is not of type " + channel.type;
  if (std::optional<std::string> reason = refusal(*message)) return "is refused: " + *reason;
  if (const auto* heard = std::get_if<HeardAtOnce>(&function_)) {
    const Hearing hearing(channel);
    if (!ended) call(kDispatch, [&] { (*heard)(*message, nullptr); });
  } else {
    call(kDispatch, [&] { std::get<std::function<void(const Message&)>>(function_)(*message); });
  }
  return std::nullopt;
}

std::optional<std::string> Inbox::refusal(const Message& message) const {
  if (!largestNumber_) return std::nullopt;
  const std::optional<std::string> fault = msgs::unusableNumber(message, *largestNumber_);
  if (!fault) return std::nullopt;
  std::ostringstream text;
  text << *fault << "; numbers must be finite, from " << -*largestNumber_ << " to " << *largestNumber_;
  return text.str();
}

void Inbox::hear(const Message& message, const Bulk* bulk) const {
  call(CallGuard::Moment::kPublish, [&] { std::get<HeardAtOnce>(function_)(message, bulk); });
}

void Inbox::hearBytes(std::size_t size, const std::function<void(std::span<std::byte>)>& write) const {
  call(CallGuard::Moment::kPublish, [&] { std::get<HeardBytesAtOnce>(function_)(size, write); });
}

}  // namespace pongsim::transport
