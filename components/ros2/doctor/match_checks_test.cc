#include "support/ros2/healthy_robot.hh"

namespace pongsim::ros2 {
namespace {

TEST(DoctorMatchChecks, FindSubscribersThatHearNothing) {
  struct Case {
    const char* type;
    Qos writer;
    Qos reader;
    const char* reason;
    const char* remedy;
  };
  for (const auto& [type, writer, reader, reason, remedy] :
       {Case{"std_msgs/msg/Bool",
             {},
             {},
             "as std_msgs/msg/Bool, but it is published as std_msgs/msg/String",
             "--ros2-topic"},
        Case{"std_msgs/msg/String", kSensorQos, {}, "reliably, but it is published best effort", "sensor_data"},
        Case{"std_msgs/msg/String", {}, kLatchedQos, "transient local", "volatile"}}) {
    Observation seen = test::healthyRobot();
    test::addEndpoint(seen, "/chatter", "std_msgs/msg/String", Graph::Role::kWriter, writer);
    test::addEndpoint(seen, "/chatter", type, Graph::Role::kReader, reader);
    NodeInfo& node = seen.nodes.emplace_back();
    node.nameSpace = "/";
    node.name = "listener";
    node.subscribes = {{"/chatter", type}};
    const Findings findings = checkMatches(seen);
    test::expectOne(findings, Finding::Verdict::kFault, reason, remedy);
    EXPECT_NE(findings.at(0).text.find("(/listener)"), std::string::npos) << findings.at(0).text;
  }
}

TEST(DoctorMatchChecks, FindPromisesThatNobodyMakes) {
  Observation seen = test::healthyRobot();
  test::addEndpoint(seen, "/scan", "sensor_msgs/msg/LaserScan", Graph::Role::kReader);
  seen.endpoints.back().contract.hasDeadline = true;
  test::expectOne(checkMatches(seen), Finding::Verdict::kFault, "deadline", "without deadline");
}

}  // namespace
}  // namespace pongsim::ros2
