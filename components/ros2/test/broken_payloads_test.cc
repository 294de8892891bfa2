// Arbitrary payloads, read as each type, are either read or refused, without other effects.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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

/// A value after reading a payload into it.
struct Reading {
  std::optional<std::string> error;
  /// The value, written again.
  std::vector<std::byte> again;
  std::size_t size = 0;
};

/// A type, as data: a body of a test for each type would take a minute to compile.
struct AnyType {
  std::string name;
  std::vector<std::byte> (*blank)();
  std::vector<std::byte> (*filledWith)(double number);
  Reading (*read)(std::span<const std::byte> payload);

  std::vector<std::byte> filled() const { return filledWith(1); }
};

template <class Type>
AnyType anyTypeOf() {
  return {.name = nameOf<Type>(),
          .blank = [] { return toCdr(Type()); },
          .filledWith =
              [](double number) {
                Type value;
                fillWith(number, value);
                return toCdr(value);
              },
          .read =
              [](std::span<const std::byte> payload) {
                Type value;
                std::optional<std::string> error = readCdr(payload, value);
                return Reading{std::move(error), toCdr(value), cdrSize(value)};
              }};
}

const std::vector<AnyType>& allTypes() {
  static const std::vector<AnyType> all = [] {
    std::vector<AnyType> types;
    forAllTypes([&types]<class Type>() { types.push_back(anyTypeOf<Type>()); });
    return types;
  }();
  return all;
}

TEST(BrokenPayloads, AreRefusedWhereverTheyEnd) {
  for (const AnyType& type : allTypes()) {
    for (const std::vector<std::byte>& whole : {type.blank(), type.filled()}) {
      for (std::size_t size = 0; size < whole.size(); ++size) {
        // allocated with the exact size, so that a sanitizer detects reads beyond it
        const std::vector<std::byte> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_TRUE(type.read(part).error.has_value()) << type.name << ", " << size;
      }
      const Reading reading = type.read(whole);
      EXPECT_EQ(reading.error, std::nullopt) << type.name;
      EXPECT_EQ(reading.again, whole) << type.name;
    }
  }
}

TEST(BrokenPayloads, WithTextsThatDoNotEndAreRefused) {
  std::size_t texts = 0;
  for (const AnyType& type : allTypes()) {
    const std::vector<std::byte> whole = type.filled();
    const auto wanted = std::as_bytes(std::span(kText));
    for (auto at = whole.begin();; ++at) {
      at = std::search(at, whole.end(), wanted.begin(), wanted.end());
      if (at == whole.end()) break;
      std::vector<std::byte> payload = whole;
      payload[static_cast<std::size_t>(at - whole.begin()) + kText.size()] = std::byte{'!'};
      const auto error = type.read(payload).error;
      ASSERT_TRUE(error.has_value()) << type.name;
      EXPECT_NE(error->find("a string without an end"), std::string::npos) << *error;
      ++texts;
    }
  }
  EXPECT_GT(texts, 100U);
}

TEST(BrokenPayloads, OfNumbersThatAreNotFiniteAreReadAsTheyAre) {
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    for (const AnyType& type : allTypes()) {
      const std::vector<std::byte> whole = type.filledWith(number);
      const Reading reading = type.read(whole);
      EXPECT_EQ(reading.error, std::nullopt) << type.name;
      EXPECT_EQ(reading.again, whole) << type.name;
    }
  }
}

TEST(BrokenPayloads, OfCommandsThatAreNotFiniteDoNotGetIn) {
  std::set<std::string> refused;
  for (const Pair& pair : allPairs()) {
    const auto type = std::ranges::find(allTypes(), pair.ros, &AnyType::name);
    if (type == allTypes().end()) continue;
    const std::unique_ptr<ToIgnition> read = pair.toIgnition({});
    std::string error;
    // only types that accept a payload of ones
    EXPECT_NE(read->convert(type->filled(), error), nullptr) << pair.ros << ": " << error;
    if (read->convert(type->filledWith(std::numeric_limits<double>::quiet_NaN()), error) == nullptr) {
      EXPECT_EQ(error, "a number in it is not finite") << pair.ros;
      refused.insert(std::string(pair.ros));
    }
  }
  for (const char* command :
       {"geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped", "geometry_msgs/msg/Wrench",
        "geometry_msgs/msg/WrenchStamped", "std_msgs/msg/Float32", "std_msgs/msg/Float64",
        "ros_gz_interfaces/msg/EntityWrench", "trajectory_msgs/msg/JointTrajectory", "actuator_msgs/msg/Actuators"}) {
    EXPECT_TRUE(refused.contains(command)) << command;
  }
}

TEST(BrokenPayloads, ClaimNoMoreMemoryThanTheyHave) {
  for (const AnyType& type : allTypes()) {
    // each number of the payload in turn claims four thousand million
    const std::vector<std::byte> whole = type.filled();
    for (std::size_t at = kEncapsulation; at + 4 <= whole.size(); at += 4) {
      std::vector<std::byte> payload = whole;
      const std::uint32_t many = 4'000'000'000;
      std::memcpy(&payload[at], &many, sizeof many);
      EXPECT_LE(type.read(payload).again.size(), 64 * payload.size()) << type.name;
    }
  }
}

TEST(BrokenPayloads, OfAnyBytesDoNoHarm) {
  std::mt19937 chance(7);
  for (const AnyType& type : allTypes()) {
    for (int i = 0; i < 100; ++i) {
      std::vector<std::byte> payload = somePayload(chance);
      payload.resize(chance() % payload.size());
      for (std::size_t j = chance() % 8; j > 0 && !payload.empty(); --j) {
        payload[chance() % payload.size()] = static_cast<std::byte>(chance());
      }
      // what was read can be written
      const Reading reading = type.read(payload);
      EXPECT_EQ(reading.again.size(), reading.size) << type.name;
    }
  }
}

}  // namespace
}  // namespace pongsim::ros2
