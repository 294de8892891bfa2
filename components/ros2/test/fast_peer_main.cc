// A ROS node on Fast DDS, set up like rmw_fastrtps, without any code of pongsim. For test_fast_dds.py.
//   fast_peer read TOPIC TYPE QOS          prints "read SECONDS HEX" for each payload, counted from the reader's
//   creation fast_peer write TOPIC TYPE QOS HEX MS  writes the payload every MS milliseconds; 0: once
// QOS is reliable, best_effort or latched. Prints "matched N" whenever the number of counterparts changes. Ends with
// its input. ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY, ROS_SECURITY_ENABLE, _KEYSTORE and _ENCLAVE_OVERRIDE work as for any
// node.
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
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

#include <poll.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Clock = std::chrono::steady_clock;

// the payload of a type of variable size starts small, like rmw's
constexpr std::uint32_t kBegin = 256;

/// Payloads as raw bytes.
class RawType final : public dds::TopicDataType {
 public:
  using Bytes = std::vector<unsigned char>;

  explicit RawType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = kBegin;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<const Bytes*>(data);
    if (payload->max_size < bytes.size()) return false;
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size()); };
  }
  void* createData() override { return std::make_unique<Bytes>().release(); }
  void deleteData(void* data) override { std::unique_ptr<Bytes>(static_cast<Bytes*>(data)).reset(); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

/// Prints one line at a time, from any thread.
class Output {
 public:
  void matched(int count) {
    const std::lock_guard lock(mutex_);
    std::printf("matched %d\n", count);
    std::fflush(stdout);
  }
  void read(double seconds, const RawType::Bytes& bytes) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    text.reserve(2 * bytes.size());
    for (const unsigned char byte : bytes) {
      text += kDigits[byte >> 4];
      text += kDigits[byte & 15];
    }
    const std::lock_guard lock(mutex_);
    std::printf("read %.3f %s\n", seconds, text.c_str());
    std::fflush(stdout);
  }

 private:
  std::mutex mutex_;
};

class Listener final : public dds::DataReaderListener, public dds::DataWriterListener {
 public:
  void on_data_available(dds::DataReader* reader) override {
    dds::SampleInfo info;
    while (reader->take_next_sample(&bytes_, &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) output_.read(std::chrono::duration<double>(Clock::now() - begin_).count(), bytes_);
    }
  }
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    output_.matched(status.current_count);
  }
  void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& status) override {
    output_.matched(status.current_count);
  }

 private:
  Clock::time_point begin_ = Clock::now();
  RawType::Bytes bytes_;
  Output output_;
};

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string() : std::string(text);
}

/// As in rmw_fastrtps_shared_cpp for an enclave, if security is on.
void addSecurity(dds::DomainParticipantQos& qos) {
  if (environment("ROS_SECURITY_ENABLE") != "true") return;
  const std::string folder = "file://" + environment("ROS_SECURITY_KEYSTORE") + "/enclaves" +
                             environment("ROS_SECURITY_ENCLAVE_OVERRIDE") + "/";
  const auto add = [&qos](const char* name, const std::string& value) {
    qos.properties().properties().emplace_back(name, value);
  };
  add("dds.sec.auth.plugin", "builtin.PKI-DH");
  add("dds.sec.auth.builtin.PKI-DH.identity_ca", folder + "identity_ca.cert.pem");
  add("dds.sec.auth.builtin.PKI-DH.identity_certificate", folder + "cert.pem");
  add("dds.sec.auth.builtin.PKI-DH.private_key", folder + "key.pem");
  add("dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC");
  add("dds.sec.access.plugin", "builtin.Access-Permissions");
  add("dds.sec.access.builtin.Access-Permissions.permissions_ca", folder + "permissions_ca.cert.pem");
  add("dds.sec.access.builtin.Access-Permissions.governance", folder + "governance.p7s");
  add("dds.sec.access.builtin.Access-Permissions.permissions", folder + "permissions.p7s");
}

/// As in rmw_fastrtps_shared_cpp (participant.cpp, branch humble).
dds::DomainParticipant* makeParticipant() {
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  constexpr std::string_view kUserData("enclave=/;", 11);
  qos.user_data().resize(kUserData.size());
  std::memcpy(qos.user_data().data(), kUserData.data(), kUserData.size());
  qos.name("/");
  qos.wire_protocol().builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.wire_protocol().builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  if (environment("ROS_LOCALHOST_ONLY") == "1") {
    qos.transport().use_builtin_transports = false;
    const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.emplace_back("127.0.0.1");
    qos.transport().user_transports.push_back(udp);
    qos.transport().user_transports.push_back(
        std::make_shared<eprosima::fastdds::rtps::SharedMemTransportDescriptor>());
  }
  addSecurity(qos);
  const auto domain = static_cast<std::uint32_t>(std::atoi(environment("ROS_DOMAIN_ID").c_str()));
  return dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos);
}

/// As in rmw_fastrtps_shared_cpp/qos.cpp.
template <class EndpointQos>
EndpointQos endpointQos(const std::string& name) {
  EndpointQos qos;
  qos.history().depth = name == "latched" ? 1 : 10;
  qos.reliability().kind = name == "best_effort" ? dds::BEST_EFFORT_RELIABILITY_QOS : dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = name == "latched" ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
  return qos;
}

RawType::Bytes bytesOf(std::string_view hex) {
  RawType::Bytes bytes(hex.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i) std::from_chars(&hex[2 * i], &hex[2 * i] + 2, bytes[i], 16);
  return bytes;
}

/// Waits for the end of the input.
/// @return Whether it has ended within the time; negative: no limit.
bool isOver(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  char bytes[256];
  return poll(&input, 1, milliseconds) > 0 && read(STDIN_FILENO, bytes, sizeof bytes) <= 0;
}

int run(const std::vector<std::string>& arguments) {
  dds::DomainParticipant* const participant = makeParticipant();
  if (participant == nullptr) return 1;
  dds::TypeSupport(std::make_unique<RawType>(arguments[2]).release()).register_type(participant);
  dds::Topic* const topic = participant->create_topic(arguments[1], arguments[2], dds::TOPIC_QOS_DEFAULT);
  Listener listener;
  if (arguments[0] == "read") {
    dds::Subscriber* const subscriber = participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    subscriber->create_datareader(topic, endpointQos<dds::DataReaderQos>(arguments[3]), &listener);
    while (!isOver(-1)) {
    }
  } else {
    dds::Publisher* const publisher = participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    dds::DataWriter* const writer =
        publisher->create_datawriter(topic, endpointQos<dds::DataWriterQos>(arguments[3]), &listener);
    RawType::Bytes payload = bytesOf(arguments[4]);
    const int period = std::atoi(arguments[5].c_str());
    do writer->write(&payload);
    while (!isOver(period > 0 ? period : -1));
  }
  participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool reads = arguments.size() == 4 && arguments[0] == "read";
  const bool writes = arguments.size() == 6 && arguments[0] == "write";
  return reads || writes ? run(arguments) : 2;
}
