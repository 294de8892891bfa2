#include "sim/edits/edit_services.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/inertial.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/serialized_map.pb.h>
#include <ignition/msgs/wheel_slip_parameters_cmd.pb.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "msgs/state/component.hh"
#include "plugin/core_systems.hh"
#include "pongsim/scene.hh"
#include "pongsim/simulation.hh"
#include "support/ask_service.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::sim {
namespace {

constexpr const char* kEditedWorld = R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
  <model name="ball"><pose>1 2 3 0 0 0</pose><link name="l"/></model>
  <model name="tower"><link name="l"/><model name="top"><link name="l"/></model></model>
  <light name="sun" type="directional"><diffuse>1 1 1 1</diffuse></light></world></sdf>)";
constexpr const char* kCrate = "sdf: \"<sdf version='1.9'><model name='crate'><link name='l'/></model></sdf>\"";

class EditServicesTest : public testing::Test {
 protected:
  void SetUp() override {
    test::testDomain();
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kEditedWorld, "world.sdf", {.loadSystems = false}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
    services_ = std::make_unique<EditServices>(*simulation_);
  }

  /// @return Why the service refused the request; empty if it carried it out.
  std::string refusal(const std::string& service, const std::string& type, const std::string& text) {
    const MessagePointer request = newMessage(type);
    EXPECT_FALSE(parseMessage(text, *request)) << text;
    ignition::msgs::Boolean reply;
    const CallResult result = test::askService(simulation_->transport(), "/world/w/" + service, *request, reply);
    EXPECT_EQ(reply.data(), static_cast<bool>(result));
    return test::refusalOf(result);
  }
  std::string create(const std::string& text) { return refusal("create", "EntityFactory", text); }
  std::string setPose(const std::string& text) { return refusal("set_pose", "Pose", text); }
  std::string setPhysics(const std::string& text) { return refusal("set_physics", "Physics", text); }

  ignition::msgs::Scene scene() {
    ignition::msgs::Scene message;
    Scene(simulation_->world()).fillIn(message);
    return message;
  }

  std::optional<Model> model(const char* name) { return simulation_->world().model(name); }

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<EditServices> services_;
};

TEST_F(EditServicesTest, LetModelsPerform) {
  const auto perform = [this](const std::string& text) { return refusal("level/set_performer", "StringMsg", text); };
  EXPECT_EQ(perform("data: 'ball'"), "");
  EXPECT_EQ(perform("data: 'ball'"), "model 'ball' is already a performer");
  EXPECT_EQ(perform(""), "no model is given");
  EXPECT_EQ(perform("data: 'tower::top'"), "model 'tower::top' is part of another model");
  EXPECT_EQ(perform("data: 'later'"), "") << "as in Fortress: when it comes";
  std::vector<Performer> performers;
  simulation_->world().performers(performers);
  ASSERT_EQ(performers.size(), 1U);
  EXPECT_EQ(performers[0].name, "perf_ball");
  EXPECT_EQ(performers[0].pose.position, Vector3(1, 2, 3));
}

TEST_F(EditServicesTest, SayThatAModelIsSetAside) {
  Diagnostics diagnostics;
  services_.reset();
  simulation_ = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><model name='far'><link name='l'/></model><plugin filename='dummy' "
      "name='gz::sim'><level name='x'><geometry><box/></geometry><ref>far</ref></level></plugin></world></sdf>",
      "world.sdf", {.loadSystems = false, .levels = true}, diagnostics);
  ASSERT_NE(simulation_, nullptr);
  services_ = std::make_unique<EditServices>(*simulation_);
  const std::string refused = "model 'far' is in a level that is not loaded";
  EXPECT_EQ(setPose("name: 'far'"), refused);
  EXPECT_EQ(refusal("remove", "Entity", "name: 'far', type: MODEL"), refused);
}

TEST_F(EditServicesTest, CreateAModelWhereItIsWanted) {
  const std::string crate = kCrate;
  EXPECT_EQ(create(crate + ", pose {position {x: 4}}"), "");
  EXPECT_EQ(model("crate")->pose().position, Vector3(4, 0, 0));
  EXPECT_EQ(create(crate + ", name: 'box'"), "");
  EXPECT_TRUE(model("box"));
  EXPECT_NE(create(crate), "");
  EXPECT_EQ(create(crate + ", allow_renaming: true"), "");
  EXPECT_TRUE(model("crate_0"));
}

TEST_F(EditServicesTest, SayWhatIsWrongWithWhatIsToBeCreated) {
  EXPECT_NE(create("").find("'sdf'"), std::string::npos);
  EXPECT_NE(create("sdf: '<sdf'").find("sdf:1:"), std::string::npos);
  EXPECT_NE(create("sdf_filename: 'nowhere.sdf'").find("nowhere.sdf"), std::string::npos);
  EXPECT_EQ(create("clone_name: 'bal', name: 'b'"), "there is no model 'bal'; did you mean 'ball'?");
  EXPECT_NE(create("clone_name: 'ball'"), "") << "the name is taken";
  EXPECT_EQ(create("clone_name: 'ball', name: 'b', relative_to: 'tower'"), "field 'relative_to' is not supported");
  EXPECT_EQ(simulation_->world().models().size(), 2U);
}

TEST_F(EditServicesTest, LeavePartsOfModelsWhereTheyAre) {
  const std::string nested = "'tower::top' is nested in another model";
  EXPECT_EQ(create("clone_name: 'tower::top', name: 'copy'"), nested);
  EXPECT_EQ(refusal("remove", "Entity", "name: 'tower::top', type: MODEL"), nested);
}

TEST_F(EditServicesTest, CreateFilesOfTheWorldsFolderOnly) {
  const test::TempFolder world, outside;
  const std::string crate = "<sdf version='1.9'><model name='crate'><link name='l'/></model></sdf>";
  Diagnostics diagnostics;
  services_.reset();
  simulation_ = Simulation::fromFile(world.write("w.sdf", "<sdf version='1.9'><world name='w'/></sdf>"),
                                     {.loadSystems = false}, diagnostics);
  ASSERT_NE(simulation_, nullptr);
  services_ = std::make_unique<EditServices>(*simulation_);
  const auto refusalOf = [&](const std::filesystem::path& file) {
    const std::string said = create("sdf_filename: '" + file.string() + "'");
    EXPECT_NE(said.find(file.string()), std::string::npos) << said;
    return said.substr(said.find(file.string()) + file.string().size());
  };
  const std::string notThere = refusalOf(outside.path() / "not there");
  EXPECT_EQ(refusalOf(outside.write("crate.sdf", crate)), notThere);
  EXPECT_EQ(refusalOf(outside.write("broken.sdf", "<sdf")), notThere);
  std::filesystem::create_symlink(outside.path() / "crate.sdf", world.path() / "link.sdf");
  EXPECT_EQ(refusalOf(world.path() / "link.sdf"), notThere);
  world.write("m/model.config",
              "<model><name>m</name><sdf>../../" + outside.path().filename().string() + "/crate.sdf</sdf></model>");
  EXPECT_NE(create("sdf_filename: '" + (world.path() / "m").string() + "'"), "");
  EXPECT_EQ(simulation_->world().models().size(), 0U);
  EXPECT_EQ(create("sdf_filename: '" + world.write("crate.sdf", crate).string() + "'"), "");
  // the restriction is for requests, not for the program
  EXPECT_TRUE(simulation_->insertFile(outside.path() / "crate.sdf", {.name = "other"}, diagnostics));
}

TEST_F(EditServicesTest, CreateModelsThatReadAndWriteNothingOutside) {
  const test::TempFolder outside;
  const std::string mesh = outside.write("a.stl", "solid\nendsolid").string();
  const auto modelWith = [](const std::string& inLink, const std::string& name) {
    return "<sdf version='1.9'><model name='" + name + "'><link name='l'>" + inLink + "</link></model></sdf>";
  };
  const auto meshAt = [](const std::string& file) {
    return "<collision name='c'><geometry><mesh><uri>" + file + "</uri></mesh></geometry></collision>";
  };
  const auto warnings = [&](const std::string& inLink, bool isFromOutside) {
    Diagnostics diagnostics;
    const InsertOptions options{.allowRenaming = true, .isFromOutside = isFromOutside};
    EXPECT_TRUE(simulation_->insertModelOrLight(modelWith(inLink, "m"), "sdf", options, diagnostics));
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics.all()) all += diagnostic.message + "; " + diagnostic.hint + "\n";
    return all;
  };
  std::string there = warnings(meshAt(mesh), true), notThere = warnings(meshAt("/not/there.stl"), true);
  ASSERT_NE(there.find(mesh), std::string::npos) << there;
  EXPECT_EQ(there.replace(there.find(mesh), mesh.size(), "/not/there.stl"), notThere);
  EXPECT_EQ(warnings(meshAt(mesh), false).find("is not found"), std::string::npos);

  const std::string picture = outside.write("a.png", "").string();
  const std::string pictured =
      "<visual name='v'><geometry><sphere><radius>1</radius></sphere></geometry><material><pbr>"
      "<metal><albedo_map>" +
      picture + "</albedo_map></metal></pbr></material></visual>";
  warnings(pictured, true);
  EXPECT_EQ(scene().DebugString().find(picture), std::string::npos) << "the web server gives out what a scene names";
  warnings(pictured, false);
  EXPECT_NE(scene().DebugString().find(picture), std::string::npos);

  const std::string camera = "<sensor name='s' type='camera'><camera><save enabled='true'><path>" +
                             outside.path().string() + "</path></save></camera></sensor>";
  EXPECT_NE(warnings(camera, true).find("no images are saved"), std::string::npos);
  EXPECT_EQ(warnings(camera, false).find("no images are saved"), std::string::npos);
}

TEST_F(EditServicesTest, CreateACopyWhereTheOriginalIs) {
  EXPECT_EQ(setPose("name: 'tower', position {x: 5}"), "");
  EXPECT_EQ(create("clone_name: 'tower', name: 'twin'"), "");
  EXPECT_EQ(model("twin")->pose().position, Vector3(5, 0, 0));
  EXPECT_TRUE(model("twin::top"));
  EXPECT_EQ(create("clone_name: 'tower', allow_renaming: true, pose {position {z: 2}}"), "");
  EXPECT_EQ(model("tower_0")->pose().position, Vector3(0, 0, 2));
}

TEST_F(EditServicesTest, CreateWhereOnTheEarthTheyAreTold) {
  const std::string crate = kCrate;
  EXPECT_NE(create(crate + ", spherical_coordinates {latitude_deg: 1}").find("<spherical_coordinates>"),
            std::string::npos);
  Diagnostics diagnostics;
  services_.reset();
  simulation_ = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><spherical_coordinates><surface_model>EARTH_WGS84</surface_model>"
      "<latitude_deg>10</latitude_deg><longitude_deg>20</longitude_deg><elevation>30</elevation>"
      "</spherical_coordinates></world></sdf>",
      "world.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_NE(simulation_, nullptr);
  services_ = std::make_unique<EditServices>(*simulation_);
  EXPECT_EQ(
      create(crate + ", spherical_coordinates {latitude_deg: 10, longitude_deg: 20, elevation: 35, heading_deg: 90}"),
      "");
  EXPECT_NEAR((model("crate")->pose().position - Vector3(0, 0, 5)).norm(), 0, 1e-6);
  EXPECT_NEAR(yawOf(model("crate")->pose().rotation), std::numbers::pi / 2, 1e-9);
}

TEST_F(EditServicesTest, CreateChangeAndRemoveLights) {
  const auto light = [&](const std::string& text) { return refusal("light_config", "Light", text); };
  EXPECT_EQ(light("name: 'sun', diffuse {r: 0.5}, intensity: 2, pose {position {z: 9}}"), "");
  const ignition::msgs::Light sun = scene().light(0);
  EXPECT_EQ(sun.diffuse().r(), 0.5F);
  EXPECT_EQ(sun.intensity(), 2);
  EXPECT_EQ(sun.pose().position().z(), 9);
  EXPECT_EQ(light("name: 'sum'"), "there is no light 'sum'; did you mean 'sun'?");
  EXPECT_NE(light("name: 'sun', range: -1"), "");
  EXPECT_NE(light("name: 'sun', direction {x: nan}"), "");
  EXPECT_NE(light("name: 'sun', parent_id: 4711"), "");

  EXPECT_EQ(create("light {name: 'lamp', type: POINT, range: 3}, pose {position {x: 1}}"), "");
  EXPECT_NE(create("light {name: 'lamp'}"), "") << "it is there already";
  EXPECT_EQ(create("light {name: 'lamp'}, allow_renaming: true"), "");
  ASSERT_EQ(scene().light_size(), 3);
  EXPECT_EQ(scene().light(1).pose().position().x(), 1);
  EXPECT_EQ(scene().light(2).name(), "lamp_0");
  const std::string spot =
      "sdf: \"<sdf version='1.9'><light name='spot' "
      "type='spot'><attenuation><range>4</range></attenuation></light></sdf>\"";
  EXPECT_EQ(create(spot + ", pose {position {z: 3}}"), "");
  ASSERT_EQ(scene().light_size(), 4);
  EXPECT_EQ(scene().light(3).type(), ignition::msgs::Light::SPOT);
  EXPECT_EQ(scene().light(3).range(), 4);
  EXPECT_EQ(scene().light(3).pose().position().z(), 3);
  EXPECT_NE(create(spot).find("there is a 'spot' in the world already"), std::string::npos);
  EXPECT_NE(create(spot + ", name: 'a::b'").find("'::'"), std::string::npos);
  EXPECT_EQ(create("sdf: \"<sdf version='1.9'><actor name='a'/></sdf>\""), "there is no model or light to insert");
  EXPECT_NE(refusal("create_multiple", "EntityFactory_V", "data {" + spot + ", name: 'a'} data {" + spot + "}"), "");
  EXPECT_EQ(scene().light_size(), 4) << "all or none";
  EXPECT_EQ(refusal("remove", "Entity", "name: 'spot', type: LIGHT"), "");
  EXPECT_EQ(refusal("remove", "Entity", "name: 'sun', type: LIGHT"), "");
  EXPECT_NE(refusal("remove", "Entity", "name: 'sun', type: LIGHT"), "");
  EXPECT_EQ(scene().light_size(), 2);
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  ASSERT_EQ(scene().light_size(), 1);
  EXPECT_EQ(scene().light(0).diffuse().r(), 1);
}

constexpr const char* kArm = R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity><model name="arm">
  <link name="base"><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz></inertia></inertial>
    <visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry>
      <material><diffuse>1 1 1 0.5</diffuse></material></visual></link>
  <link name="hand"><pose>1 0 0 0 0 0</pose><visual name="v"><geometry><box/></geometry></visual></link>
  <joint name="j" type="revolute"><parent>base</parent><child>hand</child><pose>-1 0 0 0 0 0</pose>
    <axis><xyz>0 0 1</xyz></axis></joint></model>
  <model name="rock"><static>true</static><link name="l"/></model></world></sdf>)";

class PropertyServicesTest : public EditServicesTest {
 protected:
  void SetUp() override {
    test::testDomain();
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kArm, "world.sdf", {.loadSystems = false}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
    services_ = std::make_unique<EditServices>(*simulation_);
  }
  std::string mass(const std::string& text) { return refusal("set_mass", "Link", text); }
  std::string position(const std::string& text) { return refusal("set_joint_position", "Joint", text); }
  std::string color(const std::string& text) { return refusal("visual_config", "Visual", text); }
  /// @return A component of the state, in its serialized form.
  std::string component(std::uint64_t entity, const char* name) {
    ignition::msgs::SerializedStepMap step;
    Scene(simulation_->world()).fillInState(step, StateContent::kAll, true);
    const auto& components = step.state().entities().at(entity).components();
    return components.at(static_cast<std::int64_t>(msgs::componentType(name))).component();
  }
};

TEST_F(PropertyServicesTest, SetMasses) {
  const Link base = *model("arm")->link("base");
  EXPECT_EQ(mass("name: 'arm::base', inertial {mass: 6}"), "");
  EXPECT_EQ(base.mass().mass, 6);
  EXPECT_NEAR(base.mass().inertia(2, 2), 7.5, 1e-12) << "as if its density had changed";
  ignition::msgs::Inertial shown;
  ASSERT_TRUE(shown.ParseFromString(component(base.id().value, "Inertial")));
  EXPECT_EQ(shown.mass(), 6);
  EXPECT_NEAR(shown.iyy(), 6, 1e-12);
  EXPECT_EQ(mass("id: " + std::to_string(base.id().value) + ", inertial {mass: 2}"), "");
  EXPECT_EQ(base.mass().mass, 2);
  EXPECT_NEAR(base.mass().inertia(2, 2), 2.5, 1e-12);
}

TEST_F(PropertyServicesTest, RefuseMassesThatCanNotBe) {
  for (const char* bad : {"mass: 0", "mass: -1", "mass: nan", "mass: inf"}) {
    EXPECT_NE(mass(std::string("name: 'arm::base', inertial {") + bad + "}"), "") << bad;
  }
  EXPECT_NE(mass("name: 'arm::base'"), "");
  EXPECT_NE(mass("name: 'arm', inertial {mass: 1}").find("is a model"), std::string::npos);
  EXPECT_NE(mass("name: 'arm::foot', inertial {mass: 1}"), "");
  EXPECT_NE(mass("name: 'rock::l', inertial {mass: 1}").find("does not move"), std::string::npos);
  EXPECT_EQ(model("arm")->link("base")->mass().mass, 2);
}

TEST_F(PropertyServicesTest, MoveJoints) {
  const Joint joint = *model("arm")->joint("j");
  EXPECT_EQ(position("name: 'arm::j', axis1 {position: 1.5}"), "");
  EXPECT_NEAR(joint.position(), 1.5, 1e-12);
  EXPECT_NEAR(model("arm")->link("hand")->pose().position.y(), std::sin(1.5), 1e-12);
  EXPECT_EQ(position("id: " + std::to_string(joint.id().value) + ", axis1 {}"), "");
  EXPECT_NEAR(joint.position(), 0, 1e-12);
  EXPECT_EQ(position("name: 'arm::j', axis1 {position: nan}"), "axis1.position is nan");
  EXPECT_NE(position("name: 'arm::j', axis1 {position: 1e300}"), "");
  EXPECT_EQ(position("name: 'arm::j', axis1 {position: 1}, axis2 {}"), "joint 'j' has no axis2");
  EXPECT_NE(position("name: 'arm::j'"), "");
  EXPECT_EQ(position("name: 'arm::k', axis1 {}"), "there is no joint 'arm::k' (it is 'MODEL::JOINT')");
  EXPECT_NE(position("id: 4711, axis1 {}"), "");
  EXPECT_NEAR(joint.position(), 0, 1e-12) << "a refused request changes nothing";
}

TEST_F(PropertyServicesTest, ColorVisuals) {
  const ignition::msgs::Visual before = scene().model(0).link(0).visual(0);
  EXPECT_EQ(color("id: " + std::to_string(before.id()) + ", material {diffuse {r: 0.25, b: 1, a: 1}}"), "");
  const ignition::msgs::Material now = scene().model(0).link(0).visual(0).material();
  EXPECT_EQ(now.diffuse().r(), 0.25F);
  EXPECT_EQ(now.diffuse().g(), 0);
  EXPECT_EQ(now.diffuse().a(), 0.5F) << "it stays as transparent as it was";
  EXPECT_EQ(now.ambient().b(), 1);
  ignition::msgs::Material inState;
  ASSERT_TRUE(inState.ParseFromString(component(before.id(), "Material")));
  EXPECT_EQ(inState.diffuse().r(), 0.25F);
  EXPECT_EQ(color("name: 'v', parent_name: 'arm::hand', material {diffuse {g: 1}}"), "");
  EXPECT_EQ(scene().model(0).link(1).visual(0).material().diffuse().g(), 1);
  EXPECT_EQ(scene().model(0).link(0).visual(0).material().diffuse().g(), 0);
  EXPECT_EQ(color("name: 'v', parent_name: 'base', material {diffuse {g: 1}}"), "") << "as Fortress names links";
  EXPECT_EQ(scene().model(0).link(0).visual(0).material().diffuse().g(), 1);
  EXPECT_EQ(color("name: 'v', parent_name: 'base', material {emissive {r: 1} specular {b: 0.5} ambient {g: 0.25}}"),
            "");
  const ignition::msgs::Material more = scene().model(0).link(0).visual(0).material();
  EXPECT_EQ(more.diffuse().g(), 1) << "what is left out stays";
  EXPECT_EQ(more.emissive().r(), 1);
  EXPECT_EQ(more.specular().b(), 0.5F);
  EXPECT_EQ(more.ambient().g(), 0.25F);
  const std::uint64_t changes = Scene(simulation_->world()).colorChanges();
  for (const char* bad :
       {"name: 'v', parent_name: 'arm::hand', material {diffuse {} emissive {g: 1.5}}",
        "name: 'v', material {diffuse {}}", "name: 'w', parent_name: 'arm::hand', material {diffuse {}}",
        "id: 4711, material {diffuse {}}", "name: 'v', parent_name: 'arm::hand'",
        "name: 'v', parent_name: 'arm::hand', material {diffuse {r: 2}}",
        "name: 'v', parent_name: 'arm::hand', material {diffuse {r: nan}}"}) {
    EXPECT_NE(color(bad), "") << bad;
  }
  EXPECT_EQ(Scene(simulation_->world()).colorChanges(), changes);
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(scene().model(0).link(0).visual(0).material().diffuse().r(), 1) << "as in the file";
  EXPECT_NE(Scene(simulation_->world()).colorChanges(), changes);
}

TEST_F(EditServicesTest, PassWheelSlipsOnToWhoeverListens) {
  const auto slip = [&](const std::string& text) { return refusal("wheel_slip", "WheelSlipParametersCmd", text); };
  EXPECT_EQ(slip("entity {name: 'ball::l'}"), "the world has no wheel-slip system");
  std::vector<ignition::msgs::WheelSlipParametersCmd> heard;
  const Subscription subscription = simulation_->transport().node().subscribe<ignition::msgs::WheelSlipParametersCmd>(
      "/world/w/wheel_slip", [&](const auto& message) { heard.push_back(message); });
  const LinkId link = model("ball")->link("l")->id();
  EXPECT_EQ(slip("entity {name: 'ball::l', type: LINK}, slip_compliance_lateral: 0.5"), "");
  EXPECT_EQ(slip("entity {name: 'tower::top'}, slip_compliance_longitudinal: 2"), "");
  EXPECT_EQ(slip("entity {id: " + std::to_string(link.value) + "}"), "");
  simulation_->step();
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_EQ(heard[0].entity().id(), link.value);
  EXPECT_EQ(heard[0].entity().type(), ignition::msgs::Entity::LINK);
  EXPECT_EQ(heard[0].slip_compliance_lateral(), 0.5);
  EXPECT_EQ(heard[1].entity().id(), model("tower::top")->id().value);
  EXPECT_EQ(heard[1].entity().type(), ignition::msgs::Entity::MODEL);
  EXPECT_EQ(heard[1].slip_compliance_longitudinal(), 2);
  EXPECT_EQ(heard[2].entity().name(), "ball::l");
}

TEST_F(EditServicesTest, SayWhichWheelIsNotThere) {
  const auto slip = [&](const std::string& text) { return refusal("wheel_slip", "WheelSlipParametersCmd", text); };
  EXPECT_NE(slip("").find("give a name or an id"), std::string::npos);
  EXPECT_NE(slip("entity {name: 'ball::k'}").find("no model 'ball::k', and no link of that name"), std::string::npos);
  EXPECT_NE(slip("entity {name: 'l'}").find("'MODEL::LINK'"), std::string::npos);
  EXPECT_NE(slip("entity {id: 4711}").find("id 4711"), std::string::npos);
  for (const char* bad : {"slip_compliance_lateral: -1", "slip_compliance_longitudinal: nan"}) {
    EXPECT_NE(slip(std::string("entity {name: 'ball::l'}, ") + bad).find("zero or more"), std::string::npos) << bad;
  }
}

TEST_F(EditServicesTest, ListenToLightsOnATopic) {
  const MessagePointer light = newMessage("Light");
  ASSERT_FALSE(parseMessage("name: 'sun', range: 7", *light));
  Publisher publisher = simulation_->transport().node().advertise("/world/w/light_config", "ignition.msgs.Light");
  publisher.publish(*light);
  simulation_->transport().dispatch();
  EXPECT_EQ(scene().light(0).range(), 7);
}

TEST_F(EditServicesTest, CreateAllOrNone) {
  const std::string crate = kCrate;
  EXPECT_NE(
      refusal("create_multiple", "EntityFactory_V", "data {" + crate + "} data {" + crate + "}").find("number 2: "),
      std::string::npos);
  EXPECT_FALSE(model("crate"));
  EXPECT_EQ(refusal("create_multiple", "EntityFactory_V", "data {" + crate + "} data {" + crate + ", name: 'b'}"), "");
  EXPECT_TRUE(model("crate") && model("b"));
}

TEST_F(EditServicesTest, RemoveAModelByNameOrId) {
  EXPECT_EQ(refusal("remove", "Entity", "name: 'bal', type: MODEL"), "there is no model 'bal'; did you mean 'ball'?");
  EXPECT_EQ(refusal("remove", "Entity", "name: 'tower::top', type: MODEL"), "'tower::top' is nested in another model");
  EXPECT_NE(refusal("remove", "Entity", "name: 'l', type: LINK"), "");
  EXPECT_NE(refusal("remove", "Entity", "id: 4711"), "");
  EXPECT_EQ(refusal("remove", "Entity", "name: 'ball', type: MODEL"), "");
  EXPECT_EQ(refusal("remove", "Entity", "id: " + std::to_string(model("tower")->id().value)), "");
  EXPECT_TRUE(simulation_->world().models().empty());
}

TEST_F(EditServicesTest, PutModelsSomewhereElse) {
  EXPECT_EQ(setPose("name: 'ball', position {x: 7}, orientation {z: 1}"), "");
  EXPECT_EQ(model("ball")->pose().position, Vector3(7, 0, 0));
  EXPECT_NE(setPose("name: 'ball', orientation {}"), "") << "no rotation";
  EXPECT_NE(setPose("position {x: 7}"), "");
  const std::string both = "pose {name: 'ball', position {x: 1}} pose {name: 'NAME', position {x: 2}}";
  EXPECT_NE(refusal("set_pose_vector", "Pose_V", both), "");
  EXPECT_EQ(model("ball")->pose().position.x(), 7);
  EXPECT_EQ(refusal("set_pose_vector", "Pose_V", "pose {name: 'ball'} pose {name: 'tower', position {x: 2}}"), "");
  EXPECT_EQ(model("tower")->pose().position.x(), 2);
}

TEST_F(EditServicesTest, PutTheWorldAndModelsSomewhereOnTheEarth) {
  const auto setPlace = [this](const std::string& text) {
    return refusal("set_spherical_coordinates", "SphericalCoordinates", text);
  };
  EXPECT_NE(setPlace("entity {name: 'ball'}").find("<spherical_coordinates>"), std::string::npos);
  EXPECT_EQ(setPlace("latitude_deg: 91"), "the latitude is not between -90 and 90 degrees");
  EXPECT_EQ(setPlace("longitude_deg: nan"), "the position is not finite");
  EXPECT_FALSE(simulation_->world().tangentPlane());
  const std::vector<std::byte> before = simulation_->saveState();

  EXPECT_EQ(setPlace("latitude_deg: 10, longitude_deg: 20, elevation: 30, heading_deg: 90"), "");
  ASSERT_TRUE(simulation_->world().tangentPlane());
  EXPECT_NEAR(simulation_->world().heading(), std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(setPlace("entity {name: 'ball'}, latitude_deg: 10, longitude_deg: 20, elevation: 35"), "");
  EXPECT_NEAR((model("ball")->pose().position - Vector3(0, 0, 5)).norm(), 0, 1e-6);
  EXPECT_EQ(setPlace("entity {name: 'bll'}"), "there is no model 'bll'; did you mean 'ball'?");

  const std::vector<std::byte> after = simulation_->saveState();
  EXPECT_TRUE(simulation_->restoreState(before));
  EXPECT_FALSE(simulation_->world().tangentPlane());
  EXPECT_TRUE(simulation_->restoreState(after));
  EXPECT_TRUE(simulation_->world().tangentPlane());
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_FALSE(simulation_->world().tangentPlane());
}

TEST_F(EditServicesTest, AreThoseThatThePagesTellOf) {
  const plugin::CoreSystem& system = *plugin::coreSystem("user-commands");
  int services = 0;
  for (const Declaration::Endpoint& endpoint : system.declaration.endpoints()) {
    if (endpoint.kind != Declaration::Endpoint::Kind::kService) continue;
    ++services;
    const std::string name = "/world/w/" + endpoint.name.substr(std::string("/world/W/").size());
    const MessagePointer request = newMessage(endpoint.type);
    const MessagePointer reply = newMessage(endpoint.replyType);
    const CallOutcome outcome = test::askService(simulation_->transport(), name, *request, *reply).outcome;
    // an empty request can be parsed, whether it is carried out or refused
    EXPECT_TRUE(outcome == CallOutcome::kDone || outcome == CallOutcome::kRefused) << name;
  }
  EXPECT_EQ(services, 13);
}

TEST_F(EditServicesTest, ChangePhysicsOrNothingOfIt) {
  EXPECT_EQ(setPhysics("max_step_size: 0.002, real_time_factor: 3, gravity {z: -1}"), "");
  EXPECT_EQ(simulation_->stepSize(), std::chrono::milliseconds(2));
  EXPECT_EQ(simulation_->realTimeFactor(), 3);
  EXPECT_EQ(simulation_->world().gravity(), Vector3(0, 0, -1));
  for (const char* bad : {"", "max_step_size: -1", "max_step_size: nan", "max_step_size: 1e300",
                          "max_step_size: 0.5, real_time_factor: -1", "max_step_size: 0.5, gravity {x: inf}"}) {
    EXPECT_NE(setPhysics(bad), "") << bad;
  }
  EXPECT_EQ(simulation_->stepSize(), std::chrono::milliseconds(2));
}

}  // namespace
}  // namespace pongsim::sim
