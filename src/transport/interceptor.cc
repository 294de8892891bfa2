#include "transport/interceptor.hh"

#include <algorithm>
#include <utility>

#include "transport/bus.hh"
#include "transport/names/topic_name.hh"
#include "transport/publisher.hh"

namespace pongsim {

namespace transport {

Interceptor::Interceptor(Bus& itsBus, DispatchQueue& itsQueue, Node node, std::string itsTopic,
                         Interception::Taken taken)
    : bus(itsBus), queue(itsQueue), topic(std::move(itsTopic)), node_(std::move(node)), taken_(std::move(taken)) {}

void Interceptor::call(const Interception::Crossing& crossing) {
  const std::lock_guard lock(calling_);
  taken_(crossing);
}

void Interceptor::takeOutgoing(std::string_view type, std::span<const std::byte> bytes,
                               const std::function<void(std::span<const std::byte>)>& pass) {
  call({type, bytes, false, false, pass});
}

std::span<Parcel* const> Interceptor::takeIncoming(Channel& channel, Parcel& parcel) {
  if (last_ == &parcel) return passed_;
  release();
  last_ = &parcel;
  const std::function<void(std::span<const std::byte>)> pass = [&](std::span<const std::byte> bytes) {
    Parcel* copy = bus.delivery().take(channel, bytes.size());
    std::copy(bytes.begin(), bytes.end(), copy->bytes->bytes.begin());
    copy->sender = parcel.sender;
    passed_.push_back(copy);
  };
  call({channel.type, parcel.bytes->bytes, true, parcel.sender == kThisProcess, pass});
  return passed_;
}

void Interceptor::release() {
  for (Parcel* parcel : passed_) bus.delivery().giveBack(parcel);
  passed_.clear();
  last_ = nullptr;
}

Publisher& Interceptor::publisherOf(std::string_view type) {
  const auto found = publishers_.find(type);
  if (found != publishers_.end()) return found->second;
  return publishers_.emplace(std::string(type), node_.advertiseBytes(topic, type)).first->second;
}

}  // namespace transport

Interception::Interception(const Node& node, std::string_view topic, Taken taken)
    : interceptor_(std::make_unique<transport::Interceptor>(
          *node.bus_, *node.queue_, node, transport::absoluteTopic(node.fullName(topic)), std::move(taken))) {
  interceptor_->bus.add(*interceptor_);
}

Interception::~Interception() { interceptor_->bus.end(*interceptor_); }

void Interception::send(std::string_view type, std::span<const std::byte> bytes, bool isIncoming, bool isCarried) {
  if (isIncoming) return interceptor_->bus.sendInside(*interceptor_, type, bytes, isCarried);
  transport::publishPassed(*interceptor_->publisherOf(type).state_, bytes);
}

}  // namespace pongsim
