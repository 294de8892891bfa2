#include "assets/meshes/gltf_check.hh"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/assets/mesh_support.hh"

namespace pongsim::assets {
namespace {

std::string faultOf(std::string_view content) {
  try {
    checkGltf(content);
    return "none";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string binary(const std::string& json, std::uint32_t claimed) {
  std::string file = "glTF";
  for (const std::uint32_t number : {2U, 0U, claimed})
    for (unsigned i = 0; i < 4; ++i) file += static_cast<char>(number >> (8 * i) & 0xffU);
  return file + "JSON" + json;
}

TEST(GltfCheck, AcceptsAFileOfBothKinds) {
  EXPECT_EQ(faultOf(test::glb()), "none");
  EXPECT_EQ(faultOf(R"({"nodes": [{"children": [1, 2]}, {}, {"children": [3]}, {}]})"), "none");
  EXPECT_EQ(faultOf(R"({"nodes": {"a": {"children": ["b"]}, "b": {}}})"), "none");
}

TEST(GltfCheck, RefusesAChunkThatIsLargerThanTheFile) {
  EXPECT_EQ(faultOf(binary("{}", 2)), "none");
  EXPECT_EQ(faultOf(binary("{}", 0xfffffff0)), "a chunk claims 4294967280 bytes, where the file has 2");
}

TEST(GltfCheck, RefusesAmountsThatNoFileHas) {
  EXPECT_EQ(faultOf(R"({"buffers": [{"byteLength": 4000000000}]})"),
            "byteLength 4000000000 in buffers is not a number from 0 to 268435456");
  EXPECT_EQ(faultOf(R"({"accessors": [{"count": -1}]})"), "count -1 in accessors is not a number from 0 to 6000000");
  EXPECT_EQ(faultOf(R"({"accessors": [{"count": 1e30}]})"),
            "count 1e+30 in accessors is not a number from 0 to 6000000");
}

TEST(GltfCheck, RefusesNodesThatAreNestedEndlesslyOrTooDeeply) {
  EXPECT_EQ(faultOf(R"({"nodes": [{"children": [0]}]})"), "node 0 is nested more than 500 nodes deep, or in itself");
  EXPECT_EQ(faultOf(R"({"nodes": [{"children": [1]}, {"children": [0]}]})"),
            "node 0 is nested more than 500 nodes deep, or in itself");
  EXPECT_EQ(faultOf(R"({"nodes": [{"children": [2]}, {"children": [2]}, {}]})"), "node 2 has two parents");
  const auto chain = [](int length) {
    std::string nodes;
    for (int i = 1; i < length; ++i) nodes += "{\"children\": [" + std::to_string(i) + "]},";
    return "{\"nodes\": [" + nodes + "{}]}";
  };
  EXPECT_EQ(faultOf(chain(501)), "none");
  EXPECT_NE(faultOf(chain(20'000)).find("is nested more than 500 nodes deep"), std::string::npos);
}

TEST(GltfCheck, RefusesJsonThatIsBrokenOrNestedTooDeeply) {
  EXPECT_EQ(faultOf("{"), "its JSON is not well-formed at byte 2");
  EXPECT_EQ(faultOf("[]"), "its JSON is no object");
  EXPECT_EQ(faultOf("{\"extras\":" + std::string(100'000, '[')), "its JSON is nested too deeply");
}

}  // namespace
}  // namespace pongsim::assets
