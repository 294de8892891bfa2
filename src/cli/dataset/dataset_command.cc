#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/parse_number.hh"
#include "cli/command.hh"
#include "cli/dataset/coco.hh"
#include "cli/dataset/kitti.hh"
#include "cli/dataset/sample_reader.hh"
#include "cli/files/diagnostic_report.hh"
#include "cli/options/number_option.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

namespace fs = std::filesystem;

struct DatasetOptions {
  /// Of samples.
  std::vector<std::string> folders;
  std::string coco;
  std::string kitti;
  LabelNames names;
  /// Horizontal field of view [rad]; 0: not given.
  double fieldOfView = 0;
};

/// Parses "7=car".
void readName(const std::string& text, LabelNames& names) {
  constexpr int kMostLabel = 255;
  const std::size_t sign = text.find('=');
  const auto label = base::parseInteger(text.substr(0, sign));
  if (sign == std::string::npos || !label || *label < 0 || *label > kMostLabel || sign + 1 == text.size()) {
    throw UsageError("option '--name' takes LABEL=NAME, such as 7=car, not '" + text + "'");
  }
  names[static_cast<int>(*label)] = text.substr(sign + 1);
}

/// @throws Failure
void writeFile(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw Failure("'" + file.string() + "' can't be written");
}

int writeCoco(const DatasetOptions& options, const std::vector<Sample>& samples) {
  const auto isInSpace = [](const LabelledThing& thing) { return thing.space.has_value(); };
  for (const Sample& sample : samples) {
    if (!std::ranges::any_of(sample.things, isInSpace)) continue;
    return fail("boxes in space have no place in COCO's format", "use --kitti, or a camera with 2d boxes");
  }
  writeFile(options.coco, cocoOf(samples, fs::absolute(options.coco).parent_path(), options.names));
  return kDone;
}

/// @throws Failure
void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Failure("the folder '" + folder.string() + "' can't be made: " + error.message());
}

int writeKitti(const DatasetOptions& options, const std::vector<Sample>& samples) {
  const fs::path folder = options.kitti;
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_empty(folder, error)) {
    return fail("the folder '" + folder.string() + "' is not empty", "name a new one");
  }
  for (const Sample& sample : samples) {
    for (const LabelledThing& thing : sample.things) {
      if (!thing.space || options.fieldOfView > 0) continue;
      return fail("boxes in space need the camera's field of view", "add its <horizontal_fov>, such as --hfov 1.047");
    }
  }
  for (const char* part : {"image_2", "label_2"}) makeFolder(folder / part);
  if (options.fieldOfView > 0) makeFolder(folder / "calib");
  std::size_t number = 0;
  for (const Sample& sample : samples) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%06zu", number++);
    const auto file = [&](const char* part, const char* ending) {
      return folder / part / (name.data() + std::string(ending));
    };
    fs::copy_file(sample.picture, file("image_2", ".png"), error);
    if (error) throw Failure("'" + file("image_2", ".png").string() + "' can't be written: " + error.message());
    const double focalLength =
        options.fieldOfView > 0 ? static_cast<double>(sample.width) / (2 * std::tan(options.fieldOfView / 2)) : 0;
    writeFile(file("label_2", ".txt"), kittiLabels(sample, focalLength, options.names));
    if (focalLength > 0) writeFile(file("calib", ".txt"), kittiCalibration(sample, focalLength));
  }
  return kDone;
}

int makeDataset(const DatasetOptions& options) {
  std::vector<Sample> samples;
  Diagnostics found;
  for (const std::string& folder : options.folders) {
    for (Sample& sample : readSamples(folder, found)) samples.push_back(std::move(sample));
  }
  say(found, Severity::kWarning, Severity::kError);
  if (found.hasErrors()) return kFailed;
  if (samples.empty()) return fail("there is no picture with its labels");
  const int code = options.coco.empty() ? writeKitti(options, samples) : writeCoco(options, samples);
  if (code != kDone) return code;
  std::size_t things = 0;
  for (const Sample& sample : samples) things += sample.things.size();
  say((options.coco.empty() ? options.kitti : options.coco) + ": " + std::to_string(samples.size()) + " pictures, " +
      std::to_string(things) + " labelled things");
  return kDone;
}

void checkDataset(const DatasetOptions& options) {
  if (options.folders.empty()) {
    throw UsageError("no folder of samples given", "name the <path> of a sensor's <save>");
  }
  if (options.coco.empty() == options.kitti.empty()) {
    throw UsageError("which format? Give either --coco FILE or --kitti FOLDER");
  }
}

}  // namespace

void addDatasetCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<DatasetOptions>();
  CLI::App* command = program.add_subcommand(
      "dataset", "Make a dataset in the format of COCO or KITTI of what segmentation and bounding-box cameras save");
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    return command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  command
      ->add_option("FOLDER", options->folders,
                   "Folders of samples: each the <path> of the <save> of a segmentation or bounding-box\n"
                   "camera")
      ->type_name("");
  add("--coco", "FILE", "Write annotations for COCO: boxes, and masks of segmentation cameras",
      [options](const std::string& text) { options->coco = text; });
  add("--kitti", "FOLDER", "Write pictures and labels for KITTI: image_2, label_2, and calib with --hfov",
      [options](const std::string& text) { options->kitti = text; });
  command
      ->add_option_function<std::vector<std::string>>(
          "--name",
          [options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) readName(text, options->names);
          },
          "Call a label NAME (label_N); repeatable")
      ->type_name("N=NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add("--hfov", "RAD", "The camera's <horizontal_fov>, for boxes in space", [options](const std::string& text) {
    options->fieldOfView = numberFromZero("--hfov", text, "an angle in radians");
    if (options->fieldOfView <= 0 || options->fieldOfView >= M_PI) {
      throw UsageError("option '--hfov' takes an angle between 0 and pi, not '" + text + "'");
    }
  });
  command->footer(
      "Examples:\n"
      "  pongsim dataset segmentation_samples --coco annotations.json --name 10=box --name 40=ball\n"
      "  pongsim dataset left_camera right_camera --coco boxes.json\n"
      "  pongsim dataset space_boxes --kitti training --hfov 1.047");
  command->callback([options, &work] {
    checkDataset(*options);
    work = [options] { return makeDataset(*options); };
  });
}

}  // namespace pongsim::cli
