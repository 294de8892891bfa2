#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/life.hh"
#include "core/memory.hh"
#include "pongsim/sensing/sensor.hh"

namespace pongsim::python {

/// One kind of reading of a sensor. Each new reading is written to the memory that NumPy arrays refer to. The
/// simulation keeps it (`Life::streams`), so that it stays on when no object of Python refers to it.
class Stream final : public Life::Pending {
 public:
  Stream(const std::shared_ptr<Life>& life, const Sensor& sensor, const SensorReadings& readings);
  ~Stream() override { end(subscription_); }
  void letGo() override { end(subscription_); }
  void forget() override { count = 0; }

  /// @return Whether its sensor is there, or will be when its level is loaded.
  bool isOfASensor() const { return sensor_.exists() || sensor_.isSetAside(); }

  /// @return Itself, if no other thread is stepping and might write meanwhile.
  /// Raises Gone, Busy like `Life::use`.
  const Stream& use() const;

  std::string kind;
  /// Rows, columns and, for points, numbers for each point.
  std::vector<std::size_t> shape;
  /// NumPy's name for it: "f8".
  std::string format;
  /// Simulated time of the reading in memory [ns].
  std::int64_t time = 0;
  std::uint64_t count = 0;
  std::shared_ptr<Memory> memory;
  /// Scans only, in separate memory.
  std::shared_ptr<Memory> intensities;
  /// Where the sensor last wrote pixels or points without gaps.
  const void* written = nullptr;
  /// The whole message in binary form; for kinds that are not arrays.
  std::string message;
  std::string type;

 private:
  void hear(const Message& heard, const Bulk* bulk);
  void hearScan(const Message& heard);
  void hearBulk(const Message& heard, const Bulk* bulk);
  void* place(std::shared_ptr<Memory>& memory, std::size_t size);

  std::weak_ptr<Life> life_;
  const Sensor sensor_;
  Subscription subscription_;
};

/// A sensor.
struct PySensor {
  std::shared_ptr<Life> life;
  Sensor inner;

  Sensor& use() {
    life->use();
    return inner;
  }
  /// @return Its readings of that kind, which the first call switches on.
  /// Raises ValueError for a kind that the sensor does not have.
  std::shared_ptr<Stream> listen(const std::string& kind);
  /// Switches readings off.
  void stop(const std::string& kind);
};

/// @return The sensor with this scoped name, "model::link::sensor", or with this name if it is unique. Raises KeyError.
PySensor findSensor(const std::shared_ptr<Life>& life, const std::string& name);
/// @return The scoped names of all sensors.
std::vector<std::string> sensorNames(Life& life);

/// Binds sensors and their memory.
void bindSensors(py::module_& module);

}  // namespace pongsim::python
