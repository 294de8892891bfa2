#include "core/sensor.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <ignition/msgs/laserscan.pb.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/errors.hh"
#include "core/message_dict.hh"
#include "core/properties.hh"
#include "core/values.hh"
#include "pongsim/physical_properties.hh"
#include "pongsim/program/nearest_word.hh"

namespace pongsim::python {

namespace {

using google::protobuf::FieldDescriptor;

const FieldDescriptor& fieldOf(const Message& message, const char* name) {
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(name);
  if (field == nullptr) throw std::logic_error(message.GetTypeName() + " has no field " + name);
  return *field;
}

std::size_t countIn(const Message& message, const char* name) {
  return message.GetReflection()->GetUInt32(message, &fieldOf(message, name));
}

std::int64_t stampOf(const Message& message) {
  const auto& header = message.GetReflection()->GetMessage(message, &fieldOf(message, "header"));
  const auto& stamp = header.GetReflection()->GetMessage(header, &fieldOf(header, "stamp"));
  return stamp.GetReflection()->GetInt64(stamp, &fieldOf(stamp, "sec")) * 1'000'000'000 +
         stamp.GetReflection()->GetInt32(stamp, &fieldOf(stamp, "nsec"));
}

void collect(const Model& model, std::vector<Sensor>& sensors) {
  for (const Link& link : model.links()) {
    for (const Sensor& sensor : link.sensors()) sensors.push_back(sensor);
  }
  for (const Joint& joint : model.joints()) {
    for (const Sensor& sensor : joint.sensors()) sensors.push_back(sensor);
  }
  for (const Model& nested : model.models()) collect(nested, sensors);
}

std::vector<Sensor> allSensors(Simulation& simulation) {
  std::vector<Sensor> sensors;
  for (const Model& model : simulation.world().models()) collect(model, sensors);
  return sensors;
}

/// @return Whether the element or one inside it contains noise.
bool hasNoise(const Element& element) {
  if (element.name == "noise" && element.attributeOr("type", "none") != "none") return true;
  return std::ranges::any_of(element.children, hasNoise);
}

}  // namespace

Stream::Stream(const std::shared_ptr<Life>& life, const Sensor& sensor, const SensorReadings& readings)
    : kind(readings.kind), type(readings.messageType), life_(life), sensor_(sensor) {
  subscription_ = life->use().transport().node().subscribeAtOnce(
      sensor.topic(readings), type, [this](const Message& heard, const Bulk* bulk) { hear(heard, bulk); });
}

const Stream& Stream::use() const {
  const auto life = life_.lock();
  if (!life) raise("Gone", "the simulation is gone");
  life->use();
  return *this;
}

void Stream::hear(const Message& heard, const Bulk* bulk) {
  if (kind == SensorReadings::kRanges) {
    hearScan(heard);
  } else if (kind == SensorReadings::kPoints || type == "ignition.msgs.Image") {
    hearBulk(heard, bulk);
  } else {
    heard.SerializeToString(&message);
  }
  time = stampOf(heard);
  ++count;
}

/// @return Memory of this size: that of the previous reading, unless an array still refers to it.
void* Stream::place(std::shared_ptr<Memory>& at, std::size_t size) {
  if (at == nullptr || at->bytes.size() != size) at = std::make_shared<Memory>(size);
  return at->bytes.data();
}

void Stream::hearScan(const Message& heard) {
  const auto& scan = static_cast<const ignition::msgs::LaserScan&>(heard);
  const auto size = static_cast<std::size_t>(scan.ranges_size());
  const std::size_t rows = std::max<std::size_t>(scan.vertical_count(), 1);
  shape = rows > 1 && size % rows == 0 ? std::vector{rows, size / rows} : std::vector{size};
  format = "f8";
  written = place(memory, size * sizeof(double));
  std::memcpy(memory->bytes.data(), scan.ranges().data(), size * sizeof(double));
  const auto strengthSize = static_cast<std::size_t>(scan.intensities_size()) * sizeof(double);
  std::memcpy(place(intensities, strengthSize), scan.intensities().data(), strengthSize);
}

void Stream::hearBulk(const Message& heard, const Bulk* bulk) {
  const std::size_t height = countIn(heard, "height"), width = countIn(heard, "width");
  std::string scratch;
  const std::string& data = heard.GetReflection()->GetStringReference(heard, &fieldOf(heard, "data"), &scratch);
  const std::size_t size = bulk != nullptr ? bulk->size : data.size();
  const std::size_t pixels = std::max<std::size_t>(height * width, 1);
  if (kind == SensorReadings::kPoints) {
    shape = {height, width, size / pixels / sizeof(float)};
    format = "f4";
  } else if (kind == SensorReadings::kDepth) {
    shape = {height, width};
    format = "f4";
  } else {
    const std::size_t bytes = size / pixels;
    shape = bytes == 3 ? std::vector{height, width, bytes} : std::vector{height, width};
    format = bytes == 2 ? "u2" : "u1";
  }
  written = place(memory, size);
  if (bulk != nullptr) {
    bulk->write(memory->bytes);
  } else {
    std::memcpy(memory->bytes.data(), data.data(), size);
  }
}

std::shared_ptr<Stream> PySensor::listen(const std::string& kind) {
  const Sensor& sensor = use();
  const std::pair key(sensor.id().value, kind);
  if (const auto found = life->streams.find(key); found != life->streams.end()) return found->second;
  std::string known;
  for (const SensorReadings& readings : life->use().readings(sensor.type())) {
    known += (known.empty() ? "" : ", ") + readings.kind;
    if (readings.kind != kind) continue;
    // those of removed models
    std::erase_if(life->streams, [](const auto& each) { return !each.second->isOfASensor(); });
    auto stream = std::make_shared<Stream>(life, sensor, readings);
    life->tell(stream);
    life->streams.emplace(key, stream);
    return stream;
  }
  throw py::value_error("sensor '" + sensor.scopedName() + "' of type " + std::string(sensor.type()) + " has no " +
                        kind + (known.empty() ? ": no system of the world supports its type" : "; it has " + known));
}

void PySensor::stop(const std::string& kind) {
  const auto found = life->streams.find({use().id().value, kind});
  if (found == life->streams.end()) return;
  found->second->letGo();
  life->streams.erase(found);
}

PySensor findSensor(const std::shared_ptr<Life>& life, const std::string& name) {
  std::vector<std::string> scoped;
  std::vector<Sensor> named;
  for (const Sensor& sensor : allSensors(life->use())) {
    scoped.push_back(sensor.scopedName());
    if (scoped.back() == name) return {life, sensor};
    if (sensor.name() == name) named.push_back(sensor);
  }
  if (named.size() == 1) return {life, named.front()};
  if (!named.empty()) {
    throw py::key_error("several sensors are called '" + name + "'; one is " + named.front().scopedName());
  }
  const std::vector<std::string_view> words(scoped.begin(), scoped.end());
  const std::string hint = didYouMean(name, words);
  throw py::key_error("there is no sensor '" + name + "'" + (hint.empty() ? "" : "; " + hint));
}

std::vector<std::string> sensorNames(Life& life) {
  std::vector<std::string> names;
  for (const Sensor& sensor : allSensors(life.use())) names.push_back(sensor.scopedName());
  return names;
}

void bindSensors(py::module_& module) {
  py::class_<Memory, std::shared_ptr<Memory>>(module, "Memory", py::buffer_protocol(), "Memory viewed by arrays.")
      .def_buffer([](Memory& memory) {
        return py::buffer_info(memory.bytes.data(), 1, py::format_descriptor<std::uint8_t>::format(), 1,
                               {static_cast<py::ssize_t>(memory.bytes.size())}, {1}, !memory.isWritable);
      });
  py::class_<Stream, std::shared_ptr<Stream>>(module, "Stream", "One kind of a sensor's readings.")
      .def_property_readonly("shape", [](const Stream& self) { return py::tuple(py::cast(self.use().shape)); })
      .def_property_readonly("format", [](const Stream& self) { return self.use().format; })
      .def_property_readonly("time_ns", [](const Stream& self) { return self.use().time; })
      .def_property_readonly("count", [](const Stream& self) { return self.use().count; })
      .def_property_readonly("memory", [](const Stream& self) { return self.use().memory; })
      .def_property_readonly("intensities", [](const Stream& self) { return self.use().intensities; })
      .def_property_readonly("written_at",
                             [](const Stream& self) { return reinterpret_cast<std::uintptr_t>(self.use().written); })
      .def("message", [](const Stream& self, py::handle type) {
        return messageAs(type, self.use().type, std::as_bytes(std::span(self.message)));
      });
  py::class_<PySensor> type(module, "Sensor", "A sensor of a running world.");
  type.def_property_readonly(
          "exists", [](PySensor& self) { return !self.life->isClosed() && self.use().exists(); },
          "Whether it is still there.")
      .def_property_readonly(
          "name", [](PySensor& self) { return std::string(self.use().name()); }, "Its own name.")
      .def_property_readonly(
          "scoped_name", [](PySensor& self) { return self.use().scopedName(); }, "\"model::link::sensor\".")
      .def_property_readonly(
          "type", [](PySensor& self) { return std::string(self.use().type()); },
          "Its type as in the file: \"gpu_lidar\".")
      .def_property_readonly(
          "pose", [](PySensor& self) { return poseOf(self.use().pose()); }, "Pose of its frame in the world frame.")
      .def_property_readonly(
          "update_rate", [](PySensor& self) { return self.use().updateRate(); },
          "Readings per simulated second; 0: one per step.")
      .def_property_readonly(
          "kinds",
          [](PySensor& self) {
            std::vector<std::string> kinds;
            const Sensor& sensor = self.use();
            for (SensorReadings& each : self.life->use().readings(sensor.type())) kinds.push_back(std::move(each.kind));
            return kinds;
          },
          "Its kinds of readings, the main one first, as the world's systems declare them.")
      .def_property_readonly(
          "link_name", [](PySensor& self) { return self.use().link().scopedName(); },
          "The scoped name of its link; for a sensor on a joint, of the joint's child.")
      .def_property_readonly(
          "pose_in_link", [](PySensor& self) { return poseOf(self.use().poseInLink()); },
          "Pose of its frame in the frame of that link.")
      .def_property_readonly(
          "frame_name", [](PySensor& self) { return self.use().frameName(); }, "Its frame's name in messages.")
      .def_property_readonly(
          "topics",
          [](PySensor& self) {
            py::dict topics;
            const Sensor& sensor = self.use();
            for (const SensorReadings& each : self.life->use().readings(sensor.type())) {
              topics[py::str(each.kind)] = sensor.topic(each);
            }
            return topics;
          },
          "The topic of each kind of reading.")
      .def_property_readonly(
          "has_noise",
          [](PySensor& self) {
            const Sensor& inner = self.use();
            const auto noises = PhysicalProperties(self.life->use().world()).noises(inner);
            if (noises.empty()) return hasNoise(inner.sdf());
            return std::ranges::any_of(noises,
                                       [](const auto& each) { return each.noise.type != NoiseSettings::Type::kNone; });
          },
          "Whether its readings depend on the seed: it has noise now.")
      .def(
          "stream",
          [](PySensor& self, const std::string& kind) {
            if (!self.use().exists()) raise("Gone", "the sensor is gone: its model was removed");
            return self.listen(kind);
          },
          py::arg("kind"), "Readings of one kind; the first call switches them on.")
      .def("stop", &PySensor::stop, py::arg("kind"), "Switches readings of one kind off.");
  bindNoise(type);
}

}  // namespace pongsim::python
