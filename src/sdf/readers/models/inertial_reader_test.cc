#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

std::string inertia(double xx, double yy, double zz, double xy = 0) {
  const auto tag = [](const char* name, double value) {
    return "<" + std::string(name) + ">" + std::to_string(value) + "</" + name + ">";
  };
  return "<inertial><inertia>" + tag("ixx", xx) + tag("iyy", yy) + tag("izz", zz) + tag("ixy", xy) +
         "</inertia></inertial>";
}

TEST(Inertial, IsReadInFull) {
  const Loaded loaded = loadLink(
      "<inertial><mass>2.5</mass><pose>1 2 3 0 0 0</pose><inertia><ixx>4</ixx><iyy>5</iyy><izz>6</izz>"
      "<ixy>0.1</ixy><ixz>0.2</ixz><iyz>0.3</iyz></inertia></inertial>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Inertial& inertial = loaded.model().links.at(0).inertial;
  EXPECT_EQ(inertial.mass, 2.5);
  expectPose(inertial.X_LinkCom, {1, 2, 3});
  Matrix3 expected;
  expected << 4, 0.1, 0.2, 0.1, 5, 0.3, 0.2, 0.3, 6;
  EXPECT_EQ(inertial.moments, expected);
}

std::string addedMass(const std::string& elements) {
  return "<inertial><mass>2</mass>\n<fluid_added_mass>" + elements + "</fluid_added_mass></inertial>";
}

TEST(Inertial, HasTheAddedMassOfAFluid) {
  const Loaded loaded = loadLink(
      addedMass("<xx>11</xx><xy>0.12</xy><xz>0.13</xz><xp>0.14</xp><xq>0.15</xq><xr>0.16</xr><yy>22</yy><yz>0.23</yz>"
                "<yp>0.24</yp><yq>0.25</yq><yr>0.26</yr><zz>33</zz><zp>0.34</zp><zq>0.35</zq><zr>0.36</zr><pp>44</pp>"
                "<pq>0.45</pq><pr>0.46</pr><qq>55</qq><qr>0.56</qr><rr>66</rr>"));
  EXPECT_EQ(loaded.messages, Messages());
  const auto& added = loaded.model().links.at(0).inertial.addedMass;
  ASSERT_TRUE(added);
  for (int row = 0; row < 6; ++row) {
    EXPECT_EQ((*added)(row, row), 11 * (row + 1));
    for (int column = row + 1; column < 6; ++column) {
      EXPECT_DOUBLE_EQ((*added)(row, column), (row + 1) * 0.1 + (column + 1) * 0.01) << row << ' ' << column;
      EXPECT_EQ((*added)(row, column), (*added)(column, row));
    }
  }
  EXPECT_FALSE(loadLink("<inertial/>").model().links.at(0).inertial.addedMass);
}

TEST(Inertial, LeavesOutAnAddedMassThatNoBodyCanHave) {
  const Messages refused{
      "t.sdf:5:1: warning: the <fluid_added_mass> of link 'l' of model 'm' is left out | with mass and inertia, its "
      "matrix must be positive definite, and no element be beyond 1e30"};
  for (const char* bad : {"<xx>-2</xx>", "<xy>2</xy>", "<qq>-1</qq>", "<zz>1e31</zz>"}) {
    const Loaded loaded = loadLink(addedMass(bad));
    EXPECT_EQ(loaded.messages, refused) << bad;
    EXPECT_FALSE(loaded.model().links.at(0).inertial.addedMass) << bad;
  }
  // together with the mass of 2 kg it is positive
  EXPECT_TRUE(loadLink(addedMass("<xx>-1.9</xx>")).model().links.at(0).inertial.addedMass);
}

TEST(Inertial, IsAUnitWhereThereIsNone) {
  const Loaded loaded = loadLink("");
  const description::Inertial& inertial = loaded.model().links.at(0).inertial;
  EXPECT_EQ(inertial.mass, 1);
  EXPECT_EQ(inertial.moments, Matrix3(Matrix3::Identity()));
}

TEST(Inertial, RefusesAMassBeyondAllStars) {
  const Messages messages = loadLink("<inertial><mass>1e31</mass></inertial>").messages;
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("is beyond 1e30 kg"), std::string::npos) << messages[0];
}

TEST(Inertial, NeedsAMass) {
  EXPECT_EQ(loadLink("<inertial><mass>0</mass></inertial>").messages,
            Messages{"t.sdf:4:11: error: <mass> is '0', which is not a finite number above zero"});
  EXPECT_EQ(loadLink("<inertial><mass>two</mass></inertial>").messages,
            Messages{"t.sdf:4:11: error: <mass> is 'two', which is not a number"});
}

TEST(Inertial, MustBePositiveDefinite) {
  const Messages refused{
      "t.sdf:4:11: error: the inertia of link 'l' of model 'm' is not positive definite | ixx, iyy and izz must be "
      "above zero, and ixy, ixz and iyz small enough"};
  EXPECT_EQ(loadLink(inertia(-1, 1, 1)).messages, refused);
  EXPECT_EQ(loadLink(inertia(1, 1, 1, 1.5)).messages, refused);
}

// libsdformat takes these, too
TEST(Inertial, MayBeThatOfAThinRodOrAPoint) {
  const Loaded rod = loadLink(inertia(1, 0, 1));
  EXPECT_EQ(rod.messages, Messages());
  EXPECT_EQ(rod.model().links.at(0).inertial.moments.diagonal(), Vector3(1, 1e-6, 1));
  // along the diagonal of x and y
  const Loaded turned = loadLink(inertia(0.5, 0.5, 1, 0.5));
  EXPECT_EQ(turned.messages, Messages());
  const Matrix3 moments = turned.model().links.at(0).inertial.moments;
  EXPECT_NEAR(moments(0, 0) - moments(0, 1), 1e-6, 1e-12);
  EXPECT_NEAR(moments(0, 0) + moments(0, 1), 1, 1e-12);
  const Loaded point = loadLink(inertia(0, 0, 0));
  EXPECT_EQ(point.messages, Messages{"t.sdf:4:11: warning: the inertia of link 'l' of model 'm' is zero: that of a "
                                     "body of 1 mm is used"});
  EXPECT_EQ(point.model().links.at(0).inertial.moments, Matrix3(1e-6 * Matrix3::Identity()));
}

TEST(Inertial, ShouldBeThatOfABody) {
  EXPECT_EQ(loadLink(inertia(1, 1, 3)).messages,
            Messages{"t.sdf:4:11: warning: the inertia of link 'l' of model 'm' is impossible | no principal moment "
                     "can exceed the sum of the other two"});
  EXPECT_EQ(loadLink(inertia(1, 1, 2)).messages, Messages());
  EXPECT_EQ(loadLink(inertia(1, 1, 1, 0.3)).messages, Messages());
}

TEST(Inertial, MeansNothingInAStaticModel) {
  EXPECT_EQ(loadModel("<static>true</static><link name='l'><inertial><mass>0</mass><inertia><ixx>0</ixx></inertia>"
                      "</inertial></link>")
                .messages,
            Messages());
}

}  // namespace
}  // namespace pongsim::sdf::test
