#include "msgs/types/definition.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::msgs {
namespace {

TEST(Definition, IsThatOfProtobuf) {
  EXPECT_EQ(definition("gz.msgs.Boolean"),
            "message Boolean {\n  .ignition.msgs.Header header = 1;\n  bool data = 2;\n}\n");
}

TEST(Definition, IsNotThereForAnUnknownType) { EXPECT_EQ(definition("Boolan"), std::nullopt); }

TEST(Definition, HasTheCommentsOfTheFile) {
  namespace pb = google::protobuf;
  pb::FileDescriptorSet set;
  for (const pb::FileDescriptor* file :
       {ignition::msgs::Time::descriptor()->file(), ignition::msgs::Header::descriptor()->file(),
        ignition::msgs::Boolean::descriptor()->file()}) {
    file->CopyTo(set.add_file());
  }
  pb::SourceCodeInfo& info = *set.mutable_file(2)->mutable_source_code_info();
  // of the import, of the type and of its second field
  const auto comment = [&info](const std::vector<int>& path, const std::string& text) {
    pb::SourceCodeInfo::Location& location = *info.add_location();
    for (const int step : path) location.add_path(step);
    for (int i = 0; i < 4; ++i) location.add_span(0);
    location.set_leading_comments(text);
  };
  comment({3, 0}, "/ \\ingroup ignition.msgs\n/ \\interface Boolean\n/ \\brief True\n/ or false.\n");
  comment({4, 0}, "");
  comment({4, 0, 2, 1}, "/ \\brief Which of the two\n");
  const test::TempFolder folder;
  const std::filesystem::path file = folder.write("comments", set.SerializeAsString());
  EXPECT_EQ(definition("Boolean", file),
            "// True\n// or false.\nmessage Boolean {\n  .ignition.msgs.Header header = 1;\n"
            "  // Which of the two\n  bool data = 2;\n}\n");
  EXPECT_EQ(definition("Twist", file), definition("Twist")) << "it is not in the file";
  EXPECT_EQ(definition("Boolean", folder.write("broken", "\xff")), definition("Boolean"));
  EXPECT_EQ(definition("Boolean", "/no/such/file"), definition("Boolean"));
}

}  // namespace
}  // namespace pongsim::msgs
