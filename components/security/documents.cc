#include "security/documents.hh"

#include <algorithm>

namespace pongsim::security {

namespace {

// Topics of pongsim's transport for discovery and reports of traffic, and that of the graph of ROS 2 nodes.
constexpr std::string_view kEverybodys[] = {"pongsim/census", "pongsim/traffic", "ros_discovery_info"};

constexpr std::string_view kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<dds xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
    "     xsi:noNamespaceSchemaLocation=\"http://www.omg.org/spec/DDS-SECURITY/20170901/";

constexpr std::string_view kDomains =
    "<domains>\n"
    "          <id_range>\n"
    "            <min>0</min>\n"
    "            <max>232</max>\n"
    "          </id_range>\n"
    "        </domains>\n";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char each : text) {
    if (each == '&') {
      result += "&amp;";
    } else if (each == '<') {
      result += "&lt;";
    } else if (each == '>') {
      result += "&gt;";
    } else {
      result += each;
    }
  }
  return result;
}

std::string timeText(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%FT%T", &parts);
  return text;
}

/// "robot" and "*" are short for "/robot" and "/*".
std::string absolute(const std::string& pattern) { return pattern.front() == '/' ? pattern : "/" + pattern; }

struct Topics {
  std::vector<std::string> publish;
  std::vector<std::string> subscribe;
};

/// @return The names of DDS topics for these ROS topics and for pongsim's: ROS adds a prefix, "/odom" is "rt/odom".
Topics topicsOf(const Permissions& permissions) {
  if (permissions.areAll()) return {{"*"}, {"*"}};
  Topics topics;
  for (const std::string_view each : kEverybodys) {
    topics.publish.emplace_back(each);
    topics.subscribe.emplace_back(each);
  }
  const auto addTopics = [](const std::vector<std::string>& from, std::vector<std::string>& to) {
    for (const std::string& pattern : from) {
      to.push_back(absolute(pattern));
      to.push_back("rt" + absolute(pattern));
    }
  };
  addTopics(permissions.publish, topics.publish);
  addTopics(permissions.subscribe, topics.subscribe);
  const auto addServices = [](const std::vector<std::string>& services, std::vector<std::string>& requests,
                              std::vector<std::string>& replies) {
    for (const std::string& pattern : services) {
      requests.push_back("pongsim/request" + absolute(pattern));
      requests.push_back("rq" + absolute(pattern) + "Request");
      replies.push_back("pongsim/reply" + absolute(pattern));
      replies.push_back("rr" + absolute(pattern) + "Reply");
    }
  };
  addServices(permissions.call, topics.publish, topics.subscribe);
  addServices(permissions.offer, topics.subscribe, topics.publish);
  return topics;
}

std::string criteria(const std::string& use, const std::vector<std::string>& topics) {
  std::string text = "        <" + use + ">\n          <topics>\n";
  for (const std::string& each : topics) text += "            <topic>" + escaped(each) + "</topic>\n";
  return text +
         "          </topics>\n"
         "          <partitions>\n"
         "            <partition>*</partition>\n"
         "          </partitions>\n"
         "        </" +
         use + ">\n";
}

}  // namespace

bool isEverybodys(std::string_view topic) { return std::ranges::find(kEverybodys, topic) != std::end(kEverybodys); }

std::string governanceDocument() {
  return std::string(kHead) +
         "omg_shared_ca_governance.xsd\">\n"
         "  <domain_access_rules>\n"
         "    <domain_rule>\n"
         "        " +
         std::string(kDomains) +
         "      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>\n"
         "      <enable_join_access_control>true</enable_join_access_control>\n"
         "      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>\n"
         "      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>\n"
         "      <rtps_protection_kind>ENCRYPT</rtps_protection_kind>\n"
         "      <topic_access_rules>\n"
         "        <topic_rule>\n"
         "          <topic_expression>*</topic_expression>\n"
         "          <enable_discovery_protection>true</enable_discovery_protection>\n"
         "          <enable_liveliness_protection>true</enable_liveliness_protection>\n"
         "          <enable_read_access_control>true</enable_read_access_control>\n"
         "          <enable_write_access_control>true</enable_write_access_control>\n"
         "          <metadata_protection_kind>NONE</metadata_protection_kind>\n"
         "          <data_protection_kind>NONE</data_protection_kind>\n"
         "        </topic_rule>\n"
         "      </topic_access_rules>\n"
         "    </domain_rule>\n"
         "  </domain_access_rules>\n"
         "</dds>\n";
}

std::string permissionsDocument(const std::string& name, std::time_t from, std::time_t until,
                                const Permissions& permissions) {
  const Topics topics = topicsOf(permissions);
  return std::string(kHead) +
         "omg_shared_ca_permissions.xsd\">\n"
         "  <permissions>\n"
         "    <grant name=\"" +
         name + "\">\n      <subject_name>CN=" + name +
         "</subject_name>\n"
         "      <validity>\n"
         "        <not_before>" +
         timeText(from) +
         "</not_before>\n"
         "        <not_after>" +
         timeText(until) +
         "</not_after>\n"
         "      </validity>\n"
         "      <allow_rule>\n"
         "        " +
         std::string(kDomains) + criteria("publish", topics.publish) + criteria("subscribe", topics.subscribe) +
         "      </allow_rule>\n"
         "      <default>DENY</default>\n"
         "    </grant>\n"
         "  </permissions>\n"
         "</dds>\n";
}

}  // namespace pongsim::security
