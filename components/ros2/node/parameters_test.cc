#include "ros2/node/parameters.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <future>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

using rcl_interfaces::FloatingPointRange;
using rcl_interfaces::IntegerRange;
using rcl_interfaces::Parameter;
using rcl_interfaces::ParameterEvent;
using rcl_interfaces::SetParametersResult;
namespace srv = rcl_interfaces::srv;
using Names = std::vector<std::string>;

class ParametersTest : public testing::Test {
 protected:
  ParametersTest() {
    Parameters::Descriptor time = named("use_sim_time"), factor = named("factor"), rate = named("camera.rate");
    time.description = "always";
    parameters_.declare(time, parameterOf(true));
    factor.floating_point_range = std::vector{FloatingPointRange{0, 10, 0.5}};
    parameters_.declare(factor, parameterOf(1.0), keep(factor_));
    rate.integer_range = std::vector{IntegerRange{1, 100, 3}};
    parameters_.declare(rate, parameterOf(std::int64_t{1}),
                        [this](const Parameters::Value& value) -> std::optional<std::string> {
                          if (value.integer_value == 13) return "thirteen is none";
                          rate_ = value.integer_value;
                          return std::nullopt;
                        });
    parameters_.declare(named("camera.lens.name"), parameterOf(std::string("wide")),
                        [](const Parameters::Value&) { return std::nullopt; });
  }

  static Parameters::Descriptor named(const std::string& name) {
    Parameters::Descriptor descriptor;
    descriptor.name = name;
    return descriptor;
  }
  static Parameters::Setter keep(double& to) {
    return [&to](const Parameters::Value& value) {
      to = value.double_value;
      return std::nullopt;
    };
  }

  SetParametersResult set(const std::string& name, const Parameters::Value& value) {
    return parameters_.set({{name, value}}).at(0);
  }

  /// Dispatches the node's mailbox until the condition holds.
  bool dispatchUntil(const std::function<bool()>& condition) {
    return test::waitUntil([&] {
      node_.mailbox().dispatch();
      return condition();
    });
  }

  template <class Service>
  std::optional<typename Service::Response> call(const std::string& service, const typename Service::Request& request) {
    auto answer = std::async(std::launch::async,
                             [&] { return RosClient<Service>(peer_, service).call(request, test::kDeadline); });
    dispatchUntil([&] { return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready; });
    return answer.get();
  }

  const int domain_ = test::testDomain();
  double factor_ = 1;
  std::int64_t rate_ = 1;
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {.nameSpace = "/robot"}};
  Parameters parameters_{node_, [] { return builtin_interfaces::Time{7, 8}; }};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
};

TEST_F(ParametersTest, AreSetWhereTypeAndRangeAllowIt) {
  EXPECT_EQ(set("factor", parameterOf(2.5)), (SetParametersResult{true, ""}));
  EXPECT_EQ(factor_, 2.5);
  EXPECT_EQ(parameters_.get({"factor"}).at(0), parameterOf(2.5));
  EXPECT_TRUE(set("camera.rate", parameterOf(std::int64_t{100})).successful);
  EXPECT_TRUE(set("camera.rate", parameterOf(std::int64_t{4})).successful);
  EXPECT_EQ(rate_, 4);
}

TEST_F(ParametersTest, AreRefusedInTheWordsOfRclcpp) {
  EXPECT_EQ(set("use_sim_time", parameterOf(false)).reason,
            "parameter 'use_sim_time' cannot be set because it is read-only");
  EXPECT_EQ(set("speed", parameterOf(1.0)).reason, "parameter 'speed' cannot be set because it was not declared");
  EXPECT_EQ(set("factor", parameterOf(std::int64_t{1})).reason,
            "Wrong parameter type, parameter {factor} is of type {double}, setting it to {integer} is not allowed.");
  EXPECT_EQ(set("factor", {}).reason,
            "Wrong parameter type, parameter {factor} is of type {double}, setting it to {not set} is not allowed.");
  Parameters::Value strange;
  strange.type = 200;
  EXPECT_EQ(set("factor", strange).reason,
            "Wrong parameter type, parameter {factor} is of type {double}, setting it to {unknown type} is not "
            "allowed.");
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double value : {-0.5, 10.5, 0.7, nan, infinity}) {
    EXPECT_EQ(set("factor", parameterOf(value)).reason, "Parameter {factor} doesn't comply with floating point range.");
  }
  const std::int64_t least = std::numeric_limits<std::int64_t>::min(), most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{3}, std::int64_t{101}, least, most}) {
    EXPECT_EQ(set("camera.rate", parameterOf(value)).reason,
              "Parameter {camera.rate} doesn't comply with integer range.");
  }
  EXPECT_EQ(set("camera.rate", parameterOf(std::int64_t{13})).reason, "thirteen is none");
  EXPECT_EQ(factor_, 1);
  EXPECT_EQ(rate_, 1);
}

TEST_F(ParametersTest, OfSeveralThoseThatCanBeAreSet) {
  const auto results =
      parameters_.set({{"factor", parameterOf(2.0)}, {"nobody", parameterOf(2.0)}, {"factor", parameterOf(3.0)}});
  ASSERT_EQ(results.size(), 3);
  EXPECT_TRUE(results[0].successful && !results[1].successful && results[2].successful);
  EXPECT_EQ(factor_, 3);
}

TEST_F(ParametersTest, AtomicallyAllAreSetOrNone) {
  EXPECT_TRUE(parameters_.setAtomically({{"factor", parameterOf(2.0)}, {"camera.rate", parameterOf(std::int64_t{4})}})
                  .successful);
  EXPECT_EQ(factor_, 2);
  // an error in the second one is found before the first is set, or only when it is set
  for (const std::int64_t rate : {0, 13}) {
    const auto result = parameters_.setAtomically({{"factor", parameterOf(5.0)}, {"camera.rate", parameterOf(rate)}});
    EXPECT_FALSE(result.successful);
    EXPECT_FALSE(result.reason.empty());
    EXPECT_EQ(factor_, 2);
    EXPECT_EQ(parameters_.get({"factor"}).at(0), parameterOf(2.0));
    EXPECT_EQ(rate_, 4);
  }
  EXPECT_EQ(parameters_.setAtomically({{"factor", parameterOf(5.0)}, {"nobody", parameterOf(true)}}).reason,
            "One or more parameters were not declared before setting");
}

TEST_F(ParametersTest, WhereOneIsNotThereNothingIsTold) {
  EXPECT_EQ(parameters_.types({"use_sim_time", "factor", "camera.rate"}), (std::vector<std::uint8_t>{1, 3, 2}));
  EXPECT_TRUE(parameters_.get({"factor", "nobody"}).empty());
  EXPECT_TRUE(parameters_.types({"nobody"}).empty());
  EXPECT_TRUE(parameters_.describe({"nobody"}).empty());
}

TEST_F(ParametersTest, AreDescribed) {
  const auto all = parameters_.describe({"use_sim_time", "factor"});
  ASSERT_EQ(all.size(), 2);
  EXPECT_EQ(all[0].description, "always");
  EXPECT_TRUE(all[0].read_only);
  EXPECT_EQ(all[0].type, rcl_interfaces::ParameterType::kParameterBool);
  EXPECT_FALSE(all[1].read_only);
  EXPECT_EQ(all[1].floating_point_range.at(0).to_value, 10);
}

TEST_F(ParametersTest, AreListedByPrefixAndDepth) {
  const auto all = parameters_.list({}, 0);
  EXPECT_EQ(all.names, (Names{"camera.lens.name", "camera.rate", "factor", "use_sim_time"}));
  EXPECT_EQ(all.prefixes, (Names{"camera.lens", "camera"}));
  EXPECT_EQ(parameters_.list({}, 1).names, (Names{"factor", "use_sim_time"}));
  EXPECT_EQ(parameters_.list({}, 2).names, (Names{"camera.rate", "factor", "use_sim_time"}));
  EXPECT_EQ(parameters_.list({"camera"}, 0).names, (Names{"camera.lens.name", "camera.rate"}));
  EXPECT_EQ(parameters_.list({"camera"}, 1).names, (Names{"camera.rate"}));
  EXPECT_EQ(parameters_.list({"camera"}, 2).names, (Names{"camera.lens.name", "camera.rate"}));
  EXPECT_EQ(parameters_.list({"factor", "cam"}, 0).names, (Names{"factor"}));
}

TEST_F(ParametersTest, ABadDeclarationIsRefused) {
  EXPECT_THROW(parameters_.declare(named("factor"), parameterOf(true)), std::invalid_argument);
  EXPECT_THROW(parameters_.declare(named(""), parameterOf(true)), std::invalid_argument);
  EXPECT_THROW(parameters_.declare(named("x"), {}), std::invalid_argument);
  EXPECT_THROW(parameters_.update("factor", parameterOf(true)), std::invalid_argument);
  EXPECT_THROW(parameters_.update("nobody", parameterOf(true)), std::invalid_argument);
}

TEST_F(ParametersTest, ServicesAnswerOtherNodes) {
  const auto listed = call<srv::ListParameters>("/robot/pongsim/list_parameters", {});
  ASSERT_TRUE(listed.has_value());
  EXPECT_EQ(listed->result.names.size(), 4);
  const auto set = call<srv::SetParameters>("/robot/pongsim/set_parameters", {{{"factor", parameterOf(4.0)}}});
  ASSERT_TRUE(set.has_value() && set->results.size() == 1);
  EXPECT_TRUE(set->results[0].successful);
  const auto atOnce =
      call<srv::SetParametersAtomically>("/robot/pongsim/set_parameters_atomically", {{{"x", parameterOf(4.0)}}});
  ASSERT_TRUE(atOnce.has_value());
  EXPECT_FALSE(atOnce->result.successful);
  const auto values = call<srv::GetParameters>("/robot/pongsim/get_parameters", {{"factor"}});
  ASSERT_TRUE(values.has_value() && values->values.size() == 1);
  EXPECT_EQ(values->values[0], parameterOf(4.0));
  const auto types = call<srv::GetParameterTypes>("/robot/pongsim/get_parameter_types", {{"factor"}});
  ASSERT_TRUE(types.has_value());
  EXPECT_EQ(types->types, (std::vector<std::uint8_t>{3}));
  const auto described = call<srv::DescribeParameters>("/robot/pongsim/describe_parameters", {{"factor"}});
  ASSERT_TRUE(described.has_value() && described->descriptors.size() == 1);
  EXPECT_EQ(described->descriptors[0].name, "factor");
}

TEST_F(ParametersTest, EventsTellOfEachChange) {
  std::mutex mutex;
  std::vector<ParameterEvent> heard;
  const auto subscription = peer_.subscribe<ParameterEvent>("/parameter_events",
                                                            [&](const ParameterEvent& event) {
                                                              const std::lock_guard lock(mutex);
                                                              heard.push_back(event);
                                                            },
                                                            {.depth = 1000});
  // nothing is published until the reader is discovered
  ASSERT_TRUE(dispatchUntil([&] {
    parameters_.update("factor", parameterOf(factor_ += 0.5));
    const std::lock_guard lock(mutex);
    return !heard.empty();
  }));
  parameters_.update("factor", parameterOf(factor_));
  set("factor", parameterOf(true));
  set("factor", parameterOf(9.0));
  set("factor", parameterOf(-1.0));
  parameters_.declare(named("late"), parameterOf(true));
  ASSERT_TRUE(dispatchUntil([&] {
    const std::lock_guard lock(mutex);
    return !heard.back().new_parameters.empty();
  }));
  const ParameterEvent &changed = heard[heard.size() - 2], &added = heard.back();
  EXPECT_EQ(changed.node, "/robot/pongsim");
  EXPECT_EQ(changed.stamp, (builtin_interfaces::Time{7, 8}));
  EXPECT_EQ(changed.changed_parameters, (std::vector<Parameter>{{"factor", parameterOf(9.0)}}));
  EXPECT_EQ(added.new_parameters, (std::vector<Parameter>{{"late", parameterOf(true)}}));
}

TEST_F(ParametersTest, AddsUndeclaredOnesWhereThatIsAllowed) {
  parameters_.allowUndeclared();
  EXPECT_TRUE(parameters_.set({{"drive.type", parameterOf(std::string("a"))}})[0].successful);
  EXPECT_EQ(parameters_.get({"drive.type"})[0].string_value, "a");
  // of any type, unlike those that are declared
  EXPECT_TRUE(parameters_.setAtomically({{"drive.type", parameterOf(2.0)}, {"other", parameterOf(true)}}).successful);
  EXPECT_EQ(parameters_.get({"drive.type"})[0].double_value, 2);
  EXPECT_FALSE(parameters_.set({{"factor", parameterOf(true)}})[0].successful);
  EXPECT_FALSE(parameters_.set({{"", parameterOf(true)}})[0].successful);
}

}  // namespace
}  // namespace pongsim::ros2
