#include "sdf/readers/models/auto_inertia.hh"

#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

/// @param inertial Attributes and content of the `<inertial>`.
Loaded loadAutomatic(const std::string& inertial, const std::string& rest) {
  return loadModel("<link name='l'>\n<inertial auto='true'>" + inertial + "</inertial>\n" + rest + "\n</link>", "1.11");
}

std::string boxCollision(const std::string& name, const std::string& more = "") {
  return "<collision name='" + name + "'>" + more + "<geometry><box><size>1 2 3</size></box></geometry></collision>";
}

const description::Inertial& inertialOf(const Loaded& loaded) { return loaded.model().links.at(0).inertial; }

TEST(AutoInertia, IsThatOfTheCollisions) {
  const Loaded loaded = loadAutomatic("", boxCollision("c", "<pose>0 0 1 0 0 0</pose>"));
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_DOUBLE_EQ(inertialOf(loaded).mass, 6000);
  expectPose(inertialOf(loaded).X_LinkCom, {0, 0, 1});
  EXPECT_LT((inertialOf(loaded).moments.diagonal() - 500 * Vector3(13, 10, 5)).norm(), 1e-9);
}

TEST(AutoInertia, TakesTheDensityOfTheCollisionThenThatOfTheLink) {
  const std::string density = "<density>100</density>";
  EXPECT_DOUBLE_EQ(inertialOf(loadAutomatic(density, boxCollision("c"))).mass, 600);
  const Loaded both = loadAutomatic(density, boxCollision("c", "<density>10</density>") + boxCollision("d"));
  EXPECT_DOUBLE_EQ(inertialOf(both).mass, 660);
}

TEST(AutoInertia, IsScaledToTheGivenMass) {
  const Loaded loaded = loadAutomatic("<mass>12</mass>", boxCollision("c"));
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_DOUBLE_EQ(inertialOf(loaded).mass, 12);
  EXPECT_LT((inertialOf(loaded).moments.diagonal() - Vector3(13, 10, 5)).norm(), 1e-9);
}

TEST(AutoInertia, PlacesCollisionsInTheFramesThatTheyName) {
  const Loaded loaded =
      loadModel("<link name='l'><inertial auto='true'/>" + boxCollision("c", "<pose relative_to='f'/>") +
                    "</link><frame name='f'><pose>0 5 0 1.5707963267948966 0 0</pose></frame>",
                "1.11");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(inertialOf(loaded).X_LinkCom, {0, 5, 0});
  EXPECT_LT((inertialOf(loaded).moments.diagonal() - 500 * Vector3(13, 5, 10)).norm(), 1e-9);
}

TEST(AutoInertia, HasNoAddedMass) {
  const Loaded loaded = loadAutomatic("<fluid_added_mass><xx>1</xx></fluid_added_mass>", boxCollision("c"));
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:4:23: warning: the <fluid_added_mass> of link 'l' of model 'm' is "
                                      "ignored, as in Gazebo: an inertia with auto=\"true\" has none"});
  EXPECT_FALSE(inertialOf(loaded).addedMass);
}

TEST(AutoInertia, IgnoresAGivenInertia) {
  const Loaded loaded = loadAutomatic("<pose>1 0 0 0 0 0</pose><inertia><ixx>7</ixx></inertia>", boxCollision("c"));
  EXPECT_EQ(loaded.messages, (Messages{"t.sdf:4:23: warning: the <pose> of the inertia of link 'l' of model 'm' is "
                                       "ignored: auto=\"true\" computes it",
                                       "t.sdf:4:47: warning: the <inertia> of the inertia of link 'l' of model 'm' is "
                                       "ignored: auto=\"true\" computes it"}));
  EXPECT_DOUBLE_EQ(inertialOf(loaded).moments(0, 0), 6500);
}

TEST(AutoInertia, NeedsCollisionsWithAVolume) {
  EXPECT_EQ(loadAutomatic("", "").messages,
            Messages{"t.sdf:4:1: error: the inertia of link 'l' can't be computed: it has no collision | give <mass> "
                     "and <inertia>, or add a <collision>"});
  const std::string plane = "<collision name='p'><geometry><plane/></geometry></collision>";
  const std::string warning =
      "t.sdf:5:1: warning: collision 'p' has no volume: it does not count in the inertia of link 'l'";
  EXPECT_EQ(loadAutomatic("", plane).messages,
            (Messages{"t.sdf:4:1: error: the inertia of link 'l' can't be computed: its collisions have no volume | "
                      "give <mass> and <inertia>",
                      warning}));
  const Loaded one = loadAutomatic("", plane + boxCollision("c"));
  EXPECT_EQ(one.messages, Messages{warning});
  EXPECT_DOUBLE_EQ(inertialOf(one).mass, 6000);
  EXPECT_EQ(loadAutomatic("<density>0</density>", boxCollision("c")).messages,
            Messages{"t.sdf:4:23: error: <density> is '0', which is not a finite number above zero"});
}

TEST(AutoInertia, RefusesAMassBeyondAllStars) {
  const Messages refused{"t.sdf:4:1: error: the computed mass of link 'l' is beyond 1e30 kg"};
  EXPECT_EQ(loadAutomatic("<density>1e31</density>", boxCollision("c")).messages, refused);
  EXPECT_EQ(loadAutomatic("<mass>1e31</mass>", boxCollision("c")).messages, refused);
}

TEST(AutoInertia, OfAMeshIsThatOfItsVolume) {
  const pongsim::test::TempFolder folder;
  // the corner of a cube of 6 m, whose inertia is known, and the same without one of its sides
  const std::string vertices = "v 0 0 0\nv 6 0 0\nv 0 6 0\nv 0 0 6\n", sides = "f 1 3 2\nf 1 2 4\nf 1 4 3\n";
  folder.write("closed.obj", vertices + sides + "f 2 3 4\n");
  folder.write("open.obj", vertices + sides);
  const auto loadMesh = [&](const std::string& file) {
    return loadAutomatic("", "<collision name='c'><geometry><mesh><uri>" + (folder.path() / file).string() +
                                 "</uri></mesh></geometry></collision>");
  };
  const Loaded closed = loadMesh("closed.obj");
  EXPECT_EQ(closed.messages, Messages());
  EXPECT_NEAR(inertialOf(closed).mass, 36'000, 1e-6);
  expectPose(inertialOf(closed).X_LinkCom, {1.5, 1.5, 1.5});
  // 3/40 m a^2 on the diagonal, m a^2 / 80 beside it
  const double square = 36'000 * 36.0;
  Matrix3 expected = Matrix3::Constant(square / 80);
  expected.diagonal().setConstant(square * 3 / 40);
  EXPECT_LT((inertialOf(closed).moments - expected).norm() / square, 1e-9) << inertialOf(closed).moments;
  EXPECT_EQ(loadMesh("open.obj").messages,
            Messages{"t.sdf:5:1: warning: the mesh of collision 'c' is not closed: the inertia of link 'l' is that of "
                     "the volume between the middle of the mesh and its surface | close the mesh, or give <mass> and "
                     "<inertia>"});
}

TEST(AutoInertia, IsNotNeededInAStaticModel) {
  EXPECT_EQ(loadModel("<static>true</static><link name='l'><inertial auto='true'/></link>", "1.11").messages,
            Messages());
}

}  // namespace
}  // namespace pongsim::sdf::test
