#include "sdf/includes/includes.hh"

#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

/// Files in a temporary folder, where includes find them by model://.
class IncludesTest : public ::testing::Test {
 protected:
  /// Writes a file with an `<sdf>` element around `content`, which begins in line 2, column 1.
  void write(const std::string& name, const std::string& content, const std::string& version = "1.9") {
    folder_.write(name, "<sdf version='" + version + "'>\n" + content + "</sdf>");
  }

  /// Writes the folder of a model with the folder's name and this content, which begins in line 3.
  void writeModel(const std::string& name, const std::string& content, const std::string& version = "1.9") {
    folder_.write(name + "/model.config", "<model><sdf version='1.9'>model.sdf</sdf></model>");
    write(name + "/model.sdf", "<model name='" + name + "'>\n" + content + "</model>", version);
  }

  /// Loads the file; in the messages, "DIR" replaces the folder's name.
  Loaded loadNamed(const std::string& name) {
    const std::string folder = std::filesystem::canonical(folder_.path()).string();
    Loaded loaded = test::load([&](Diagnostics& diagnostics) {
      return loadFile(folder + "/" + name, diagnostics, assets::finderIn({{folder}, {}}));
    });
    for (std::string& message : loaded.messages) {
      for (std::size_t at = 0; (at = message.find(folder)) != std::string::npos;)
        message.replace(at, folder.size(), "DIR");
    }
    return loaded;
  }

  /// Loads a world with this content, which begins in line 3.
  Loaded loadWorldWith(const std::string& content) {
    write("w.sdf", "<world name='w'>\n" + content + "\n</world>");
    return loadNamed("w.sdf");
  }

  /// Loads a world with a model 'm' with this content, which begins in line 3.
  Loaded loadModelWith(const std::string& content) {
    write("w.sdf", "<world name='w'><model name='m'>\n" + content + "\n</model></world>");
    return loadNamed("w.sdf");
  }

  pongsim::test::TempFolder folder_;
};

TEST_F(IncludesTest, PutAModelInTheirPlace) {
  writeModel("box", "<pose>1 2 3 0 0 0</pose><link name='l'/>");
  const Loaded loaded = loadWorldWith("<include><uri>model://box</uri></include>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().name, "box");
  EXPECT_EQ(loaded.model().links.at(0).name, "l");
  expectPose(loaded.model().X_ParentModel, {1, 2, 3});
  EXPECT_TRUE(loaded.model().position.file->ends_with("/box/model.sdf"));
  EXPECT_EQ(loaded.model().position.line, 2);
}

TEST_F(IncludesTest, PutWhatTheySayInPlaceOfWhatTheModelSays) {
  writeModel("box",
             "<pose>1 2 3 0 0 0</pose><static>true</static><link name='l'><pose>0 0 1 0 0 0</pose></link>"
             "<plugin filename='a' name='A'/>");
  const Loaded loaded = loadWorldWith(
      "<frame name='f'><pose>10 0 0 0 0 0</pose></frame><include><uri>model://box</uri><name>other</name>"
      "<pose relative_to='f'>0 0 0.5 0 0 0</pose><static>false</static><placement_frame>l</placement_frame>"
      "<plugin filename='b' name='B'><x>1</x></plugin></include>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().name, "other");
  EXPECT_FALSE(loaded.model().isStatic);
  expectPose(loaded.model().X_ParentModel, {10, 0, -0.5});
  ASSERT_EQ(loaded.model().plugins.size(), 2U);
  EXPECT_EQ(loaded.model().plugins[1].filename, "b");
  EXPECT_TRUE(loaded.model().plugins[1].sdf.position.file->ends_with("/w.sdf"));
}

TEST_F(IncludesTest, MakeSeveralModelsOfOneFile) {
  writeModel("box", "<link name='l'/>");
  const Loaded loaded = loadWorldWith(
      "<include><uri>model://box</uri></include>\n<include><uri>box/model.sdf</uri><name>b</name></include>\n"
      "<include><uri>model://box</uri></include>");
  EXPECT_EQ(
      loaded.messages,
      Messages{"DIR/w.sdf:5:1: error: model 'box' has the same name as another model of world 'w' | the first one "
               "is in line 3"});
  EXPECT_EQ(loaded.world().models.at(1).name, "b");
}

TEST_F(IncludesTest, BringInLights) {
  write("sun.sdf", "<light name='sun' type='directional'><pose>0 0 1 0 0 0</pose></light>");
  const Loaded loaded = loadWorldWith("<include><uri>sun.sdf</uri><pose>0 0 9 0 0 0</pose></include>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.world().lights.at(0).type, description::LightType::kDirectional);
  expectPose(loaded.world().lights.at(0).X_ParentLight, {0, 0, 9});
  EXPECT_EQ(loadWorldWith("<include><uri>sun.sdf</uri><static>1</static></include>").messages,
            Messages{"DIR/w.sdf:3:28: warning: <static> has no effect: the included element is <light>, not <model>"});
}

TEST_F(IncludesTest, LeaveOutALightInAModelWithAWarning) {
  write("sun.sdf", "<light name='sun' type='directional'/>");
  EXPECT_EQ(loadModelWith("<link name='l'/><include><uri>sun.sdf</uri></include>").messages,
            Messages{"DIR/w.sdf:3:17: warning: a light can't be included in a model: it is ignored | include it in a "
                     "<link> or in the world"});
}

TEST_F(IncludesTest, MayBeActors) {
  write("a.sdf", "<actor name='a'/>");
  EXPECT_EQ(loadWorldWith("<include><uri>a.sdf</uri></include>").messages, Messages());
}

TEST_F(IncludesTest, NestInModelsAndFiles) {
  writeModel("inner", "<pose>0 0 1 0 0 0</pose><link name='l'/>");
  writeModel("outer",
             "<include><uri>model://inner</uri><name>i</name></include><link name='base'/>"
             "<joint name='j' type='fixed'><parent>base</parent><child>i::l</child></joint>");
  const Loaded loaded = loadModelWith("<include><uri>outer</uri><name>o</name></include>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Model& outer = loaded.model().models.at(0);
  EXPECT_EQ(outer.name, "o");
  EXPECT_EQ(outer.models.at(0).name, "i");
  EXPECT_EQ(outer.joints.at(0).child, "i::l");
  expectPose(outer.joints.at(0).X_ParentJoint, {0, 0, 1});
  EXPECT_EQ(loaded.model().canonicalLink, "o::base");
}

TEST_F(IncludesTest, ReadEachFileInItsOwnVersion) {
  writeModel("old",
             "<link name='a'/><link name='b'><pose>0 0 0 1.5707963267948966 0 0</pose></link><joint name='j' "
             "type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>"
             "<use_parent_model_frame>1</use_parent_model_frame></axis></joint>",
             "1.6");
  const Loaded loaded = loadWorldWith("<include><uri>model://old</uri></include>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_LT((loaded.model().joints.at(0).axes.at(0).xyz - Vector3::UnitY()).norm(), 1e-12);
}

TEST_F(IncludesTest, TellMistakesOfAFileOnceAndWhoIncludesIt) {
  writeModel("bad", "<link/>");
  writeModel("outer", "<link name='l'/><include><uri>model://bad</uri></include>");
  const Loaded loaded = loadWorldWith(
      "<include><uri>model://outer</uri></include><include><uri>model://outer</uri><name>b</name></include>\n"
      "<frame name='f' attached_to='nosuch'/>");
  EXPECT_EQ(loaded.messages,
            (Messages{"DIR/bad/model.sdf:3:1: error: <link> in model 'bad' has no name | write <link name=\"...\"> "
                      "(from DIR/outer/model.sdf:3:17) (from DIR/w.sdf:3:1)",
                      "DIR/w.sdf:4:17: error: frame 'f' is attached to 'nosuch', which is not in world 'w'"}));
}

TEST_F(IncludesTest, SayWhatIsMissing) {
  folder_.write("empty/x.sdf", "");
  folder_.write("odd/model.config", "<model/>");
  folder_.write("gone/model.config", "<model><sdf version='1.9'>m.sdf</sdf></model>");
  write("world.sdf", "<world name='v'/>");
  EXPECT_EQ(loadWorldWith("<include/>\n<include><uri>model://nosuch</uri></include>\n"
                          "<include><uri>empty</uri></include>\n<include><uri>odd</uri></include>\n"
                          "<include><uri>gone</uri></include>\n<include><uri>world.sdf</uri></include>\n"
                          "<joint name='j' type='fixed'><parent>world</parent><child>nosuch</child></joint>")
                .messages,
            (Messages{"DIR/w.sdf:3:1: error: <include> has no <uri> | write <uri>model://NAME</uri>",
                      "DIR/w.sdf:4:10: error: 'model://nosuch' is not found | looked for it at DIR/nosuch, nosuch",
                      "DIR/w.sdf:5:10: error: there is no model.config in 'DIR/empty' | it names the SDF file in a "
                      "model's folder; <uri> can also name the SDF file directly",
                      "DIR/odd/model.config:1:1: error: the model has no <sdf> | write <sdf "
                      "version=\"1.9\">model.sdf</sdf> (from DIR/w.sdf:6:1)",
                      "DIR/gone/m.sdf: error: no such file (from DIR/w.sdf:7:1)",
                      "DIR/world.sdf:1:1: error: this file has no model, light or actor to include | a world can't be "
                      "included (from DIR/w.sdf:8:1)"}));
}

TEST_F(IncludesTest, NeedAPoseWithAPlacementFrame) {
  writeModel("box", "<link name='l'/>");
  EXPECT_EQ(loadWorldWith("<include><uri>box</uri><placement_frame>l</placement_frame></include>").messages,
            Messages{"DIR/w.sdf:3:24: error: <include> has a <placement_frame> but no <pose> | the pose is that of the "
                     "placement frame"});
}

TEST_F(IncludesTest, OfThemselvesAreRefused) {
  writeModel("a", "<include><uri>model://b</uri></include>");
  writeModel("b", "<link name='l'/><include><uri>model://a</uri></include>");
  writeModel("self", "<include><uri>model://self</uri></include>");
  EXPECT_EQ(
      loadWorldWith("<include><uri>model://a</uri></include>\n<include><uri>model://self</uri></include>").messages,
      (Messages{"DIR/b/model.sdf:3:17: error: 'DIR/a/model.sdf' includes 'DIR/b/model.sdf', which includes it "
                "again (from DIR/a/model.sdf:3:1) (from DIR/w.sdf:3:1)",
                "DIR/self/model.sdf:3:1: error: 'DIR/self/model.sdf' includes itself (from DIR/w.sdf:4:1)"}));
}

TEST_F(IncludesTest, AreBoundedInDepth) {
  for (int i = 0; i < 52; ++i) {
    writeModel("n" + std::to_string(i),
               "<link name='l'/><include><uri>model://n" + std::to_string(i + 1) + "</uri></include>");
  }
  const Loaded loaded = loadWorldWith("<include><uri>model://n0</uri></include>");
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_TRUE(loaded.messages[0].starts_with("DIR/n49/model.sdf:3:17: error: includes nest more than 50 deep"))
      << loaded.messages[0];
}

TEST_F(IncludesTest, BoundTheDepthOfModelsAcrossFiles) {
  std::string begin, end;
  for (int i = 0; i < 60; ++i) {
    begin += "<model name='m" + std::to_string(i) + "'><link name='l'/>\n";
    end += "</model>";
  }
  writeModel("b", begin + end + "<link name='l'/>");
  const Loaded loaded = loadModelWith(begin + "<include><uri>model://b</uri></include>" + end);
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_NE(loaded.messages[0].find("error: models nest more than 100 deep"), std::string::npos);
}

TEST_F(IncludesTest, AreBoundedInNumber) {
  // 50^4 includes
  for (int i = 0; i < 4; ++i) {
    std::string content = "<link name='l'/>";
    for (int k = 0; k < 50; ++k) {
      content +=
          "<include><uri>model://f" + std::to_string(i + 1) + "</uri><name>m" + std::to_string(k) + "</name></include>";
    }
    writeModel("f" + std::to_string(i), content);
  }
  writeModel("f4", "<link name='l'/>");
  const Loaded loaded = loadWorldWith("<include><uri>model://f0</uri></include>");
  ASSERT_EQ(loaded.messages.size(), 1U);
  EXPECT_NE(loaded.messages[0].find("error: there are more than 20000 includes"), std::string::npos);
}

TEST_F(IncludesTest, MergeAModelIntoAnother) {
  writeModel(
      "arm",
      "<pose>0 0 1 0 0 0</pose><link name='a'><collision name='c'><pose relative_to='__model__'>0 0 7 0 0 0</pose>"
      "<geometry><sphere/></geometry></collision></link><link name='b'><pose>0 1 0 0 0 0</pose></link>"
      "<frame name='f'/><frame name='g' attached_to='b'/><model name='n'><link name='x'/></model>"
      "<joint name='j' type='revolute'><parent>__model__</parent><child>b</child><axis>"
      "<xyz expressed_in='__model__'>0 0 1</xyz></axis></joint><plugin filename='p' name='P'/>");
  const Loaded loaded = loadModelWith(
      "<link name='base'/><frame name='mount'><pose>2 0 0 0 0 0</pose></frame>"
      "<include merge='true'><uri>model://arm</uri><pose relative_to='mount'>0 0 3 0 0 0</pose></include>"
      "<joint name='k' type='fixed'><parent>base</parent><child>a</child></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Model& model = loaded.model();
  ASSERT_EQ(model.links.size(), 3U);
  expectPose(model.links[1].X_ModelLink, {2, 0, 3});
  expectPose(model.links[1].collisions.at(0).X_LinkCollision, {0, 0, 7});
  expectPose(model.links[2].X_ModelLink, {2, 1, 3});
  ASSERT_EQ(model.frames.size(), 4U);
  EXPECT_EQ(model.frames[1].name, "_merged__arm__model__");
  EXPECT_EQ(model.frames[1].attachedLink, "a");
  expectPose(model.frames[2].X_ModelFrame, {2, 0, 3});
  expectPose(model.frames[3].X_ModelFrame, {2, 1, 3});
  expectPose(model.models.at(0).X_ParentModel, {2, 0, 3});
  ASSERT_EQ(model.joints.size(), 2U);
  EXPECT_EQ(model.joints[0].parent, "a");
  EXPECT_EQ(model.plugins.at(0).filename, "p");
  EXPECT_EQ(model.canonicalLink, "base");
}

TEST_F(IncludesTest, MergeByAPlacementFrameAndWithinAMergedModel) {
  writeModel("tip", "<link name='t'><pose>0 0 1 0 0 0</pose></link>");
  writeModel("arm",
             "<link name='a'/><frame name='f'><pose>1 0 0 0 0 0</pose></frame>"
             "<include merge='1'><uri>model://tip</uri></include>");
  const Loaded loaded = loadModelWith(
      "<link name='base'/><include merge='true'><uri>model://arm</uri><pose>0 5 0 0 0 0</pose>"
      "<placement_frame>f</placement_frame></include>");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(loaded.model().links.at(1).X_ModelLink, {-1, 5, 0});
  expectPose(loaded.model().links.at(2).X_ModelLink, {-1, 5, 1});
}

TEST_F(IncludesTest, MergeModelsJointsFramesAndPluginsIntoAWorld) {
  writeModel("box", "<link name='l'/>");
  writeModel("pair",
             "<include><uri>box</uri><name>a</name></include>"
             "<include><uri>box</uri><name>b</name><pose>0 10 0 0 0 0</pose></include>"
             "<model name='c'><link name='l'/></model><frame name='f'/><frame name='g' attached_to='b'/>"
             "<joint name='j' type='fixed'><parent>f</parent><child>g</child></joint><plugin filename='p' name='P'/>");
  const Loaded loaded = loadWorldWith(
      "<frame name='mount'><pose>0 0 1 0 0 0</pose></frame>"
      "<include merge='true'><uri>pair</uri><pose relative_to='mount'>100 0 0 0 0 0</pose></include>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::World& world = loaded.world();
  ASSERT_EQ(world.models.size(), 3U);
  expectPose(world.models[0].X_ParentModel, {100, 0, 1});
  expectPose(world.models[1].X_ParentModel, {100, 10, 1});
  expectPose(world.models[2].X_ParentModel, {100, 0, 1});
  ASSERT_EQ(world.joints.size(), 1U);
  EXPECT_EQ(world.joints[0].parent, "a::l");
  EXPECT_EQ(world.joints[0].child, "b::l");
  EXPECT_EQ(world.plugins.at(0).filename, "p");
  ASSERT_EQ(world.frames.size(), 4U);
  EXPECT_EQ(world.frames[1].name, "_merged__pair__model__");
  EXPECT_EQ(world.frames[1].attachedLink, "a::l");
}

TEST_F(IncludesTest, MergeNoLinksIntoAWorldAndNothingIntoAFile) {
  writeModel("arm", "<model name='inner'><link name='l'/></model><link name='a'/>");
  EXPECT_EQ(loadWorldWith("<include merge='true'><uri>arm</uri></include>").messages,
            Messages{"DIR/w.sdf:3:1: error: a model with a <link> can't be merged into a world, only models, joints, "
                     "frames and plugins | remove the attribute 'merge'"});
  write("only.sdf", "<include merge='true'><uri>model://arm</uri></include>");
  EXPECT_EQ(loadNamed("only.sdf").messages,
            Messages{"DIR/only.sdf:2:1: error: only a model can be merged, and only into a model or a world | remove "
                     "the attribute 'merge'"});
}

TEST_F(IncludesTest, MergeOnlyModels) {
  writeModel("arm", "<link name='a'/>");
  write("actor.sdf", "<actor name='s'/>");
  EXPECT_EQ(
      loadModelWith("<link name='a'/>\n<include merge='true'><uri>actor.sdf</uri></include>\n"
                    "<include merge='x'><uri>arm</uri></include>\n"
                    "<include merge='true'><uri>arm</uri><name>other</name></include>")
          .messages,
      (Messages{
          "DIR/w.sdf:4:1: error: only a model can be merged, and only into a model or a world | remove the attribute "
          "'merge'",
          "DIR/w.sdf:5:10: error: attribute 'merge' is 'x', which is not 'true' or 'false'",
          "DIR/arm/model.sdf:3:1: error: link 'a' has the same name as another link of model 'm' | the "
          "first one is in DIR/w.sdf, line 3 (from DIR/w.sdf:6:1)"}));
}

TEST_F(IncludesTest, MayStandOutsideOfAWorld) {
  writeModel("crate", "<pose>0 0 1 0 0 0</pose><link name='l'/>");
  write("only.sdf", "<include><uri>model://crate</uri><name>box</name><pose>0 0 2 0 0 0</pose></include>");
  Loaded loaded = loadNamed("only.sdf");
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_EQ(loaded.root.models.size(), 1U);
  EXPECT_EQ(loaded.root.models[0].name, "box");
  expectPose(loaded.root.models[0].X_ParentModel, {0, 0, 2});
  // such a file can be included in turn
  loaded =
      loadWorldWith("<include><uri>only.sdf</uri><name>top</name></include><include><uri>only.sdf</uri></include>");
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_EQ(loaded.world().models.size(), 2U);
  EXPECT_EQ(loaded.world().models[0].name, "top");
  expectPose(loaded.world().models[0].X_ParentModel, {0, 0, 2});
  EXPECT_EQ(loaded.world().models[1].name, "box");
}

TEST_F(IncludesTest, MayNotIncludeEachOtherFromTheRoot) {
  write("a.sdf", "<include><uri>b.sdf</uri></include>");
  write("b.sdf", "<include><uri>a.sdf</uri></include>");
  EXPECT_EQ(
      loadNamed("a.sdf").messages,
      Messages{"DIR/b.sdf:2:1: error: 'DIR/a.sdf' includes 'DIR/b.sdf', which includes it again (from DIR/a.sdf:2:1)"});
}

TEST_F(IncludesTest, ReportAFaultOnceWhateverTheModelsAreCalled) {
  writeModel("base",
             "<link name='l'><visual name='v'><geometry><mesh><uri>gone.dae</uri></mesh></geometry></visual></link>");
  writeModel("mid", "<include merge='true'><uri>model://base</uri></include>");
  const Loaded loaded = loadWorldWith("<include><uri>model://mid</uri><name>top</name></include>");
  EXPECT_EQ(loaded.messages.size(), 1U);
}

}  // namespace
}  // namespace pongsim::sdf::test
