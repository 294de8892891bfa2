#include "ros2/types/type_description.hh"

#include <gtest/gtest.h>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2 {
namespace {

struct Described {
  static constexpr const char* kName = "test_msgs/msg/Described";
  std::array<double, 9> array{};
  BoundedList<BoundedString<5>, 4> words;
  std::vector<bool> flags;
  BulkBytes bytes;
  std::int8_t small = 0;
  geometry_msgs::Vector3 inner;
  static void visit(auto& self, auto&& field) {
    field("array", self.array);
    field("words", self.words);
    field("flags", self.flags);
    field("bytes", self.bytes);
    field("small", self.small);
    field("inner", self.inner);
  }
};

TEST(TypeDescription, HasTheFieldsInTheirOrder) {
  const TypeDescription type = typeDescription<Described>();
  EXPECT_EQ(type.name, "test_msgs/msg/Described");
  ASSERT_EQ(type.fields.size(), 6U);
  const auto expect = [&type](std::size_t i, std::string_view name, FieldType::Id id, FieldType::List list,
                              std::size_t capacity, std::size_t stringCapacity) {
    const auto& [fieldName, field] = type.fields[i];
    EXPECT_EQ(fieldName, name);
    EXPECT_EQ(field.id, id) << name;
    EXPECT_EQ(field.list, list) << name;
    EXPECT_EQ(field.capacity, capacity) << name;
    EXPECT_EQ(field.stringCapacity, stringCapacity) << name;
  };
  expect(0, "array", FieldType::kDouble, FieldType::kArray, 9, 0);
  expect(1, "words", FieldType::kBoundedString, FieldType::kBoundedList, 4, 5);
  expect(2, "flags", FieldType::kBoolean, FieldType::kUnboundedList, 0, 0);
  expect(3, "bytes", FieldType::kUint8, FieldType::kUnboundedList, 0, 0);
  expect(4, "small", FieldType::kInt8, FieldType::kNoList, 0, 0);
  expect(5, "inner", FieldType::kNested, FieldType::kNoList, 0, 0);
}

TEST(TypeDescription, LeadsToTheStructuresInAType) {
  const TypeDescription type = typeDescription<Described>();
  EXPECT_EQ(type.fields.at(4).type.nested, nullptr);
  ASSERT_NE(type.fields.at(5).type.nested, nullptr);
  const TypeDescription inner = type.fields.at(5).type.nested();
  EXPECT_EQ(inner.name, "geometry_msgs/msg/Vector3");
  EXPECT_EQ(inner.fields.size(), 3U);
}

TEST(TypeDescription, OfATypeWithoutFieldsHasNone) { EXPECT_TRUE(typeDescription<std_msgs::Empty>().fields.empty()); }

}  // namespace
}  // namespace pongsim::ros2
