#include "cli/dataset/sample_reader.hh"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "assets/images/picture_file.hh"
#include "base/parse_number.hh"
#include "cli/dataset/label_map.hh"

namespace pongsim::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kImageTable = "label,x_center,y_center,width,height";
constexpr std::string_view kSpaceTable = "label,x,y,z,w,h,l,roll,pitch,yaw";
/// The numbers behind the label.
constexpr std::size_t kImageNumbers = 4, kSpaceNumbers = 9;

SourcePosition in(const fs::path& file, int line = 0) {
  return {std::make_shared<const std::string>(file.string()), line, 0};
}

/// @return "0000012", of image_0000012.png.
std::string sampleNumber(const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem.substr(stem.find('_') + 1);
}

/// @return The pictures in a folder, in the order of their numbers.
std::vector<fs::path> picturesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (auto entry = fs::directory_iterator(folder, ignored); entry != fs::directory_iterator();
       entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("image_") && name.ends_with(".png")) files.push_back(entry->path());
  }
  // more than seven digits come behind
  std::ranges::sort(files, {}, [](const fs::path& file) { return std::pair(sampleNumber(file).size(), file); });
  return files;
}

/// @return The numbers of a row; nothing if there are not that many, or one is not finite.
std::optional<std::vector<double>> numbersOf(std::string_view row, std::size_t count) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view field = row.substr(0, row.find(','));
    const std::optional<double> number = base::parseDouble(field);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
    if (field.size() == row.size()) break;
    row.remove_prefix(field.size() + 1);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

/// Visible boxes name their last column and row, which are whole numbers; full ones their edges.
Eigen::AlignedBox2d imageBox(std::span<const double> numbers) {
  const Eigen::Vector2d centre(numbers[0], numbers[1]), size(numbers[2], numbers[3]);
  Eigen::AlignedBox2d box(centre - size / 2, centre + size / 2);
  const auto isWhole = [](double number) { return number == std::round(number); };
  if (isWhole(box.min().x()) && isWhole(box.min().y()) && isWhole(box.max().x()) && isWhole(box.max().y())) {
    box.max() += Eigen::Vector2d::Ones();
  }
  return box;
}

BoxInSpace spaceBox(std::span<const double> numbers) {
  return {{{numbers[0], numbers[1], numbers[2]}, fromRollPitchYaw(numbers[6], numbers[7], numbers[8])},
          {numbers[3], numbers[4], numbers[5]}};
}

/// Adds the boxes of a table.
/// @return Whether it could be read; a warning says why not.
bool readTable(const fs::path& file, Sample& sample, Diagnostics& diagnostics) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const bool isInSpace = line == kSpaceTable;
  if (!stream || (!isInSpace && line != kImageTable)) {
    diagnostics.warning(in(file, 1), "this is no table of boxes: '" + sample.picture.string() + "' is left out");
    return false;
  }
  for (int number = 2; std::getline(stream, line); ++number) {
    const auto numbers = numbersOf(line, 1 + (isInSpace ? kSpaceNumbers : kImageNumbers));
    const std::size_t firstLength = isInSpace ? 4 : 3, lastLength = isInSpace ? 6 : 4;
    const bool isSound = numbers && numbers->front() >= 0 && numbers->front() <= 255 &&
                         numbers->front() == std::round(numbers->front()) &&
                         std::all_of(numbers->begin() + static_cast<std::ptrdiff_t>(firstLength),
                                     numbers->begin() + static_cast<std::ptrdiff_t>(lastLength) + 1,
                                     [](double length) { return length >= 0; });
    if (!isSound) {
      diagnostics.warning(in(file, number), "'" + line + "' is no box: '" + sample.picture.string() + "' is left out");
      return false;
    }
    LabelledThing& thing = sample.things.emplace_back();
    thing.label = static_cast<int>(numbers->front());
    const std::span<const double> rest = std::span(*numbers).subspan(1);
    if (isInSpace) {
      thing.space = spaceBox(rest);
    } else {
      thing.box = imageBox(rest);
    }
  }
  return true;
}

/// Adds what a map of labels shows.
bool readMap(const fs::path& file, Sample& sample, Diagnostics& diagnostics) {
  const auto map = assets::readPicture(file);
  const std::string isLeftOut = ": '" + sample.picture.string() + "' is left out";
  if (const auto* problem = std::get_if<assets::Problem>(&map)) {
    diagnostics.warning(in(file), "the map of labels " + problem->text + isLeftOut, problem->hint);
    return false;
  }
  const auto& picture = std::get<assets::Picture>(map);
  if (picture.width != sample.width || picture.height != sample.height) {
    diagnostics.warning(in(file), "the map of labels has another size than its picture" + isLeftOut);
    return false;
  }
  sample.things = thingsIn(picture);
  return true;
}

}  // namespace

std::vector<Sample> readSamples(const fs::path& folder, Diagnostics& diagnostics) {
  std::error_code ignored;
  const bool hasMaps = fs::is_directory(folder / "labels_maps", ignored);
  const bool hasBoxes = fs::is_directory(folder / "boxes", ignored);
  const std::vector<fs::path> pictures = picturesIn(folder / "images");
  if (pictures.empty() || (!hasMaps && !hasBoxes)) {
    diagnostics.error({}, "'" + folder.string() + "' has no samples of a segmentation or bounding-box camera",
                      "name the <path> of its <save>: a folder with images, and boxes or labels_maps");
    return {};
  }
  std::vector<Sample> samples;
  for (const fs::path& picture : pictures) {
    const auto read = assets::readPicture(picture);
    if (const auto* problem = std::get_if<assets::Problem>(&read)) {
      diagnostics.warning(in(picture), "this picture " + problem->text + ": it is left out", problem->hint);
      continue;
    }
    Sample sample{picture, std::get<assets::Picture>(read).width, std::get<assets::Picture>(read).height, {}};
    const fs::path labels = hasMaps ? folder / "labels_maps" / ("labels_" + sampleNumber(picture) + ".png")
                                    : folder / "boxes" / ("boxes_" + sampleNumber(picture) + ".csv");
    if (!fs::exists(labels, ignored)) {
      diagnostics.warning(in(picture), "'" + labels.string() + "' is missing: this picture is left out");
      continue;
    }
    if (hasMaps ? readMap(labels, sample, diagnostics) : readTable(labels, sample, diagnostics)) {
      samples.push_back(std::move(sample));
    }
  }
  return samples;
}

}  // namespace pongsim::cli
