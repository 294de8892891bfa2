#include "sdf/schema/schema.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "sdf/text/document.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Schema, HoldsEachPathOnceAndResolvesAllReferences) {
  std::set<std::string_view> paths;
  EXPECT_EQ(schemaTable().size(), 956U);
  for (const SchemaRow& row : schemaTable()) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_NE(std::string_view("01*+").find(row.presence.value), std::string_view::npos) << row.path;
    EXPECT_TRUE(row.since >= 0 && row.since <= 12) << row.path;
    EXPECT_TRUE(row.removedIn == 0 || row.removedIn > row.since) << row.path;
  }
  for (const std::string_view path : paths) {
    const std::size_t mark = path.find_last_of(".@");
    EXPECT_TRUE(mark == path.npos || paths.contains(path.substr(0, mark))) << path;
  }
  for (const SchemaRow& row : schemaTable()) {
    EXPECT_TRUE(!row.type.starts_with('+') || paths.contains(row.type.substr(1))) << row.path;
  }
}

TEST(Schema, PartsSayWhatTheirReferenceSays) {
  const Schema::Part* joint = Schema::instance().shared("joint");
  ASSERT_NE(joint, nullptr);
  const Schema::Part* pose = Schema::find(joint->type->children, "pose");
  ASSERT_NE(pose, nullptr);
  EXPECT_EQ(pose->row.type, "pose");
  EXPECT_EQ(pose->row.fallback.value, "0 0 0 0 0 0");
  EXPECT_NE(Schema::find(pose->type->attributes, "relative_to"), nullptr);
  const Schema::Part* axis = Schema::find(joint->type->children, "axis");
  ASSERT_NE(axis, nullptr);
  const Schema::Part* old = Schema::find(axis->type->children, "use_parent_model_frame");
  ASSERT_NE(old, nullptr);
  EXPECT_EQ(old->row.since, 5);
  EXPECT_EQ(old->row.removedIn, 7);
  EXPECT_TRUE(Schema::instance().shared("plugin")->isFreeForm);
  EXPECT_EQ(Schema::find(joint->type->children, "nosuch"), nullptr);
  EXPECT_EQ(Schema::instance().shared("nosuch"), nullptr);
}

/// The files in which sdformat describes a version of the format, by their names.
using Files = std::map<std::string, Element>;

Files readFiles(int version) {
  const std::filesystem::path folder = "/usr/share/sdformat12/1." + std::to_string(version);
  Files files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != ".sdf") continue;
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    Diagnostics diagnostics;
    std::optional<Element> root = parseDocument(text, nullptr, diagnostics);
    if (root) files.emplace(entry.path().filename().string(), std::move(*root));
  }
  return files;
}

/// Visits sdformat's description of the format and our table side by side.
class Walk {
 public:
  /// @param part Null where the table has no such part; `compare` must report that.
  using Compare = std::function<void(const std::string& path, const Element& theirs, const Schema::Part* part)>;

  Walk(const Files& files, Compare compare) : files_(files), compare_(std::move(compare)) {}

  void from(const std::string& file, const Schema::Part& part) { visit(files_.at(file), part, std::string(part.name)); }

 private:
  void visit(const Element& theirs, const Schema::Part& part, const std::string& path) {
    if (!visited_.insert({&theirs, part.type}).second) return;
    static const Schema::ElementType kNothing;
    const Schema::ElementType& type = part.type != nullptr ? *part.type : kNothing;
    for (const Element& child : theirs.children) {
      const std::string name = child.attributeOr("name", "*");
      if (child.name == "attribute") {
        compare_(path + "@" + name, child, Schema::find(type.attributes, name));
      } else if (child.name == "element" && child.attributeOr("required", "") != "-1") {
        visitChild(child, child, Schema::find(type.children, name), path + "." + name);
      } else if (child.name == "include") {
        const auto file = files_.find(child.attributeOr("filename", ""));
        if (file == files_.end()) continue;
        const std::string included = file->second.attributeOr("name", "");
        visitChild(child, file->second, Schema::find(type.children, included), path + "." + included);
      }
    }
  }

  void visitChild(const Element& theirs, const Element& content, const Schema::Part* part, const std::string& path) {
    compare_(path, theirs, part);
    // a reference includes all that it refers to, so what sdformat repeats below it need not be visited
    if (part != nullptr && theirs.attribute("ref") == nullptr) visit(content, *part, path);
  }

  const Files& files_;
  Compare compare_;
  std::set<std::pair<const Element*, const Schema::ElementType*>> visited_;
};

/// @return The text with single spaces.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool isSpace = std::isspace(static_cast<unsigned char>(letter)) != 0;
    if (!isSpace) result += letter;
    if (isSpace && !result.empty() && result.back() != ' ') result += ' ';
  }
  return result;
}

class SchemaAgainstSdformat : public ::testing::Test {
 protected:
  void SetUp() override {
    if (readFiles(9).empty()) GTEST_SKIP() << "the package sdformat-sdf is not installed";
  }
};

TEST_F(SchemaAgainstSdformat, SaysTheSameOfSdf19) {
  const Files files = readFiles(9);
  std::set<std::string_view> met;
  Walk(files, [&](const std::string& path, const Element& theirs, const Schema::Part* part) {
    ASSERT_NE(part, nullptr) << path;
    met.insert(part->row.path);
    EXPECT_TRUE(part->row.isIn(9)) << path;
    EXPECT_EQ(std::string(1, part->row.presence.in(9)), theirs.attributeOr("required", "")) << path;
    if (theirs.name == "include" || theirs.attribute("ref") != nullptr) return;
    const std::string type = theirs.attributeOr("type", "");
    EXPECT_EQ(part->row.type, type) << path;
    const std::string fallback = theirs.attributeOr("default", "");
    EXPECT_EQ(part->row.fallback.in(9), type.empty() || fallback == "__default__" ? "" : fallback) << path;
    // one holds an element as an example
    const Element* description = theirs.child("description");
    if (description != nullptr && description->children.empty()) {
      EXPECT_EQ(part->row.description, squeezed(description->text)) << path;
    }
  }).from("root.sdf", Schema::instance().root());

  // not in Debian's package: later releases of sdformat 12 added these to SDF 1.9, accept them although the format does
  // not list them (world.joint), or Fortress reads them (frame ids)
  const std::set<std::string_view> added{"camera.camera_info_topic",
                                         "camera.triggered",
                                         "camera.trigger_topic",
                                         "camera.image.anti_aliasing",
                                         "camera.lens.projection",
                                         "camera.optical_frame_id",
                                         "light.light_on",
                                         "light.visualize",
                                         "lidar.visibility_mask",
                                         "ray.visibility_mask",
                                         "sensor.gz_frame_id",
                                         "sensor.ignition_frame_id",
                                         "sensor.navsat",
                                         "world.joint"};
  for (const SchemaRow& row : schemaTable()) {
    if (!row.isIn(9) || row.path.find_first_of(".@") == row.path.npos) continue;
    const bool isAdded =
        added.contains(row.path) || row.path.starts_with("navsat.") || row.path.starts_with("camera.lens.projection.");
    EXPECT_EQ(met.contains(row.path), !isAdded) << row.path;
  }
}

TEST_F(SchemaAgainstSdformat, KnowsSinceWhenAndUntilWhen) {
  for (const int version : {0, 2, 3, 4, 5, 6, 7, 8}) {
    const Files files = readFiles(version);
    if (files.empty()) continue;
    Walk(files, [version](const std::string& path, const Element&, const Schema::Part* part) {
      // elements that only versions before 1.4 have are not in the table: these versions are not supported
      if (part == nullptr) {
        EXPECT_LT(version, 4) << path;
        return;
      }
      EXPECT_LE(part->row.since, version) << path;
      EXPECT_TRUE(part->row.removedIn == 0 || part->row.removedIn > version) << path;
    }).from(files.contains("root.sdf") ? "root.sdf" : "gazebo.sdf", Schema::instance().root());
  }
}

}  // namespace
}  // namespace pongsim::sdf::test
