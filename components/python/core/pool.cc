#include "core/pool.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/errors.hh"

namespace pongsim::python {

namespace {

/// How often an idle thread looks for work before it sleeps: some 200 us, so that it stays awake between two steps of a
/// learner. A sleeping one is often woken on the processor of the thread that wakes it, and has to wait there.
constexpr int kLooks = 8000;
std::string nameOf(std::size_t world) { return "environment " + std::to_string(world); }

}  // namespace

void Pool::Place::letGo() {
  // references into the simulation are destroyed before it
  readings.clear();
  steerings.clear();
}

void Pool::Place::forget() {
  for (const Reading& reading : readings) {
    if (reading.topic) reading.topic->forget();
  }
}

Pool::Pool(std::vector<std::shared_ptr<Life>> lives, std::size_t threads)
    : lives_(std::move(lives)), threads_(threads) {
  for (const auto& life : lives_) {
    life->use();
    worlds_.push_back(std::make_shared<Place>(life));
    life->tell(worlds_.back());
  }
}

Pool::Place& Pool::placeOf(std::size_t world) {
  if (world >= worlds_.size()) throw py::index_error("there is no " + nameOf(world));
  worlds_[world]->life->edit("a change of an environment");
  return *worlds_[world];
}

void Pool::addReading(std::size_t world, Reading reading) {
  checkOpen();
  placeOf(world).readings.push_back(std::move(reading));
}

void Pool::addSteering(std::size_t world, Steering steering) {
  checkOpen();
  placeOf(world).steerings.push_back(std::move(steering));
}

void Pool::seal() {
  const auto sizeOf = [](const auto& parts) {
    std::size_t size = 0;
    for (const auto& part : parts) size += part.size;
    return size;
  };
  valueSize_ = worlds_.empty() ? 0 : sizeOf(worlds_.front()->readings);
  for (std::size_t i = 0; i < worlds_.size(); ++i) {
    if (sizeOf(worlds_[i]->readings) != valueSize_ || sizeOf(worlds_[i]->steerings) != actionSize()) {
      throw py::value_error(nameOf(i) + " has a different number of readings or action values than the first one");
    }
  }
  for (const Observed& each : observed_) {
    if (each.column >= valueSize_) throw py::value_error("an observed value is not read");
  }
  const std::size_t rows = count();
  const auto make = [&](std::size_t width) { return std::make_shared<Memory>(rows * width, true); };
  actions = make(actionSize() * sizeof(double));
  values = make(valueSize_ * sizeof(double));
  before = make(valueSize_ * sizeof(double));
  observations = make(observed_.size() * sizeof(float));
  steps = make(sizeof(std::int64_t));
  commanded = make(1);
  restored = make(1);
  isSealed_ = true;
}

template <class Number>
std::span<Number> Pool::rowOf(const std::shared_ptr<Memory>& memory, std::size_t row, std::size_t width) {
  return {reinterpret_cast<Number*>(memory->bytes.data()) + row * width, width};
}

void Pool::checkActions() const {
  for (std::size_t i = 0; i < count(); ++i) {
    if (rowOf<std::uint8_t>(commanded, i, 1)[0] == 0) continue;
    const auto action = rowOf<double>(actions, i, actionSize());
    for (std::size_t k = 0; k < action.size(); ++k) {
      if (std::isfinite(action[k])) continue;
      throw py::value_error("number " + std::to_string(k) + " of the action" +
                            (count() > 1 ? " of " + nameOf(i) : std::string()) + " is " + std::to_string(action[k]) +
                            "; it must be finite");
    }
  }
}

shared::Workers& Pool::startedWorkers() {
  if (!workers_) workers_.emplace(static_cast<int>(std::min(threads_, std::max<std::size_t>(count(), 1))), kLooks);
  if (workers_->count() > 1 && !workers_->areOfThisProcess()) {
    throw std::runtime_error(
        "the threads of these environments did not survive the fork of the process; create the environments in the "
        "process that steps them");
  }
  return *workers_;
}

template <class Work>
void Pool::forAll(const char* what, Work work) {
  if (!isSealed_) throw py::value_error("the pool is not sealed yet");
  std::vector<Simulation*> simulations;
  for (const auto& life : lives_) simulations.push_back(&life->edit(what));
  std::vector<std::exception_ptr> thrown(count());
  shared::Workers& workers = startedWorkers();
  Life::steppingAll(lives_, [&] {
    workers.forEach(count(), [&](std::size_t i, int) {
      lives_[i]->takeOver();
      try {
        work(i, *simulations[i]);
      } catch (...) {
        thrown[i] = std::current_exception();
      }
    });
  });
  raiseThrown(thrown);
}

void Pool::raiseThrown(const std::vector<std::exception_ptr>& thrown) const {
  for (std::size_t i = 0; i < thrown.size(); ++i) {
    if (!thrown[i]) continue;
    try {
      std::rethrow_exception(thrown[i]);
    } catch (const Gone& gone) {
      raise("Gone", nameOf(i) + ": " + gone.what());
    } catch (const std::runtime_error& error) {
      lives_[i]->raiseFailure((nameOf(i) + ": " + error.what()).c_str());
    }
  }
}

void Pool::read(std::size_t world, bool isFirst) {
  const auto now = rowOf<double>(values, world, valueSize_);
  double* to = now.data();
  for (const Reading& reading : worlds_[world]->readings) {
    reading.sample(to);
    to += reading.size;
  }
  if (isFirst) std::ranges::copy(now, rowOf<double>(before, world, valueSize_).begin());
  auto seen = rowOf<float>(observations, world, observed_.size());
  for (std::size_t i = 0; i < observed_.size(); ++i) {
    const auto& [column, limits] = observed_[i];
    seen[i] = static_cast<float>(std::clamp(now[column], limits.low, limits.high));
  }
}

void Pool::advance(std::size_t world, Simulation& simulation) {
  const Place& place = *worlds_[world];
  const std::int64_t wanted = rowOf<std::int64_t>(steps, world, 1)[0];
  const bool isCommanded = rowOf<std::uint8_t>(commanded, world, 1)[0] != 0;
  if (wanted <= 0) return;
  auto action = rowOf<double>(actions, world, actionSize());
  const auto steer = [&](bool isFirst) {
    const double* numbers = action.data();
    for (const Steering& steering : place.steerings) {
      if (isFirst || steering.isForEachStep) steering.apply(numbers);
      numbers += steering.size;
    }
  };
  if (isCommanded) {
    for (std::size_t i = 0; i < action.size(); ++i) {
      action[i] = std::clamp(action[i], actionLimits_[i].low, actionLimits_[i].high);
    }
    std::ranges::copy(rowOf<double>(values, world, valueSize_), rowOf<double>(before, world, valueSize_).begin());
  }
  for (std::int64_t i = 0; i < wanted && !place.life->mustStop(); ++i) {
    if (isCommanded) steer(i == 0);
    simulation.step();
  }
  read(world, !isCommanded);
}

void Pool::step() {
  if (isSealed_) checkActions();
  forAll("a step", [this](std::size_t i, Simulation& simulation) { advance(i, simulation); });
  for (std::size_t i = 0; i < count(); ++i) {
    if (rowOf<std::uint8_t>(commanded, i, 1)[0] == 0) continue;
    const std::string name = missing(i);
    if (name.empty()) continue;
    raise("NoReading", nameOf(i) + " has no reading of " + name +
                           " since its world was reset or restored by other means; call reset");
  }
}

void Pool::save(std::size_t world) {
  Place& place = placeOf(world);
  place.saved = place.life->edit("saving").saveState();
  for (const Reading& reading : place.readings) {
    if (reading.topic) reading.topic->save();
  }
}

void Pool::putBack(std::size_t world, Simulation& simulation) {
  if (rowOf<std::uint8_t>(restored, world, 1)[0] == 0) return;
  const Place& place = *worlds_[world];
  const Outcome<void> put = simulation.restoreState(place.saved);
  if (!put) throw std::invalid_argument(put.error);
  for (const Reading& reading : place.readings) {
    if (reading.topic) reading.topic->restore();
  }
  read(world, true);
}

void Pool::restore() {
  for (std::size_t i = 0; i < count(); ++i) {
    if (isSealed_ && rowOf<std::uint8_t>(restored, i, 1)[0] != 0) lives_[i]->forgetPast();
  }
  try {
    forAll("restoring", [this](std::size_t i, Simulation& simulation) { putBack(i, simulation); });
  } catch (const std::invalid_argument& refusal) {
    raise("Refused", refusal.what());
  }
}

std::string Pool::missing(std::size_t world) const {
  for (const Reading& reading : worlds_.at(world)->readings) {
    if (reading.topic && !reading.topic->isThere()) return reading.topic->name();
  }
  return {};
}

}  // namespace pongsim::python
