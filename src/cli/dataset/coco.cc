#include "cli/dataset/coco.hh"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

namespace pongsim::cli {

namespace {

using OrderedJson = nlohmann::ordered_json;
namespace fs = std::filesystem;

fs::path relativeTo(const fs::path& folder, const fs::path& picture) {
  std::error_code error;
  const fs::path relative = fs::relative(picture, folder, error);
  return error || relative.empty() ? fs::absolute(picture) : relative;
}

OrderedJson annotationOf(const LabelledThing& thing, const Sample& sample) {
  const Eigen::Vector2d corner = thing.box.min(), size = thing.box.sizes();
  OrderedJson annotation{{"category_id", thing.label},
                         {"bbox", {corner.x(), corner.y(), size.x(), size.y()}},
                         {"area", size.x() * size.y()},
                         {"iscrowd", thing.isCrowd ? 1 : 0},
                         {"segmentation", OrderedJson::array()}};
  if (thing.mask) {
    annotation["area"] = thing.mask->area;
    annotation["segmentation"] = {{"counts", thing.mask->runs}, {"size", {sample.height, sample.width}}};
  }
  return annotation;
}

}  // namespace

std::string nameOf(int label, const LabelNames& names) {
  const auto found = names.find(label);
  return found == names.end() ? "label_" + std::to_string(label) : found->second;
}

std::string cocoOf(std::span<const Sample> samples, const fs::path& folder, const LabelNames& names) {
  OrderedJson images = OrderedJson::array(), annotations = OrderedJson::array(), categories = OrderedJson::array();
  std::set<int> labels;
  std::uint64_t image = 0, annotation = 0;
  for (const Sample& sample : samples) {
    images.push_back({{"id", ++image},
                      {"file_name", relativeTo(folder, sample.picture).string()},
                      {"width", sample.width},
                      {"height", sample.height}});
    for (const LabelledThing& thing : sample.things) {
      OrderedJson entry{{"id", ++annotation}, {"image_id", image}};
      entry.update(annotationOf(thing, sample));
      annotations.push_back(std::move(entry));
      labels.insert(thing.label);
    }
  }
  for (const int label : labels) categories.push_back({{"id", label}, {"name", nameOf(label, names)}});
  const OrderedJson all{
      {"images", std::move(images)}, {"annotations", std::move(annotations)}, {"categories", std::move(categories)}};
  return all.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace pongsim::cli
