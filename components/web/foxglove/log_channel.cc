#include "web/foxglove/log_channel.hh"

#include <foxglove/log.pb.h>
#include <google/protobuf/util/time_util.h>

#include <chrono>

#include "pongsim/messages/message_schema.hh"
#include "web/foxglove/base64.hh"

namespace pongsim::web::foxglove {

namespace {

std::uint64_t nanoseconds(const RecentLog::Line& line) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(line.time.time_since_epoch()).count());
}

std::string messageOf(const RecentLog::Line& line) {
  ::foxglove::Log message;
  *message.mutable_timestamp() =
      google::protobuf::util::TimeUtil::NanosecondsToTimestamp(static_cast<std::int64_t>(nanoseconds(line)));
  message.set_level(line.level == LogLevel::kError ? ::foxglove::Log::ERROR : ::foxglove::Log::WARNING);
  message.set_name(line.speaker);
  message.set_message(line.message);
  return message.SerializeAsString();
}

}  // namespace

LogChannel::LogChannel(RecentLog& log) {
  const google::protobuf::Descriptor& type = *::foxglove::Log::descriptor();
  channel_ = protobufChannel("/foxglove/log", type.full_name(),
                             std::make_shared<const std::string>(base64(messageSchema(type))), this);
  channel_.open = [&log](const std::shared_ptr<Client>& client, std::uint64_t key, const Head& head) {
    return log.watch([client, key, head](const RecentLog::Line& line) {
      client->sendData(key, RecentLog::kKept, {head(nanoseconds(line)), Payload(messageOf(line))});
    });
  };
}

}  // namespace pongsim::web::foxglove
