#include "sim/running/server.hh"

#include <pthread.h>

#include <chrono>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "base/report/crash_report.hh"

namespace pongsim::sim {

Server::Server(Transport& transport, const std::vector<std::unique_ptr<Simulation>>& worlds, const RunOptions& options)
    : transport_(transport), worlds_(worlds) {
  std::vector<std::string> names;
  for (const std::unique_ptr<Simulation>& world : worlds) {
    names.emplace_back(world->world().name());
    ResourceServices::FolderAdded folderAdded;
    if (runners_.empty()) folderAdded = [this](const std::filesystem::path& folder) { addFolder(folder); };
    runners_.push_back(std::make_unique<Runner>(*world, options, std::move(folderAdded)));
  }
  services_.emplace(transport, std::move(names), [this] { stop(); });
}

Server::~Server() = default;

void Server::stop() {
  for (const std::unique_ptr<Runner>& runner : runners_) runner->stop();
}

Outcome<void> Server::outcome() const {
  for (const std::unique_ptr<Runner>& runner : runners_) {
    if (Outcome<void> outcome = runner->outcome(); !outcome) return outcome;
  }
  return {};
}

/// Adds a folder to the other worlds; the first one, whose service got the request, has added it.
void Server::addFolder(const std::filesystem::path& folder) {
  for (std::size_t i = 1; i < runners_.size(); ++i) {
    runners_[i]->addFolder(folder);
  }
}

void Server::run() {
  if (runners_.size() == 1) {
    runners_.front()->run();
  } else {
    runBeside();
  }
}

std::thread Server::startBeside(std::size_t world, std::exception_ptr& failure) {
  const std::string name(worlds_[world]->world().name());
  ++running_;
  try {
    std::thread thread([this, world, &failure] {
      try {
        const base::CrashStack stack;
        runners_[world]->run();
        runners_[world]->leave();
      } catch (...) {
        failure = std::current_exception();
        stop();
      }
      --running_;
      transport_.wake();
    });
    // thread names, as shown by ps and gdb, have at most 15 characters
    pthread_setname_np(thread.native_handle(), name.substr(0, 15).c_str());
    return thread;
  } catch (const std::system_error& error) {
    --running_;
    throw std::runtime_error("can't start a thread for world '" + name + "': " + error.what());
  } catch (...) {
    // out of memory in the thread's constructor
    --running_;
    throw;
  }
}

void Server::runBeside() {
  std::vector<std::exception_ptr> failures(runners_.size());
  std::vector<std::thread> threads;
  threads.reserve(runners_.size());
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    try {
      threads.push_back(startBeside(i, failures[i]));
    } catch (...) {
      // the worlds that already run end before the exception is rethrown
      failures[i] = std::current_exception();
      stop();
      break;
    }
  }
  // handles requests to the services of the process
  while (running_ > 0) transport_.dispatchFor(std::chrono::hours(1));
  for (std::thread& thread : threads) thread.join();
  // handles responses of the process to the worlds, such as to a stop request, that arrived after a world's thread had
  // ended
  for (std::size_t i = 0; i < worlds_.size(); ++i) {
    if (!failures[i]) worlds_[i]->transport().dispatch();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace pongsim::sim
