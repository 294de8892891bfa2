#include "web/foxglove/log_offer.hh"

#include <foxglove/log.pb.h>
#include <google/protobuf/util/time_util.h>

#include <chrono>

#include "pongsim/messages/message_schema.hh"
#include "web/foxglove/base64.hh"

namespace pongsim::web::foxglove {

namespace {

std::uint64_t nanoseconds(const HeardLog::Entry& entry) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(entry.time.time_since_epoch()).count());
}

std::string messageOf(const HeardLog::Entry& entry) {
  ::foxglove::Log message;
  *message.mutable_timestamp() =
      google::protobuf::util::TimeUtil::NanosecondsToTimestamp(static_cast<std::int64_t>(nanoseconds(entry)));
  message.set_level(entry.level == LogLevel::kError ? ::foxglove::Log::ERROR : ::foxglove::Log::WARNING);
  message.set_name(entry.speaker);
  message.set_message(entry.message);
  return message.SerializeAsString();
}

}  // namespace

LogOffer::LogOffer(HeardLog& log) {
  offer_.topic = "/foxglove/log";
  offer_.encoding = "protobuf";
  offer_.schemaName = ::foxglove::Log::descriptor()->full_name();
  offer_.schemaEncoding = "protobuf";
  offer_.schema = std::make_shared<const std::string>(base64(messageSchema(*::foxglove::Log::descriptor())));
  offer_.source = this;
  offer_.open = [&log](const std::shared_ptr<Client>& client, std::uint64_t key, const Head& head) {
    return log.watch([client, key, head](const HeardLog::Entry& entry) {
      client->sendData(key, HeardLog::kKept, {head(nanoseconds(entry)), Payload(messageOf(entry))});
    });
  };
}

}  // namespace pongsim::web::foxglove
