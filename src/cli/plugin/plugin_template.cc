#include "cli/plugin/plugin_template.hh"

#include <cctype>
#include <cstddef>
#include <fstream>
#include <system_error>
#include <utility>

namespace pongsim::cli {

namespace {

// In the texts, @my-system@ stands for the name, @my_system@ for that of files, and @MySystem@ for that of the class.

constexpr std::string_view kCMakeLists = R"(cmake_minimum_required(VERSION 3.18)
project(@my-system@ LANGUAGES CXX)

find_package(pongsim REQUIRED)
pongsim_add_system(@my-system@ SOURCES @my_system@.cc)

include(CTest)
if(BUILD_TESTING)
  add_executable(@my_system@_test @my_system@_test.cc)
  target_link_libraries(@my_system@_test PRIVATE pongsim::pongsim)
  add_test(NAME @my-system@ COMMAND @my_system@_test ${CMAKE_CURRENT_SOURCE_DIR}/@my_system@.sdf)
  set_tests_properties(@my-system@ PROPERTIES ENVIRONMENT PONGSIM_PLUGIN_PATH=$<TARGET_FILE_DIR:@my-system@>)
endif()
)";

constexpr std::string_view kSource = R"(#include <ignition/msgs/double.pb.h>
#include <pongsim/commands.hh>
#include <pongsim/parameters.hh>
#include <pongsim/system.hh>

#include <optional>
#include <string>

namespace {

/// Lifts a model with a force that parameter and topic tell.
class @MySystem@ : public pongsim::System {
 public:
  // What the system is and takes: read before configure(), printed by `pongsim plugin -i`.
  void declare(pongsim::Declaration& declaration) override {
    declaration.is("Lifts a model.", pongsim::Declaration::Place::kModel);
    declaration.parameter("force", &force_, "N", "force until the first message, upwards").atLeast(0);
    declaration.parameter("topic", &topic_, "", "where forces come from").otherwise("/model/M/lift");
    declaration.subscribes("<topic>", "ignition.msgs.Double", "force [N]");
  }

  void configure(const pongsim::SystemContext& context) override {
    const pongsim::Model& model = *context.model;
    link_ = model.canonicalLink();
    if (!link_) pongsim::refuse(context.sdf, "the model has no link to lift");
    subscription_ = context.node.subscribe<ignition::msgs::Double>(
        pongsim::topicOr(topic_, "/model/" + std::string(model.name()) + "/lift"),
        [this](const ignition::msgs::Double& message) { force_ = message.data(); }, pongsim::kForces);
  }

  // Before each step of the physics: the place for commands.
  void preUpdate(const pongsim::StepInfo& info) override {
    if (!info.paused) link_->addWrench({0, 0, force_}, {0, 0, 0});
  }

 private:
  double force_ = 0;
  std::string topic_;
  std::optional<pongsim::Link> link_;
  pongsim::Subscription subscription_;
};

}  // namespace

PONGSIM_EXPORT_SYSTEM(@MySystem@, "@MySystem@");
)";

constexpr std::string_view kTest = R"(// Runs the world and looks whether the box rises; ctest runs it.
#include <pongsim/simulation.hh>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  pongsim::Diagnostics diagnostics;
  pongsim::SimulationOptions options;
  options.strict = true;
  const auto simulation = pongsim::Simulation::fromFile(argv[1], options, diagnostics);
  for (const pongsim::Diagnostic& diagnostic : diagnostics.all()) {
    std::fprintf(stderr, "%s\n", pongsim::format(diagnostic).c_str());
  }
  if (!simulation || !diagnostics.all().empty()) return 1;

  simulation->step(1000);
  const double height = simulation->world().model("box")->pose().position.z();
  std::printf("after a second the box is %g m high\n", height);
  return height > 1 && height < 1.2 ? 0 : 1;
}
)";

constexpr std::string_view kWorld = R"(<?xml version="1.0"?>
<!-- A box of 1 kg that is lifted with a little more than its weight:
     PONGSIM_PLUGIN_PATH=build pongsim run @my_system@.sdf
     pongsim topic -t /model/box/lift -m ignition.msgs.Double -p "data: 12" -->
<sdf version="1.9">
  <world name="@my_system@">
    <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
    <model name="box">
      <pose>0 0 1 0 0 0</pose>
      <link name="link">
        <inertial><mass>1</mass></inertial>
      </link>
      <plugin filename="@my-system@" name="@MySystem@">
        <force>10</force>
      </plugin>
    </model>
  </world>
</sdf>
)";

constexpr std::string_view kPage = R"(# @MySystem@
Lifts a model. `pongsim plugin -i build/lib@my-system@.so` prints its parameters and topics.

    cmake -B build && cmake --build build
    ctest --test-dir build
    PONGSIM_PLUGIN_PATH=build pongsim run @my_system@.sdf
)";

/// @return "my_system".
std::string fileName(const std::string& name) {
  std::string text = name;
  for (char& letter : text) {
    if (letter == '-') letter = '_';
  }
  return text;
}

/// @return "MySystem".
std::string className(const std::string& name) {
  std::string text;
  bool isFirst = true;
  for (const char letter : name) {
    if (letter != '-') text += isFirst ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    isFirst = letter == '-';
  }
  return text;
}

std::string filledIn(std::string_view text, const std::string& name) {
  std::string result(text);
  const std::pair<std::string_view, std::string> words[] = {
      {"@my-system@", name}, {"@my_system@", fileName(name)}, {"@MySystem@", className(name)}};
  for (const auto& [place, word] : words) {
    for (std::size_t at = result.find(place); at != std::string::npos; at = result.find(place, at + word.size())) {
      result.replace(at, place.size(), word);
    }
  }
  return result;
}

}  // namespace

std::optional<std::string> pluginNameError(std::string_view name) {
  if (name.empty() || std::islower(static_cast<unsigned char>(name.front())) == 0) {
    return "must begin with a lower-case letter";
  }
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto letter = static_cast<unsigned char>(name[i]);
    const bool isGood = std::islower(letter) != 0 || std::isdigit(letter) != 0 ||
                        (letter == '-' && i + 1 < name.size() && name[i + 1] != '-');
    if (!isGood) return "may only have lower-case letters, digits and single hyphens";
  }
  return std::nullopt;
}

std::optional<std::string> writePluginTemplate(const std::filesystem::path& folder, const std::string& name) {
  std::error_code error;
  if (std::filesystem::exists(folder, error)) return "'" + folder.string() + "' already exists";
  std::filesystem::create_directories(folder, error);
  if (error) return "'" + folder.string() + "' can't be created: " + error.message();
  const std::string stem = fileName(name);
  const std::pair<std::string, std::string_view> files[] = {{"CMakeLists.txt", kCMakeLists},
                                                            {stem + ".cc", kSource},
                                                            {stem + "_test.cc", kTest},
                                                            {stem + ".sdf", kWorld},
                                                            {"README.md", kPage}};
  for (const auto& [file, text] : files) {
    std::ofstream stream(folder / file, std::ios::binary);
    stream << filledIn(text, name);
    if (!stream.flush()) return "'" + (folder / file).string() + "' can't be written";
  }
  return std::nullopt;
}

}  // namespace pongsim::cli
