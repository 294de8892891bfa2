#include "web/pictures/picture_wish.hh"

#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

namespace pongsim::web {
namespace {

using nlohmann::json;

json wish() {
  return {{"pose", {1, 2, 3, 0, 0, 0, 2}}, {"fieldOfView", 1}, {"width", 320}, {"height", 200}, {"grid", true}};
}

TEST(PictureWish, IsAPinholeAtThePose) {
  const auto found = readPictureWish(wish());
  ASSERT_TRUE(found) << found.error;
  EXPECT_EQ(found.value->X_WorldEye.position, Vector3(1, 2, 3));
  EXPECT_DOUBLE_EQ(found.value->X_WorldEye.rotation.w(), 1);
  EXPECT_DOUBLE_EQ(found.value->fy, 100 / std::tan(0.5));
  EXPECT_EQ(found.value->cx, 160);
  EXPECT_TRUE(found.value->showsGrid);
}

TEST(PictureWish, RefusesWhatNoCameraIs) {
  const auto refused = [](const char* name, const json& value) {
    json changed = wish();
    changed[name] = value;
    return readPictureWish(changed).error;
  };
  EXPECT_NE(refused("pose", {1, 2, 3}), "");
  EXPECT_NE(refused("pose", {1, 2, 1e300, 0, 0, 0, 1}), "");
  EXPECT_NE(refused("pose", {1, 2, 3, 0, 0, 0, 0}), "");
  EXPECT_NE(refused("pose", "here"), "");
  EXPECT_NE(refused("pose", {1, 2, "3", 0, 0, 0, 1}), "");
  EXPECT_NE(refused("width", 15), "");
  EXPECT_NE(refused("width", 1281), "");
  EXPECT_NE(refused("height", -1), "");
  EXPECT_NE(refused("height", 99.5), "");
  EXPECT_NE(refused("fieldOfView", 0), "");
  EXPECT_NE(refused("fieldOfView", 3.2), "");
  EXPECT_EQ(refused("grid", "yes"), "");
  EXPECT_NE(readPictureWish(json::array()).error, "");
  EXPECT_NE(readPictureWish(json()).error, "");
}

}  // namespace
}  // namespace pongsim::web
