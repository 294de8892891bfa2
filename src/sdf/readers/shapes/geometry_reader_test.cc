#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Geometry, ReadsTheFourShapes) {
  const Loaded loaded = loadLink(
      "<collision name='b'><geometry><box><size>1 2 3</size></box></geometry></collision>"
      "<collision name='s'><geometry><sphere><radius>0.5</radius></sphere></geometry></collision>"
      "<collision name='c'><geometry><cylinder><radius>2</radius><length>3</length></cylinder></geometry></collision>"
      "<collision name='p'><geometry><plane><normal>0 3 4</normal><size>5 6</size></plane></geometry></collision>"
      "<collision name='e'><geometry><empty/></geometry></collision>");
  EXPECT_EQ(loaded.messages, Messages());
  const auto& collisions = loaded.model().links.at(0).collisions;
  EXPECT_EQ(std::get<description::Box>(collisions.at(0).geometry).size, Vector3(1, 2, 3));
  EXPECT_EQ(std::get<description::Sphere>(collisions.at(1).geometry).radius, 0.5);
  EXPECT_EQ(std::get<description::Cylinder>(collisions.at(2).geometry).radius, 2);
  EXPECT_EQ(std::get<description::Cylinder>(collisions.at(2).geometry).length, 3);
  const auto& plane = std::get<description::Plane>(collisions.at(3).geometry);
  EXPECT_LT((plane.normal - Vector3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(plane.size, Eigen::Vector2d(5, 6));
  EXPECT_TRUE(std::holds_alternative<description::Empty>(collisions.at(4).geometry));
}

TEST(Geometry, ReadsCapsulesAndEllipsoids) {
  const Loaded loaded = loadLink(
      "<collision name='a'><geometry><capsule><radius>2</radius><length>3</length></capsule></geometry></collision>"
      "<collision name='b'><geometry><capsule/></geometry></collision>"
      "<collision name='c'><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry></collision>\n"
      "<collision name='d'><geometry><ellipsoid><radii>1 -2 3</radii></ellipsoid></geometry></collision>");
  EXPECT_EQ(loaded.messages,
            Messages{"t.sdf:5:42: error: <radii> is '1 -2 3', which is not three finite numbers above zero"});
  const auto& collisions = loaded.model().links.at(0).collisions;
  EXPECT_EQ(std::get<description::Capsule>(collisions.at(0).geometry).radius, 2);
  EXPECT_EQ(std::get<description::Capsule>(collisions.at(0).geometry).length, 3);
  EXPECT_EQ(std::get<description::Capsule>(collisions.at(1).geometry).radius, 0.5);
  EXPECT_EQ(std::get<description::Ellipsoid>(collisions.at(2).geometry).radii, Vector3(1, 2, 3));
}

TEST(Geometry, MayBeACone) {
  const Loaded loaded = loadLink(
      "<collision name='a'><geometry><cone><radius>2</radius><length>3</length></cone></geometry></collision>"
      "<visual name='v'><geometry><cone/></geometry></visual>\n"
      "<visual name='w'><geometry><cone><length>0</length></cone></geometry></visual>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:5:34: error: <length> is '0', which is not a finite number above zero"});
  const description::Link& link = loaded.model().links.at(0);
  EXPECT_EQ(std::get<description::Cone>(link.collisions.at(0).geometry), (description::Cone{2, 3}));
  EXPECT_EQ(std::get<description::Cone>(link.visuals.at(0).geometry), (description::Cone{1, 1}));
}

TEST(Geometry, HasTheDefaultsOfTheFormat) {
  const Loaded loaded = loadLink(
      "<visual name='b'><geometry><box/></geometry></visual>"
      "<visual name='p'><geometry><plane/></geometry></visual>");
  EXPECT_EQ(loaded.messages, Messages());
  const auto& visuals = loaded.model().links.at(0).visuals;
  EXPECT_EQ(std::get<description::Box>(visuals.at(0).geometry).size, Vector3(1, 1, 1));
  EXPECT_EQ(std::get<description::Plane>(visuals.at(1).geometry).normal, Vector3(0, 0, 1));
}

TEST(Geometry, ReadsImagesThoughTheyDoNotCollide) {
  const pongsim::test::TempFolder folder;
  const std::string uri = "<uri>" + folder.write("i.png", "x").string() + "</uri>";
  const Loaded loaded = loadLink("<collision name='c'><geometry><image>" + uri +
                                 "<scale>2</scale><threshold>100</threshold><height>3</height>"
                                 "<granularity>4</granularity></image></geometry></collision>\n"
                                 "<visual name='v'><geometry><image>" +
                                 uri + "</image></geometry></visual>");
  EXPECT_EQ(
      loaded.messages,
      Messages{"t.sdf:4:1: warning: collision 'c' has an image, which Fortress does not support: it will not collide"
               " | a <heightmap> can be made from an image"});
  const auto& image = std::get<description::Image>(loaded.model().links.at(0).collisions.at(0).geometry);
  EXPECT_EQ(image.file, folder.path() / "i.png");
  EXPECT_EQ(image.scale, 2);
  EXPECT_EQ(image.threshold, 100);
  EXPECT_EQ(image.height, 3);
  EXPECT_EQ(image.granularity, 4);
}

TEST(Geometry, RefusesSizesThatNothingHas) {
  const Loaded loaded = loadLink(
      "<collision name='a'><geometry><box><size>1 0 1</size></box></geometry></collision>\n"
      "<collision name='b'><geometry><sphere><radius>-1</radius></sphere></geometry></collision>\n"
      "<collision name='c'><geometry><cylinder><length>nan</length></cylinder></geometry></collision>\n"
      "<collision name='d'><geometry><plane><normal>0 0 0</normal></plane></geometry></collision>\n"
      "<collision name='e'><geometry><box><size>1 2</size></box></geometry></collision>");
  EXPECT_EQ(
      loaded.messages,
      (Messages{"t.sdf:4:36: error: <size> is '1 0 1', which is not three finite numbers above zero",
                "t.sdf:5:39: error: <radius> is '-1', which is not a finite number above zero",
                "t.sdf:6:41: error: <length> is 'nan', which is not a finite number above zero",
                "t.sdf:7:38: error: the plane of collision 'd' of link 'l' of model 'm' has a normal of length zero",
                "t.sdf:8:36: error: <size> is '1 2', which is not three finite numbers | there are 2 numbers"}));
}

TEST(Geometry, WarnsWhereThereIsNoShape) {
  const Loaded loaded = loadLink("<visual name='v'/>\n<collision name='c'><geometry/></collision>");
  const std::string hint = " | add <box>, <sphere>, <cylinder>, <plane>, ...";
  EXPECT_EQ(
      loaded.messages,
      (Messages{"t.sdf:4:1: warning: visual 'v' of link 'l' of model 'm' has no <geometry>: it will not be seen" + hint,
                "t.sdf:5:21: warning: collision 'c' of link 'l' of model 'm' has no shape in its <geometry>: it will "
                "not collide" +
                    hint}));
}

}  // namespace
}  // namespace pongsim::sdf::test
