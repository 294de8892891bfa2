#include "msgs/types/described_types.hh"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>
#include <ignition/msgs/twist.pb.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::msgs {
namespace {

namespace protobuf = google::protobuf;

void addWithImports(const protobuf::FileDescriptor& file, protobuf::FileDescriptorSet& set) {
  for (int i = 0; i < file.dependency_count(); ++i) addWithImports(*file.dependency(i), set);
  for (const auto& known : set.file()) {
    if (known.name() == file.name()) return;
  }
  file.CopyTo(set.add_file());
}

class DescribedTypesTest : public testing::Test {
 protected:
  std::filesystem::path twistFile() {
    protobuf::FileDescriptorSet set;
    addWithImports(*ignition::msgs::Twist::descriptor()->file(), set);
    return folder_.write("types", set.SerializeAsString());
  }

  test::TempFolder folder_;
};

TEST_F(DescribedTypesTest, SpeakTheSameBytesAsTheClasses) {
  const DescribedTypes types(twistFile());
  const TypeSource& source = types.source();
  const protobuf::Descriptor* const type = source.pool.FindMessageTypeByName("ignition.msgs.Twist");
  ASSERT_NE(type, nullptr);
  const std::unique_ptr<Message> message(source.factory.GetPrototype(type)->New());
  ASSERT_FALSE(parseMessage("linear: {x: 0.5}, header: {stamp: {sec: 3}}", *message));

  ignition::msgs::Twist twist;
  ASSERT_TRUE(twist.ParseFromString(message->SerializeAsString()));
  EXPECT_EQ(twist.linear().x(), 0.5);
  EXPECT_EQ(twist.header().stamp().sec(), 3);
  EXPECT_EQ(messageText(*message), messageText(twist));
  EXPECT_EQ(messageJson(*message), messageJson(twist));
}

TEST_F(DescribedTypesTest, KnowWhatTheFileHolds) {
  const DescribedTypes types(twistFile());
  EXPECT_EQ(types.source().pool.FindMessageTypeByName("ignition.msgs.LaserScan"), nullptr);
  std::vector<std::string> names;
  types.source().database.FindAllMessageNames(&names);
  EXPECT_EQ(std::count(names.begin(), names.end(), "ignition.msgs.Twist"), 1);
}

TEST_F(DescribedTypesTest, AreNotReadFromWhatIsNoSuchFile) {
  EXPECT_THROW(DescribedTypes(folder_.path() / "missing"), std::runtime_error);
  EXPECT_THROW(DescribedTypes(folder_.write("text", "message Twist {}")), std::runtime_error);
  // the data ends within a file
  std::string half(protobuf::FileDescriptorSet::kFileFieldNumber, '\x0a');
  EXPECT_THROW(DescribedTypes(folder_.write("half", half + "\x7f" + "abc")), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::msgs
