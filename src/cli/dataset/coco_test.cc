#include "cli/dataset/coco.hh"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace pongsim::cli {
namespace {

using nlohmann::json;

TEST(Coco, NamesPicturesBoxesAndMasks) {
  LabelledThing box{.label = 7, .box = {Eigen::Vector2d(1, 2), Eigen::Vector2d(4, 8)}};
  LabelledThing outlined{
      .label = 9, .box = {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2)}, .mask = Mask{{0, 2, 10}, 2}};
  outlined.isCrowd = true;
  const std::vector<Sample> samples{{"/data/a/images/image_0000000.png", 4, 3, {box}},
                                    {"/data/b/images/image_0000000.png", 4, 3, {box, outlined}}};
  const json all = json::parse(cocoOf(samples, "/data", {{7, "car"}}));
  EXPECT_EQ(all["images"], json::parse(R"([
    {"id": 1, "file_name": "a/images/image_0000000.png", "width": 4, "height": 3},
    {"id": 2, "file_name": "b/images/image_0000000.png", "width": 4, "height": 3}])"));
  EXPECT_EQ(all["annotations"], json::parse(R"([
    {"id": 1, "image_id": 1, "category_id": 7, "bbox": [1.0, 2.0, 3.0, 6.0], "area": 18.0, "iscrowd": 0,
     "segmentation": []},
    {"id": 2, "image_id": 2, "category_id": 7, "bbox": [1.0, 2.0, 3.0, 6.0], "area": 18.0, "iscrowd": 0,
     "segmentation": []},
    {"id": 3, "image_id": 2, "category_id": 9, "bbox": [0.0, 0.0, 1.0, 2.0], "area": 2, "iscrowd": 1,
     "segmentation": {"counts": [0, 2, 10], "size": [3, 4]}}])"));
  EXPECT_EQ(all["categories"], json::parse(R"([{"id": 7, "name": "car"}, {"id": 9, "name": "label_9"}])"));
}

}  // namespace
}  // namespace pongsim::cli
