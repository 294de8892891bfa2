#include "ros2/bench/bare_pair.hh"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include <cstring>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pongsim::ros2 {

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

using Bytes = std::vector<std::byte>;
// larger than an image
constexpr std::uint32_t kMost = 4 << 20;

/// Bytes that are already CDR.
class RawType final : public dds::TopicDataType {
 public:
  explicit RawType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = kMost;
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<const Bytes*>(data);
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    const auto* begin = reinterpret_cast<const std::byte*>(payload->data);
    static_cast<Bytes*>(data)->assign(begin, begin + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size()); };
  }
  void* createData() override { return std::make_unique<Bytes>().release(); }
  void deleteData(void* data) override { std::unique_ptr<Bytes>(static_cast<Bytes*>(data)).reset(); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace

struct BarePeer::Parts final : dds::DataReaderListener, dds::DataWriterListener {
  explicit Parts(std::atomic<int>& matchedEndpoints) : matched(matchedEndpoints) {}

  struct RawSubscription {
    dds::DataReader* reader;
    std::function<void(std::span<const std::byte>)> received;
  };

  void on_data_available(dds::DataReader* reader) override {
    const std::lock_guard lock(mutex);
    dds::SampleInfo info;
    while (reader->take_next_sample(&taken, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      for (const RawSubscription& each : subscriptions) {
        if (each.reader == reader) each.received(taken);
      }
    }
  }
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    matched += status.current_count_change;
  }
  void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& status) override {
    matched += status.current_count_change;
  }

  dds::Topic* topicOf(const std::string& topic, const std::string& type) {
    dds::TypeSupport(std::make_unique<RawType>(type).release()).register_type(participant);
    return participant->create_topic(topic, type, dds::TOPIC_QOS_DEFAULT);
  }

  std::atomic<int>& matched;
  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  dds::DataWriter* writer = nullptr;
  std::mutex mutex;
  std::vector<RawSubscription> subscriptions;
  Bytes taken;
  Bytes written;
};

BarePeer::BarePeer(int domain, Transports transports) : parts_(std::make_unique<Parts>(matched_)) {
  dds::DomainParticipantQos qos;
  if (transports == Transports::kUdp) {
    qos.transport().use_builtin_transports = false;
    const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->sendBufferSize = udp->receiveBufferSize = 4 << 20;
    qos.transport().user_transports.push_back(udp);
  }
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  parts_->participant = factory->create_participant(static_cast<std::uint32_t>(domain), qos);
  if (parts_->participant == nullptr) throw std::runtime_error("Fast DDS makes no participant");
  parts_->publisher = parts_->participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  parts_->subscriber = parts_->participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
}

BarePeer::~BarePeer() {
  parts_->participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(parts_->participant);
}

void BarePeer::read(const std::string& topic, const std::string& type,
                    std::function<void(std::span<const std::byte>)> received) {
  dds::DataReaderQos qos;
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.history().depth = 10;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
  auto* const topicOf = parts_->topicOf(topic, type);
  const std::lock_guard lock(parts_->mutex);
  parts_->subscriptions.push_back({nullptr, std::move(received)});
  parts_->subscriptions.back().reader = parts_->subscriber->create_datareader(topicOf, qos, parts_.get());
}

void BarePeer::openWriter(const std::string& topic, const std::string& type) {
  dds::DataWriterQos qos;
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.history().depth = 10;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
  parts_->writer = parts_->publisher->create_datawriter(parts_->topicOf(topic, type), qos, parts_.get());
}

void BarePeer::write(std::span<const std::byte> payload) {
  parts_->written.assign(payload.begin(), payload.end());
  parts_->writer->write(&parts_->written);
}

}  // namespace pongsim::ros2
