// Reads a log with Debian's own log library, without pongsim, and prints each topic with its type and the number of its
// messages.
#include <cstdio>
#include <map>
#include <string>
#include <utility>

#include <ignition/transport/log/Log.hh>

int main(int count, char** words) {
  ignition::transport::log::Log log;
  if (count != 2 || !log.Open(words[1])) return 1;
  std::map<std::pair<std::string, std::string>, int> topics;
  ignition::transport::log::Batch batch = log.QueryMessages();
  for (const ignition::transport::log::Message& message : batch) ++topics[{message.Topic(), message.Type()}];
  for (const auto& [topic, messages] : topics) {
    std::printf("%s %s %d\n", topic.first.c_str(), topic.second.c_str(), messages);
  }
  return 0;
}
