// Arbitrary payloads, read as each type, are either read or refused, without other effects.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/pairs/pairs.hh"
#include "ros2/test/all_types.hh"
#include "ros2/types/cdr.hh"

namespace pongsim::ros2 {
namespace {

constexpr std::size_t kEncapsulation = 4;

/// A payload of small numbers, so that counts of elements are often plausible.
std::vector<std::byte> somePayload(std::mt19937& chance) {
  std::vector<std::byte> payload(kEncapsulation + 400);
  payload[1] = std::byte{1};
  for (std::size_t i = kEncapsulation; i < payload.size(); i += 4) payload[i] = static_cast<std::byte>(chance() % 3);
  return payload;
}

constexpr std::string_view kText = "text";

/// Fills all fields: lists get two elements if possible, texts `kText`.
/// @param number Value of floating-point numbers.
template <class Value>
void fillWith(double number, Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    value = static_cast<Value>(number);
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = true;
  } else if constexpr (Primitive<Value>) {
    value = static_cast<Value>(1);
  } else if constexpr (Text<Value>) {
    value = std::string(kText);
  } else if constexpr (Structure<Value>) {
    visitFields(value, [number](const char*, auto& field) { fillWith(number, field); });
  } else if constexpr (std::is_same_v<Value, std::vector<bool>>) {
    value = {true, false};
  } else {
    if constexpr (List<Value>) value.resize(kBoundOf<Value> == 1 ? 1 : 2);
    for (auto& element : value) fillWith(number, element);
  }
}

template <class Type>
std::vector<std::byte> filled(double number = 1) {
  Type value;
  fillWith(number, value);
  return toCdr(value);
}

TEST(BrokenPayloads, AreRefusedWhereverTheyEnd) {
  forAllTypes([]<class Type>() {
    for (const std::vector<std::byte>& whole : {toCdr(Type()), filled<Type>()}) {
      for (std::size_t size = 0; size < whole.size(); ++size) {
        // allocated with the exact size, so that a sanitizer detects reads beyond it
        const std::vector<std::byte> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        Type value;
        EXPECT_TRUE(readCdr(part, value).has_value()) << nameOf<Type>() << ", " << size;
      }
      Type value;
      EXPECT_EQ(readCdr(whole, value), std::nullopt) << nameOf<Type>();
      EXPECT_EQ(toCdr(value), whole) << nameOf<Type>();
    }
  });
}

TEST(BrokenPayloads, WithTextsThatDoNotEndAreRefused) {
  std::size_t texts = 0;
  forAllTypes([&texts]<class Type>() {
    const std::vector<std::byte> whole = filled<Type>();
    const auto wanted = std::as_bytes(std::span(kText));
    for (auto at = whole.begin();; ++at) {
      at = std::search(at, whole.end(), wanted.begin(), wanted.end());
      if (at == whole.end()) break;
      std::vector<std::byte> payload = whole;
      payload[static_cast<std::size_t>(at - whole.begin()) + kText.size()] = std::byte{'!'};
      Type value;
      const auto error = readCdr(payload, value);
      ASSERT_TRUE(error.has_value()) << nameOf<Type>();
      EXPECT_NE(error->find("a string without an end"), std::string::npos) << *error;
      ++texts;
    }
  });
  EXPECT_GT(texts, 100U);
}

TEST(BrokenPayloads, OfNumbersThatAreNotFiniteAreReadAsTheyAre) {
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    forAllTypes([number]<class Type>() {
      const std::vector<std::byte> whole = filled<Type>(number);
      Type value;
      EXPECT_EQ(readCdr(whole, value), std::nullopt) << nameOf<Type>();
      EXPECT_EQ(toCdr(value), whole) << nameOf<Type>();
    });
  }
}

TEST(BrokenPayloads, OfCommandsThatAreNotFiniteDoNotGetIn) {
  std::set<std::string> refused;
  for (const Pair& pair : allPairs()) {
    Messages::forEach([&]<class Type>() {
      if (nameOf<Type>() != pair.ros) return;
      const ToIgnition read = pair.toIgnition({});
      std::string error;
      // only types that accept a payload of ones
      EXPECT_NE(read(filled<Type>(), error), nullptr) << pair.ros << ": " << error;
      if (read(filled<Type>(std::numeric_limits<double>::quiet_NaN()), error) == nullptr) {
        EXPECT_EQ(error, "a number in it is not finite") << pair.ros;
        refused.insert(std::string(pair.ros));
      }
    });
  }
  for (const char* command :
       {"geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped", "geometry_msgs/msg/Wrench",
        "geometry_msgs/msg/WrenchStamped", "std_msgs/msg/Float32", "std_msgs/msg/Float64",
        "ros_gz_interfaces/msg/EntityWrench", "trajectory_msgs/msg/JointTrajectory", "actuator_msgs/msg/Actuators"}) {
    EXPECT_TRUE(refused.contains(command)) << command;
  }
}

TEST(BrokenPayloads, ClaimNoMoreMemoryThanTheyHave) {
  forAllTypes([]<class Type>() {
    // each number of the payload in turn claims four thousand million
    const std::vector<std::byte> whole = filled<Type>();
    for (std::size_t at = kEncapsulation; at + 4 <= whole.size(); at += 4) {
      std::vector<std::byte> payload = whole;
      const std::uint32_t many = 4'000'000'000;
      std::memcpy(&payload[at], &many, sizeof many);
      Type value;
      readCdr(payload, value);
      EXPECT_LE(toCdr(value).size(), 64 * payload.size()) << nameOf<Type>();
    }
  });
}

TEST(BrokenPayloads, OfAnyBytesDoNoHarm) {
  std::mt19937 chance(7);
  forAllTypes([&chance]<class Type>() {
    for (int i = 0; i < 100; ++i) {
      std::vector<std::byte> payload = somePayload(chance);
      payload.resize(chance() % payload.size());
      for (std::size_t j = chance() % 8; j > 0 && !payload.empty(); --j) {
        payload[chance() % payload.size()] = static_cast<std::byte>(chance());
      }
      Type value;
      if (!readCdr(payload, value)) {
        // what was read can be written
        EXPECT_EQ(toCdr(value).size(), cdrSize(value));
      }
    }
  });
}

}  // namespace
}  // namespace pongsim::ros2
