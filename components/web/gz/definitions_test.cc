#include "web/gz/definitions.hh"

#include <google/protobuf/compiler/parser.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <gtest/gtest.h>

namespace pongsim::web::gz {
namespace {

TEST(Definitions, AreOneFileThatDescribesAllTypes) {
  const std::string text = definitions();
  google::protobuf::io::ArrayInputStream stream(text.data(), static_cast<int>(text.size()));
  google::protobuf::io::Tokenizer tokenizer(&stream, nullptr);
  google::protobuf::FileDescriptorProto file;
  ASSERT_TRUE(google::protobuf::compiler::Parser().Parse(&tokenizer, &file));
  file.set_name("all.proto");
  google::protobuf::DescriptorPool pool;
  ASSERT_NE(pool.BuildFile(file), nullptr);
  for (const char* type : {"ignition.msgs.Scene", "ignition.msgs.EntityWrench", "ignition.msgs.Bytes"}) {
    EXPECT_NE(pool.FindMessageTypeByName(type), nullptr) << type;
  }
  EXPECT_NE(pool.FindEnumTypeByName("ignition.msgs.PixelFormatType"), nullptr);
}

}  // namespace
}  // namespace pongsim::web::gz
