// Compares `pongsim sdf --print` with `ign sdf --print` of libsdformat 12: elements and their order, attributes,
// values.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sdf/sdf.hh>
#include <sstream>
#include <string>
#include <vector>

#include "assets/finder.hh"
#include "base/parse_number.hh"
#include "near.hh"
#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"
#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;
/// Files with intended differences, and the reasons.
const std::map<std::string, std::string> kIntendedDifferences = {
    {"triggered_camera_sensor.sdf", "12.3 does not know <triggered>, later versions do"},
    {"seeds/sdf/sensors.sdf", "12.3 does not know <triggered>, later versions do"},
    {"seeds/sdf/looks.sdf", "12.3 does not know <light_on>, later versions do"},
    {"seeds/urdf/robot.urdf", "moments of inertia are turned to the axes of the link"},
    {"model_nested_include.sdf", "a model without links is an error"},
    {"seeds/sdf/old_world.sdf", "what it includes is not there, which is an error"},
};

std::optional<double> numberOf(const std::string& word) {
  if (word == "true") return 1;
  if (word == "false") return 0;
  const std::optional<std::vector<double>> numbers = base::parseDoubles(word);
  return numbers && numbers->size() == 1 ? std::optional(numbers->front()) : std::nullopt;
}

/// @return Whether the texts are equal, with numbers compared by value.
/// @param tolerance Relative.
bool isSameText(const std::string& a, const std::string& b, double tolerance) {
  std::istringstream left(a), right(b);
  std::string x, y;
  while (left >> x) {
    if (!(right >> y)) return false;
    if (x == y) continue;
    const std::optional<double> one = numberOf(x), other = numberOf(y);
    if (!one || !other || std::abs(*one - *other) > tolerance * std::abs(*other)) return false;
  }
  return !(right >> y);
}

/// An element printed by libsdformat.
struct Theirs {
  explicit Theirs(const theirs::ElementPtr& element) {
    for (unsigned i = 0; i < element->GetAttributeCount(); ++i) {
      const theirs::ParamPtr attribute = element->GetAttribute(i);
      if (attribute->GetSet() || attribute->GetRequired()) attributes[attribute->GetKey()] = attribute->GetAsString();
    }
    for (auto child = element->GetFirstElement(); child; child = child->GetNextElement("")) children.push_back(child);
    if (children.empty() && element->GetValue()) text = element->GetValue()->GetAsString();
  }

  std::map<std::string, std::string> attributes;
  std::vector<theirs::ElementPtr> children;
  std::string text;
};

class Comparison {
 public:
  /// @param isUrdf Whether the file is URDF or includes some. Then frames and surfaces of merged links are not
  /// compared, because libsdformat 12.3 loses them (later versions do not), and numbers have six digits.
  explicit Comparison(bool isUrdf) : isUrdf_(isUrdf), tolerance_(isUrdf ? 1e-5 : 1e-9) {}

  void compare(const Element& ours, const theirs::ElementPtr& element, const std::string& holder) {
    const std::string path = holder + "/" + ours.name + "[" + ours.attributeOr("name", "") + "]";
    Theirs other(element);
    std::map<std::string, std::string> attributes;
    for (const Element::Attribute& attribute : ours.attributes) attributes[attribute.name] = attribute.value;
    const bool isMadePose =
        ours.name == "pose" && attributes.contains("rotation_format") && !other.attributes.contains("rotation_format");
    if (isMadePose) attributes.erase("rotation_format");
    ASSERT_EQ(namesOf(attributes), namesOf(other.attributes)) << path;
    for (const auto& [name, value] : other.attributes) {
      EXPECT_TRUE(isSameText(attributes[name], value, tolerance_))
          << path << "@" << name << ": " << attributes[name] << ", theirs " << value;
    }
    std::vector<const Element*> children;
    for (const Element& child : ours.children) {
      if (isLookedAt(child.name, ours.name)) children.push_back(&child);
    }
    std::erase_if(other.children, [&](const auto& child) { return !isLookedAt(child->GetName(), ours.name); });
    const auto names = [](const auto& all, const auto& nameOf) {
      std::string text;
      for (const auto& each : all) text += nameOf(each) + " ";
      return text;
    };
    ASSERT_EQ(names(children, [](const Element* child) { return child->name; }),
              names(other.children, [](const theirs::ElementPtr& child) { return child->GetName(); }))
        << path;
    if (isMadePose) {
      comparePoses(ours.text, *element, path);
    } else if (children.empty()) {
      EXPECT_TRUE(isSameText(ours.text, other.text, tolerance_))
          << path << ": '" << ours.text << "', theirs '" << other.text << "'";
    }
    for (std::size_t i = 0; i < children.size(); ++i) compare(*children[i], other.children[i], path);
  }

 private:
  bool isLookedAt(const std::string& name, const std::string& holder) const {
    return !isUrdf_ || (name != "frame" && name != "surface" && !(name == "pose" && holder == "sensor"));
  }

  /// We print poses that were computed while reading as quaternions with all digits, libsdformat with six digits.
  static void comparePoses(const std::string& ours, const theirs::Element& element, const std::string& path) {
    const auto other = pose(element.Get<ignition::math::Pose3d>());
    const std::vector<double> numbers = base::parseDoubles(ours).value();
    ASSERT_EQ(numbers.size(), 7U) << path;
    const Quaternion rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
    EXPECT_LE((Vector3(numbers[0], numbers[1], numbers[2]) - other.position).norm(), 1e-5) << path;
    EXPECT_LE(rotation.angularDistance(other.rotation), 1e-5) << path;
  }

  static std::string namesOf(const std::map<std::string, std::string>& attributes) {
    std::string text;
    for (const auto& [name, value] : attributes) text += name + " ";
    return text;
  }

  bool isUrdf_;
  double tolerance_;
};

/// @return The file's text without includes from Fuel servers, which libsdformat's command does not follow.
std::string withoutFuel(const fs::path& file) {
  std::ifstream stream(file);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t begin = text.find("<include>"); begin != text.npos; begin = text.find("<include>", begin)) {
    const std::size_t end = text.find("</include>", begin);
    if (end == text.npos) break;
    if (text.substr(begin, end - begin).find("http") == text.npos) {
      begin = end;
    } else {
      text.erase(begin, end + 10 - begin);
    }
  }
  return text;
}

std::vector<fs::path> files() {
  const fs::path project = projectFolder();
  std::vector<fs::path> folders{project / "worlds", project / "examples", project / "plugins", project / "test",
                                project / "ros2"};
  for (const auto& folder : {fortressWorlds(), goldenData()}) {
    if (folder) folders.push_back(*folder);
  }
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path kind = entry.path().extension();
      if ((kind == ".sdf" || kind == ".urdf") && entry.file_size() < kMostBytes) files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

class SdformatPrint : public testing::TestWithParam<fs::path> {};

TEST_P(SdformatPrint, PrintsTheSame) {
  for (const auto& [name, reason] : kIntendedDifferences) {
    if (GetParam().string().ends_with(name)) GTEST_SKIP() << reason;
  }
  const TempFolder folder;
  const std::string file = folder.write(GetParam().filename(), withoutFuel(GetParam())).string();
  std::vector<fs::path> models{GetParam().parent_path()};
  if (const auto worlds = fortressWorlds()) models.push_back(*worlds / "test/models");

  // included files are read with the settings of the process
  theirs::ParserConfig& config = theirs::ParserConfig::GlobalConfig();
  config.SetFindCallback([&models](const std::string& name) -> std::string {
    const std::string path = name.starts_with("model://") ? name.substr(8) : name;
    for (const fs::path& model : models) {
      if (fs::exists(model / path)) return model / path;
    }
    return {};
  });
  theirs::Console::Instance()->SetQuiet(true);
  const theirs::SDFPtr other(new theirs::SDF());
  ASSERT_TRUE(theirs::init(other));
  theirs::Errors errors;
  if (!theirs::readFile(file, config, other, errors)) GTEST_SKIP() << "libsdformat does not read it";

  Diagnostics diagnostics;
  const std::optional<Element> ours =
      pongsim::sdf::resolveFile(file, diagnostics, assets::finderIn({.folders = models, .fuelCache = {}}));
  ASSERT_TRUE(ours) << format(*std::ranges::find(diagnostics.all(), Severity::kError, &Diagnostic::severity));
  Comparison(withoutFuel(GetParam()).find("urdf") != std::string::npos || GetParam().extension() == ".urdf")
      .compare(*ours, other->Root(), "");
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SdformatPrint);
INSTANTIATE_TEST_SUITE_P(Files, SdformatPrint, testing::ValuesIn(files()), [](const auto& instance) {
  std::string name = fs::relative(instance.param, projectFolder().parent_path()).string();
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace pongsim::test
