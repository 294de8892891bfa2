#include "transport/inbox.hh"

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "msgs/encoding/bytes.hh"
#include "msgs/fields/number_check.hh"
#include "transport/bus.hh"

namespace pongsim::transport {

namespace {

// What waits for one subscription, unless it is a single message.
constexpr std::size_t kMostInboxBytes = 64 << 20;

// A rate below this is as good as no message at all, and fits the clock.
constexpr double kLowestRate = 1e-6;

/// @return Why a message with such numbers is refused, or nothing.
std::optional<std::string> refusal(const Message& message, double largest) {
  const std::optional<std::string> fault = msgs::unusableNumber(message, largest);
  if (!fault) return std::nullopt;
  std::ostringstream text;
  text << "is refused: " << *fault << "; numbers must be finite, from " << -largest << " to " << largest;
  return text.str();
}

}  // namespace

Inbox::Inbox(Channel& channel, const SubscriptionOptions& options)
    : channel_(channel), limit_(std::max<std::size_t>(options.queueLength, 1)) {
  except = excepted(options);
  relays = options.relays;
  ownOnly = options.ownOnly;
  if (!options.messagesPerSecond) return;
  const std::chrono::duration<double> period(1 / std::max(*options.messagesPerSecond, kLowestRate));
  period_ = std::chrono::duration_cast<Clock::duration>(period);
}

Inbox::Inbox(Channel& channel, MessagePointer message, Received received, const SubscriptionOptions& options)
    : Inbox(channel, options) {
  take_ = [message = std::shared_ptr<Message>(std::move(message)), received = std::move(received),
           largest = options.largestNumber](auto bytes) -> std::optional<std::string> {
    if (!msgs::parseBytes(bytes, *message)) return "is not of type " + msgs::typeName(*message);
    if (largest) {
      if (std::optional<std::string> fault = refusal(*message, *largest)) return fault;
    }
    received(*message);
    return std::nullopt;
  };
}

Inbox::Inbox(Channel& channel, ReceivedBytes received, const SubscriptionOptions& options) : Inbox(channel, options) {
  take_ = [received = std::move(received)](auto bytes) {
    received(bytes);
    return std::optional<std::string>();
  };
}

Inbox::~Inbox() = default;

const void* Inbox::excepted(const SubscriptionOptions& options) {
  return options.except == nullptr ? nullptr : options.except->state_.get();
}

bool Inbox::hears(const PublisherState& publisher) const {
  return except != &publisher && !(relays && publisher.options.relays);
}

bool Inbox::wants() {
  if (!period_) return true;
  const Clock::time_point now = Clock::now();
  if (now < next_) return false;
  // the mean is kept where messages come unevenly, and a long silence is not made up for
  next_ = now - next_ < *period_ ? next_ + *period_ : now + *period_;
  return true;
}

void Inbox::add(std::uint64_t number, Buffer* buffer, std::vector<Buffer*>& dropped) {
  ++came_;
  waitingBytes_ += buffer->bytes.size();
  while (size() >= limit_ || (size() > 0 && waitingBytes_ > kMostInboxBytes)) dropped.push_back(removeOldest());
  waiting_.push_back({number, this, buffer});
}

Buffer* Inbox::removeOldest() {
  Buffer* oldest = waiting_[first_++].buffer;
  ++dropped_;
  waitingBytes_ -= oldest->bytes.size();
  // the dropped ones' room is used again
  if (first_ >= size()) {
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
  return oldest;
}

void Inbox::moveTo(std::vector<Arrival>& arrivals) {
  arrivals.insert(arrivals.end(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_), waiting_.end());
  clear();
}

void Inbox::forgetUnread(const std::function<void(Buffer*)>& giveBack) {
  for (std::size_t i = first_; i < waiting_.size(); ++i) giveBack(waiting_[i].buffer);
  clear();
}

void Inbox::clear() {
  waiting_.clear();
  first_ = 0;
  waitingBytes_ = 0;
}

}  // namespace pongsim::transport
