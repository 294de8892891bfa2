#include "pongsim/parameters.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

using std::chrono::milliseconds;

Element elementWith(const std::string& child, const std::string& text) {
  Element element;
  element.name = "plugin";
  element.children.emplace_back();
  element.children.back().name = child;
  element.children.back().text = text;
  return element;
}

/// @return The error message; empty if there is none.
std::string refusalOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    const std::string& hint = error.diagnostic().hint;
    return error.diagnostic().message + (hint.empty() ? "" : " | " + hint);
  }
  return {};
}

TEST(Parameters, MustBeThereWhereTheyAreRequired) {
  EXPECT_EQ(requiredText(elementWith("a", "x"), "a"), "x");
  EXPECT_EQ(refusalOf([] { requiredText(elementWith("a", "x"), "b"); }), "no <b> is given");
  EXPECT_EQ(refusalOf([] { requiredText(elementWith("a", ""), "a"); }), "no <a> is given");
}

TEST(Parameters, NameJointsThatCanBeCommanded) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><model name='m'><link name='l'/>"
      "<joint name='hinge' type='revolute'><parent>world</parent><child>l</child><axis><xyz>0 0 1</xyz></axis></joint>"
      "</model></world></sdf>",
      "world.sdf", {}, diagnostics);
  const Model model = simulation->world().model("m").value();
  EXPECT_EQ(requiredJoint(elementWith("j", "hinge"), "j", model).name(), "hinge");
  EXPECT_EQ(refusalOf([&] { requiredJoint(elementWith("j", "knee"), "j", model); }),
            "<j> 'knee' is not a joint of model 'm' | its joints are hinge");
}

TEST(Parameters, NameLinks) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><model name='m'><link name='body'/><link name='tip'/></model></world></sdf>",
      "world.sdf", {}, diagnostics);
  const Model model = simulation->world().model("m").value();
  EXPECT_EQ(requiredLink(elementWith("l", "tip"), "l", model).name(), "tip");
  EXPECT_EQ(refusalOf([&] { requiredLink(elementWith("l", "top"), "l", model); }),
            "<l> 'top' is not a link of model 'm' | its links are body, tip");
  EXPECT_EQ(refusalOf([&] { requiredLink(elementWith("k", "top"), "l", model); }), "no <l> is given");
}

TEST(Parameters, SayHowAValueIsFalsified) {
  EXPECT_EQ(noiseIn(elementWith("a", "x")), NoiseSettings());
  Element holder = elementWith("noise", "");
  Element& noise = holder.children[0];
  noise.attributes.push_back({"type", "gaussian_quantized", {}});
  double value = 0;
  for (const char* name : {"mean", "stddev", "bias_mean", "bias_stddev", "dynamic_bias_stddev",
                           "dynamic_bias_correlation_time", "precision"}) {
    noise.children.emplace_back().name = name;
    noise.children.back().text = std::to_string(++value);
  }
  EXPECT_EQ(noiseIn(holder), (NoiseSettings{NoiseSettings::Type::kGaussianQuantized, 1, 2, 3, 4, 5, 6, 7}));
  noise.children[1].text = "-2";
  EXPECT_EQ(refusalOf([&] { noiseIn(holder); }), "<stddev> must be zero or more");
  noise.children[0].text = "inf";
  EXPECT_EQ(refusalOf([&] { noiseIn(holder); }), "<mean> must be a finite number");
  noise.attributes[0].value = "gauss";
  EXPECT_EQ(refusalOf([&] { noiseIn(holder); }),
            "<noise> has the unknown type 'gauss' | it can be none, gaussian or gaussian_quantized");
}

TEST(Parameters, ReadTheTypeOfANoiseAlsoFromAnElement) {
  Element holder = elementWith("noise", "");
  holder.children[0].children.emplace_back().name = "type";
  holder.children[0].children.back().text = "gaussian";
  EXPECT_EQ(noiseIn(holder).type, NoiseSettings::Type::kGaussian);
}

TEST(Parameters, NameSeveralJoints) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><model name='m'><link name='l'/>"
      "<joint name='hinge' type='revolute'><parent>world</parent><child>l</child><axis><xyz>0 0 1</xyz></axis></joint>"
      "</model></world></sdf>",
      "world.sdf", {}, diagnostics);
  const Model model = simulation->world().model("m").value();
  EXPECT_EQ(requiredJoints(elementWith("j", "hinge"), "j", model).size(), 1U);
  EXPECT_EQ(refusalOf([&] { requiredJoints(elementWith("i", "hinge"), "j", model); }), "no <j> is given");
}

TEST(Parameters, GiveTopicsAndPeriods) {
  EXPECT_EQ(topicOr("my topic", "/x"), "my_topic");
  EXPECT_EQ(topicOr("", "/a b"), "/a_b");
  EXPECT_EQ(periodOf(50), milliseconds(20));
  EXPECT_EQ(periodOf(-1), Time::zero());
}

TEST(Schedule, KeepsToAGrid) {
  Schedule schedule(milliseconds(10));
  EXPECT_TRUE(schedule.isDue(milliseconds(1)));
  EXPECT_FALSE(schedule.isDue(milliseconds(9)));
  EXPECT_TRUE(schedule.isDue(milliseconds(12)));
  EXPECT_FALSE(schedule.isDue(milliseconds(19)));
  EXPECT_TRUE(schedule.isDue(milliseconds(20)));
  schedule.reset();
  EXPECT_TRUE(schedule.isDue(milliseconds(1)));
}

TEST(Schedule, OfNoPeriodIsDueAtOnceEachTime) {
  Schedule schedule;
  EXPECT_TRUE(schedule.isDue(milliseconds(1)));
  EXPECT_TRUE(schedule.isDue(milliseconds(1)));
}

}  // namespace
}  // namespace pongsim
