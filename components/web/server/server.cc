#include "web/server/server.hh"

#include <arpa/inet.h>
#include <libwebsockets.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <pthread.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "web/server/connection.hh"
#include "web/server/handshakes.hh"
#include "web/server/http.hh"
#include "web/server/media_type.hh"

namespace pongsim::web {

namespace {

// Limit of unsent bytes in the socket's buffer (TCP_NOTSENT_LOWAT): the rest stays in the client's queue, where newer
// data replaces it.
constexpr int kUnsent = 64 << 10;
// The library allocates a table for the maximum number of open files, which in containers may be 2^30. Beyond this
// limit the server tells it a smaller number.
constexpr long kMostFilesInTables = 65536;
// In addition to connections: listening sockets, and the library's own.
constexpr unsigned kOtherFiles = 32;
constexpr std::size_t kReadBuffer = std::size_t{16} << 10;
constexpr const char* kNoSubprotocol = "pongsim.none";
constexpr const char* kAssets = "/assets";
constexpr std::size_t kMostReasons = 20;
constexpr int kWithoutWaiting = -1;

// Content security policy of the page: only what it consists of, in frames of the named pages.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; media-src 'self' blob:; "
    "font-src 'self'; connect-src 'self' blob: data:; worker-src 'self'; manifest-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors ";
constexpr lws_protocol_vhost_options kOpener{nullptr, nullptr, "cross-origin-opener-policy:", "same-origin"};
constexpr lws_protocol_vhost_options kReferrer{&kOpener, nullptr, "referrer-policy:", "no-referrer"};
constexpr lws_protocol_vhost_options kSniff{&kReferrer, nullptr, "x-content-type-options:", "nosniff"};

std::string policy(const std::vector<std::string>& framingOrigins) {
  std::string text = kPolicy;
  if (framingOrigins.empty()) return text + "'none'";
  for (const std::string& origin : framingOrigins) text += origin + " ";
  text.pop_back();
  return text;
}

/// The library's last message; the library has one log per process.
std::mutex errorMutex;
std::string lastError;

void keepError(int, const char* line) {
  const std::lock_guard lock(errorMutex);
  lastError = line;
}

/// @return 0 if the address and port are available, else the reason (errno).
int portError(const std::string& address, int port) {
  const int probe = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return errno;
  const int on = 1;
  setsockopt(probe, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, address.c_str(), &place.sin_addr);
  const bool isFree =
      bind(probe, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 && listen(probe, 1) == 0;
  const int error = isFree ? 0 : errno;
  ::close(probe);
  return error;
}

/// @throws std::runtime_error if the address and port are not available.
void checkPort(const std::string& address, int port) {
  const int error = port == 0 ? 0 : portError(address, port);
  if (error == 0) return;
  const std::string why = error == EADDRINUSE ? "another program uses it" : std::strerror(error);
  throw std::runtime_error("port " + std::to_string(port) + " of " + address + " can't be opened: " + why +
                           "; choose another with --web PORT or <port>");
}

void checkReadable(const std::filesystem::path& file, const char* what) {
  std::ifstream stream(file);
  if (!stream || stream.peek() == std::ifstream::traits_type::eof())
    throw std::runtime_error(std::string("the ") + what + " " + file.string() + " can't be read");
}

}  // namespace

class Server::Loop {
 public:
  Loop(ServerSettings settings, const Logger& log, const std::vector<Protocol*>& protocols)
      : settings_(std::move(settings)), log_(log), policy_(policy(settings_.framingOrigins)) {
    mostSockets_ = std::min(static_cast<std::size_t>(settings_.limits.connections),
                            static_cast<std::size_t>(std::max(sysconf(_SC_OPEN_MAX), 2L)) / 2);
    listProtocols(protocols);
    open();
    waker_ = std::make_shared<Waker>(context_.get(), log_);
    checkThatItWorks();
    thread_ = std::thread([this] { work(); });
  }

  ~Loop() {
    mustEnd_ = true;
    waker_->wake();
    thread_.join();
    waker_->end();
  }

  int port() const { return port_; }
  std::size_t clients() const { return clients_; }

 private:
  void listProtocols(const std::vector<Protocol*>& protocols) {
    // the library uses the first protocol for plain HTTP, and for clients that request none
    names_.emplace_back(kNoSubprotocol);
    for (Protocol* const protocol : protocols) {
      for (const std::string& name : protocol->names()) {
        protocols_.emplace(name, protocol);
        if (!name.empty()) names_.push_back(name);
      }
    }
    for (const std::string& name : names_) {
      table_.push_back({.name = name.c_str(),
                        .callback = &Loop::call,
                        .per_session_data_size = 0,
                        .rx_buffer_size = kReadBuffer,
                        .id = 0,
                        .user = nullptr,
                        .tx_packet_size = 0});
    }
    table_.push_back({});
  }

  lws_context_creation_info contextInfo() {
    idle_.secs_since_valid_ping = static_cast<std::uint16_t>(settings_.limits.silence.count());
    idle_.secs_since_valid_hangup =
        static_cast<std::uint16_t>((settings_.limits.silence + settings_.limits.handshake).count());
    lws_context_creation_info info{};
    info.protocols = table_.data();
    info.port = settings_.port;
    info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS | LWS_SERVER_OPTION_DISABLE_IPV6 |
                   LWS_SERVER_OPTION_VALIDATE_UTF8 | LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND;
    info.user = this;
    info.gid = info.uid = static_cast<decltype(info.gid)>(-1);
    info.server_string = "pongsim";
    info.headers = &headers_;
    info.timeout_secs = static_cast<unsigned>(settings_.limits.handshake.count());
    info.keepalive_timeout = static_cast<int>(settings_.limits.handshake.count());
    info.retry_and_idle_policy = &idle_;
    info.alpn = "http/1.1";
    if (sysconf(_SC_OPEN_MAX) > kMostFilesInTables)
      info.fd_limit_per_thread = static_cast<unsigned>(settings_.limits.connections) + kOtherFiles;
    if (!settings_.certificate.empty()) {
      info.options |= LWS_SERVER_OPTION_DO_SSL_GLOBAL_INIT;
      info.ssl_cert_filepath = settings_.certificate.c_str();
      info.ssl_private_key_filepath = settings_.key.c_str();
    }
    return info;
  }

  void open() {
    if (!settings_.certificate.empty()) {
      checkReadable(settings_.certificate, "certificate");
      checkReadable(settings_.key, "certificate's key");
    }
    for (const std::string& address : settings_.addresses) checkPort(address, settings_.port);
    lws_set_log_level(LLL_ERR, &keepError);
    lws_context_creation_info info = contextInfo();
    context_.reset(lws_create_context(&info));
    if (context_ == nullptr) throw std::runtime_error("the server can't be started: " + lastLibraryError());
    port_ = settings_.port;
    for (const std::string& address : settings_.addresses) {
      info.iface = address.c_str();
      info.port = port_;
      info.vhost_name = address.c_str();
      lws_vhost* const host = lws_create_vhost(context_.get(), &info);
      if (host == nullptr) {
        throw std::runtime_error((settings_.certificate.empty()
                                      ? "port " + std::to_string(port_) + " of " + address + " can't be opened: "
                                      : "the certificate can't be used or does not match the key: ") +
                                 lastLibraryError());
      }
      port_ = lws_get_vhost_listen_port(host);
    }
  }

  /// The library goes on without what it could not open, such as when the process has no file descriptors left: then
  /// nobody could connect, and nothing would wake the thread, not even to end it.
  /// @throws std::runtime_error if so.
  void checkThatItWorks() {
    const auto refuse = [](const std::string& why) {
      throw std::runtime_error("the server can't be started: " + why + "; allow more open files (ulimit -n)");
    };
    for (const std::string& address : settings_.addresses) {
      const int error = portError(address, port_);
      if (error != EADDRINUSE) refuse(std::strerror(error == 0 ? EMFILE : error));
    }
    lws_cancel_service(context_.get());
    lws_service(context_.get(), kWithoutWaiting);
    if (!canBeWoken_) refuse(std::strerror(EMFILE));
  }

  static std::string lastLibraryError() {
    const std::lock_guard lock(errorMutex);
    std::string text = lastError;
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.empty() ? "no reason given" : text;
  }

  void work() {
    // signals of the process belong to the simulation
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    pthread_setname_np(pthread_self(), "web");
    while (!mustEnd_) {
      if (lws_service(context_.get(), 0) >= 0) continue;
      log_.error("the server has failed and stopped");
      return;
    }
  }

  static int call(lws* socket, lws_callback_reasons reason, void* data, void* in, std::size_t length) {
    auto* const loop = static_cast<Loop*>(lws_context_user(lws_get_context(socket)));
    if (loop == nullptr) return 0;
    // exceptions must not pass through the library, which is in C
    try {
      return loop->handle(socket, reason, data, in, length);
    } catch (const std::exception& error) {
      loop->log_.warning(std::string("a connection was closed: ") + error.what());
      return -1;
    }
  }

  int handle(lws* socket, lws_callback_reasons reason, void* data, void* in, std::size_t length) {
    switch (reason) {
      case LWS_CALLBACK_FILTER_NETWORK_CONNECTION:
        return makeRoom(*static_cast<const lws_filter_network_conn_args*>(data)) ? 0 : 1;
      case LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED:
        sockets_.insert(socket);
        handshakes_.add(socket, newPeer_);
        return 0;
      case LWS_CALLBACK_WSI_DESTROY:
        sockets_.erase(socket);
        handshakes_.remove(socket);
        forget(socket);
        return 0;
      case LWS_CALLBACK_HTTP:
        return serve(socket, {static_cast<const char*>(in), length});
      case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
        return admit(socket);
      case LWS_CALLBACK_ESTABLISHED:
        return begin(socket);
      case LWS_CALLBACK_RECEIVE:
        return receive(socket, {static_cast<const char*>(in), length});
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return write(socket);
      case LWS_CALLBACK_CLOSED:
        forget(socket);
        return 0;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        canBeWoken_ = true;
        if (waker_) waker_->callAll();
        return 0;
      default:
        return lws_callback_http_dummy(socket, reason, data, in, length);
    }
  }

  /// Closes the oldest handshake if there are too many connections, or too many of the new one's address.
  /// @return Whether the new connection may stay.
  bool makeRoom(const lws_filter_network_conn_args& args) {
    sockaddr_in from{};
    std::memcpy(&from, &args.cli_addr, sizeof from);
    newPeer_ = from.sin_addr.s_addr;
    lws* oldest = nullptr;
    if (handshakes_.count(newPeer_) >= settings_.limits.handshakesOfAPeer) {
      oldest = handshakes_.oldest(newPeer_);
    } else if (sockets_.size() >= mostSockets_) {
      oldest = handshakes_.oldest();
      if (oldest == nullptr) return false;
    }
    // at once, and never the connection being served, which is the listening socket
    if (oldest != nullptr) lws_set_timeout(oldest, PENDING_TIMEOUT_USER_OK, LWS_TO_KILL_SYNC);
    return true;
  }

  static Visit visitOf(lws* socket) {
    return {headerOf(socket, WSI_TOKEN_HOST), headerOf(socket, WSI_TOKEN_ORIGIN), tokenOf(socket)};
  }

  /// @return What the callback of a request must return after a response with a text.
  static int refuse(lws* socket, int status, const std::string& why) {
    return !answerText(socket, status, why + "\n") || lws_http_transaction_completed(socket) != 0 ? -1 : 0;
  }

  int serve(lws* socket, std::string_view path) {
    handshakes_.renew(socket);
    char* uri = nullptr;
    int length = 0;
    const int method = lws_http_get_uri_and_method(socket, &uri, &length);
    // requests other than GET may have a body, which is not read
    if (method != LWSHUMETH_GET && method != LWSHUMETH_HEAD) {
      refuse(socket, HTTP_STATUS_METHOD_NOT_ALLOWED, "only GET is supported");
      return -1;
    }
    const Visit visit = visitOf(socket);
    const bool isAsset = path.starts_with(kAssets);
    const Permission permission = isAsset ? judgeClient(settings_.access, visit) : judgePage(settings_.access, visit);
    if (permission.kind == Permission::Kind::kRefused) return refuse(socket, permission.status, permission.why);
    std::optional<std::filesystem::path> file;
    if (!isAsset) {
      file = pageFile(settings_.page, path);
    } else if (settings_.findAsset) {
      file = settings_.findAsset(path.substr(std::strlen(kAssets)));
    }
    if (!file || mediaType(*file).empty()) return refuse(socket, HTTP_STATUS_NOT_FOUND, "there is no such file");
    return answerFile(socket, *file, isAsset ? visit.origin : std::string{});
  }

  /// @return Below 0: close; above: refused, with a response; 0: accepted.
  int admit(lws* socket) {
    // not the callback's pointer: where the library has refused the upgrade, it is to freed memory
    const std::string wanted = headerOf(socket, WSI_TOKEN_UPGRADE);
    if (wanted != "websocket" && wanted != "WebSocket") return -1;
    const auto say = [socket](int status, const std::string& why) { return answerText(socket, status, why) ? 1 : -1; };
    const Permission permission = judgeClient(settings_.access, visitOf(socket));
    if (permission.kind == Permission::Kind::kRefused) {
      // each reason once, because some clients retry without end
      if (reasons_.size() < kMostReasons && reasons_.insert(permission.why).second)
        log_.warning("a client was refused: " + permission.why);
      return say(permission.status, permission.why + "\n");
    }
    if (connections_.size() >= static_cast<std::size_t>(settings_.limits.clients))
      return say(HTTP_STATUS_SERVICE_UNAVAILABLE,
                 "there are " + std::to_string(settings_.limits.clients) + " clients already\n");
    admitted_[socket] = permission.kind == Permission::Kind::kWrite;
    return 0;
  }

  static std::string addressOf(lws* socket) {
    std::array<char, 64> address{};
    lws_get_peer_simple(socket, address.data(), address.size());
    return address.data();
  }

  int begin(lws* socket) {
    const auto admitted = admitted_.find(socket);
    if (admitted == admitted_.end()) return -1;
    const bool mayWrite = admitted->second;
    admitted_.erase(admitted);
    handshakes_.remove(socket);
    std::string name = lws_get_protocol(socket)->name;
    if (name == kNoSubprotocol) name.clear();
    const auto protocol = protocols_.find(name);
    auto connection = std::make_shared<Connection>(waker_, socket, settings_.limits, mayWrite,
                                                   settings_.traffic->add(addressOf(socket), name));
    if (protocol == protocols_.end()) {
      connection->close(LWS_CLOSE_STATUS_PROTOCOL_ERR, "name a subprotocol: foxglove.websocket.v1");
    } else {
      const int descriptor = lws_get_socket_fd(socket);
      setsockopt(descriptor, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kUnsent, sizeof kUnsent);
      try {
        connection->begin(protocol->second->open(name, connection));
      } catch (const std::exception& error) {
        log_.warning(std::string("a client can't be served: ") + error.what());
        connection->close(LWS_CLOSE_STATUS_UNEXPECTED_CONDITION, "the server has failed");
      }
    }
    connections_.emplace(socket, std::move(connection));
    clients_ = connections_.size();
    return 0;
  }

  int receive(lws* socket, std::string_view part) {
    const auto found = connections_.find(socket);
    if (found == connections_.end()) return -1;
    found->second->receive(part, lws_remaining_packet_payload(socket), lws_is_final_fragment(socket) != 0,
                           lws_frame_is_binary(socket) != 0, log_);
    return 0;
  }

  int write(lws* socket) {
    const auto found = connections_.find(socket);
    if (found == connections_.end()) return -1;
    try {
      return found->second->write(buffer_) ? 0 : -1;
    } catch (const std::exception& error) {
      log_.warning(std::string("a message for a client can't be made: ") + error.what());
      return -1;
    }
  }

  void forget(lws* socket) {
    admitted_.erase(socket);
    const auto found = connections_.find(socket);
    if (found == connections_.end()) return;
    found->second->ended();
    connections_.erase(found);
    clients_ = connections_.size();
  }

  const ServerSettings settings_;
  const Logger& log_;
  /// The library refers to them.
  const std::string policy_;
  const lws_protocol_vhost_options headers_{&kSniff, nullptr, "content-security-policy:", policy_.c_str()};
  std::vector<std::string> names_;
  std::unordered_map<std::string, Protocol*> protocols_;
  std::vector<lws_protocols> table_;
  lws_retry_bo_t idle_{};
  int port_ = 0;
  std::shared_ptr<Waker> waker_;
  std::size_t mostSockets_ = 0;
  std::unordered_set<lws*> sockets_;
  Handshakes handshakes_;
  /// Where the connection being accepted comes from.
  Handshakes::Address newPeer_ = 0;
  /// Whether a call of `lws_cancel_service` has ended a wait.
  bool canBeWoken_ = false;
  /// Reasons for refusals so far.
  std::unordered_set<std::string> reasons_;
  /// Accepted handshakes, with write access or not, until they are connections.
  std::unordered_map<lws*, bool> admitted_;
  std::unordered_map<lws*, std::shared_ptr<Connection>> connections_;
  std::atomic<std::size_t> clients_ = 0;
  std::vector<unsigned char> buffer_;
  std::atomic<bool> mustEnd_ = false;
  struct Destroy {
    void operator()(lws_context* context) const { lws_context_destroy(context); }
  };
  // after all that its callbacks use
  std::unique_ptr<lws_context, Destroy> context_;
  // last, because it uses the members above
  std::thread thread_;
};

Server::Server(ServerSettings settings, const Logger& log, const std::vector<Protocol*>& protocols)
    : loop_(std::make_unique<Loop>(std::move(settings), log, protocols)) {}

Server::~Server() = default;

int Server::port() const { return loop_->port(); }

std::size_t Server::clients() const { return loop_->clients(); }

}  // namespace pongsim::web
