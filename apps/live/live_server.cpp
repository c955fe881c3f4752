#include "apps/live/live_server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <openssl/crypto.h>
#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "apps/text/complaint.hpp"

namespace app {

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "getrandom");
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

bool same_secret(std::string_view given, std::string_view secret) {
  return given.size() == secret.size() && CRYPTO_memcmp(given.data(), secret.data(), secret.size()) == 0;
}

namespace {

constexpr const char* host = "127.0.0.1";
constexpr std::size_t threads = 8;                        ///< more readers than that wait for each other
constexpr std::size_t most_waiting = 32;                  ///< of more the oldest connections are closed
constexpr std::size_t largest_header = 16384;             ///< of a request, all its lines [bytes]
constexpr std::chrono::milliseconds to_ask{2000};         ///< for the whole of a request
constexpr std::chrono::milliseconds to_ask_in_turn{100};  ///< the same while others wait for the thread
constexpr std::chrono::milliseconds to_take{10000};       ///< for the whole of an answer

constexpr const char* too_early =
    "<!DOCTYPE html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"1\">"
    "<title>The run is starting</title><p>The run is starting …</p>";

/// As it is: to compress it for a reader on the same machine would only take time from the run.
void send(httplib::Response& response, std::string body, const char* type) {
  const auto kept = std::make_shared<const std::string>(std::move(body));
  response.set_content_provider(kept->size(), type,
                                [kept](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(kept->data() + from, length);
                                });
}

std::int64_t number_of(const std::string& text) {
  std::int64_t number = -1;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// The page says what else it may do; this holds for all that is sent.
httplib::Headers headers() {
  return {{"Cache-Control", "no-store"},
          {"Content-Security-Policy", "frame-ancestors 'none'"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Referrer-Policy", "no-referrer"},
          {"X-Content-Type-Options", "nosniff"}};
}

}  // namespace

namespace {

using Clock = std::chrono::steady_clock;

/// A connection that has so much time for a request and for its answer, however the bytes come.
class TimedStream : public httplib::Stream {
 public:
  /// @param others_wait  whether others wait now; asked again and again.   @param largest_content  [bytes]
  TimedStream(socket_t socket, const std::atomic<bool>& others_wait, std::size_t largest_content)
      : socket_(socket), others_wait_(others_wait), largest_content_(largest_content) {}

  [[nodiscard]] bool is_readable() const override {
    while (true) {
      const Clock::time_point until = begin_ + (others_wait_ ? to_ask_in_turn : to_ask);
      if (is_ready(POLLIN, std::min(until, Clock::now() + to_ask_in_turn / 2))) return true;
      if (Clock::now() >= until) return false;
    }
  }
  [[nodiscard]] bool is_writable() const override { return is_ready(POLLOUT, begin_ + to_ask + to_take); }

  ssize_t read(char* bytes, std::size_t size) override {
    if (taken_ >= most_ || !is_readable()) return -1;
    const ssize_t count = ::recv(socket_, bytes, std::min(size, most_ - taken_), MSG_DONTWAIT);
    if (count > 0) note(std::string_view(bytes, static_cast<std::size_t>(count)));
    return count;
  }
  ssize_t write(const char* bytes, std::size_t size) override {
    if (!is_writable()) return -1;
    return ::send(socket_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL);
  }
  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    ip = host;
    port = 0;
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    ip = host;
    port = 0;
  }
  [[nodiscard]] socket_t socket() const override { return socket_; }

  /// Says that the lines of a request are too many, where they are.
  void refuse_if_too_large() {
    if (is_in_content_ || taken_ < most_) return;
    constexpr std::string_view answer =
        "HTTP/1.1 431 Request Header Fields Too Large\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";
    (void)write(answer.data(), answer.size());
    pass_over_rest();
  }

  /// What was said is lost where a connection is closed over bytes that nobody has read.
  void pass_over_rest() {
    ::shutdown(socket_, SHUT_WR);
    std::array<char, 4096> rest{};
    while (is_readable() && ::recv(socket_, rest.data(), rest.size(), MSG_DONTWAIT) > 0) continue;
  }

 private:
  /// An empty line ends the lines of the request; as much content may follow as is allowed.
  void note(std::string_view bytes) {
    taken_ += bytes.size();
    constexpr std::string_view empty_line = "\r\n\r\n";
    for (const char byte : bytes) {
      if (is_in_content_) return;
      seen_ = byte == empty_line[seen_] ? seen_ + 1 : byte == '\r' ? 1 : 0;
      is_in_content_ = seen_ == empty_line.size();
      if (is_in_content_) most_ = taken_ + largest_content_ + chunk_lines;
    }
  }

  static constexpr std::size_t chunk_lines = 1024;  ///< of content that comes in pieces [bytes]

  [[nodiscard]] bool is_ready(short what, Clock::time_point until) const {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd asked{socket_, what, 0};
    return left > 0 && ::poll(&asked, 1, static_cast<int>(left)) > 0;
  }

  socket_t socket_;
  const std::atomic<bool>& others_wait_;
  std::size_t largest_content_;
  Clock::time_point begin_ = Clock::now();
  std::size_t taken_ = 0, most_ = largest_header;
  std::size_t seen_ = 0;  ///< letters of the empty line
  bool is_in_content_ = false;
};

/// What this thread is given is closed, and not answered.
thread_local bool refuses = false;

/// The answer of this thread is an error, so that there may be more of the request.
thread_local bool is_error = false;

/// The server of httplib with an end to every connection: it gives the time of a socket call only, so that a
/// request that comes byte by byte would take any time.
class TimedServer : public httplib::Server {
 public:
  std::atomic<bool> others_wait = false;  ///< for a thread: requests are cut short
  std::size_t largest_content = 1;        ///< of a request [bytes]

  void close_all() {
    const std::lock_guard lock(mutex_);
    closes_ = true;
    for (const socket_t socket : open_) ::shutdown(socket, SHUT_RDWR);
  }

 private:
  bool process_and_close_socket(socket_t socket) override {
    bool is_answered = false, is_closed = false;
    if (!refuses && enter(socket)) {
      TimedStream stream(socket, others_wait, largest_content);
      is_error = false;
      is_answered = process_request(stream, true, is_closed, {});
      if (!is_answered) stream.refuse_if_too_large();
      if (is_error) stream.pass_over_rest();
    }
    leave(socket);
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
    return is_answered;
  }

  /// @return whether the server goes on.
  bool enter(socket_t socket) {
    const std::lock_guard lock(mutex_);
    open_.push_back(socket);
    return !closes_;
  }
  void leave(socket_t socket) {
    const std::lock_guard lock(mutex_);
    std::erase(open_, socket);
  }

  std::mutex mutex_;
  bool closes_ = false;
  std::vector<socket_t> open_;
};

/// Threads that answer.
class Readers {
 public:
  /// With one thread.   @throws std::system_error where the system gives none.
  explicit Readers(TimedServer& server) : server_(server) { add_thread(); }
  ~Readers() { end(); }
  Readers(const Readers&) = delete;
  Readers& operator=(const Readers&) = delete;

  /// As many threads as the system gives.
  void grow() {
    try {
      while (threads_.size() < threads) add_thread();
    } catch (const std::system_error&) {  // those that there are will do
    }
  }

  /// @return what has waited longest, and has no place any more; may be empty.
  [[nodiscard]] std::function<void()> take(std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(work));
    server_.others_wait = busy_ == threads_.size();
    changed_.notify_one();
    if (waiting_.size() <= most_waiting) return {};
    std::function<void()> oldest = std::move(waiting_.front());
    waiting_.pop_front();
    return oldest;
  }

  void end() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    threads_.clear();
  }

 private:
  void add_thread() {
    const std::lock_guard lock(mutex_);
    threads_.emplace_back([this] { work(); });
  }

  void work() {
    for (std::unique_lock lock(mutex_);;) {
      changed_.wait(lock, [&] { return !waiting_.empty() || ends_; });
      if (waiting_.empty()) return;
      const std::function<void()> next = std::move(waiting_.front());
      waiting_.pop_front();
      ++busy_;
      server_.others_wait = busy_ == threads_.size() && !waiting_.empty();
      lock.unlock();
      next();
      lock.lock();
      --busy_;
    }
  }

  TimedServer& server_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  std::size_t busy_ = 0;
  bool ends_ = false;
  std::vector<std::jthread> threads_;
};

/// What httplib takes: it owns its queue, and makes it where no fault can be told any more.
class QueueOfReaders : public httplib::TaskQueue {
 public:
  explicit QueueOfReaders(Readers& readers) : readers_(readers) {}
  void enqueue(std::function<void()> work) override {
    const std::function<void()> one_too_many = readers_.take(std::move(work));
    if (!one_too_many) return;
    refuses = true;
    one_too_many();
    refuses = false;
  }
  void shutdown() override { readers_.end(); }

 private:
  Readers& readers_;
};

}  // namespace

struct LiveServer::Parts {
  LiveAnswers answers;
  std::string token = random_token();
  TimedServer server;
  std::optional<Readers> readers;
  int port = 0;
  std::thread listener;

  /// Whether a text, without what stands before, names this server.
  [[nodiscard]] bool is_this(const std::string& text, const char* before) const {
    return text == fmt::format("{}{}:{}", before, host, port) ||
           text == fmt::format("{}localhost:{}", before, port);
  }

  [[nodiscard]] bool may_ask(const httplib::Request& request) const {
    if (!is_this(request.get_header_value("Host"), "")) return false;
    if (request.method != "GET" && request.has_header("Origin") &&
        !is_this(request.get_header_value("Origin"), "http://"))
      return false;
    const std::string_view path = request.path;
    return path.size() > token.size() + 1 && path[token.size() + 1] == '/' &&
           same_secret(path.substr(1, token.size()), token);
  }

  void set_up() {
    using httplib::Request;
    using httplib::Response;
    using Handled = httplib::Server::HandlerResponse;
    readers.emplace(server);
    server.new_task_queue = [this] { return new QueueOfReaders(*readers); };
    server.set_socket_options([](int socket) {  // a port that another process holds is not shared with it
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_keep_alive_max_count(1);  // a connection that stays open would hold up the end
    server.largest_content = answers.largest_order;
    server.set_payload_max_length(answers.largest_order);
    server.set_default_headers(headers());
    server.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (may_ask(request)) return Handled::Unhandled;
      response.status = 404;
      return Handled::Handled;
    });
    server.set_exception_handler([](const Request&, Response& response, const std::exception_ptr&) {
      response.status = 500;  // the run does not suffer from those who watch it
    });
    server.set_error_handler([](const Request&, Response&) { is_error = true; });
    server.Get("/[0-9a-f]+/", [this](const Request&, Response& response) {
      std::optional<std::string> page = answers.page();
      if (!page) response.status = 503;
      send(response, page ? std::move(*page) : too_early, "text/html; charset=utf-8");
    });
    server.Get("/[0-9a-f]+/now", [this](const Request& request, Response& response) {
      auto update = answers.update(number_of(request.get_param_value("have")));
      if (update)
        send(response, std::move(*update), "application/json");
      else
        response.status = 204;
    });
    server.Post("/[0-9a-f]+/stop", [this](const Request&, Response& response) {
      answers.stop();
      response.status = 204;
    });
    const auto reply = [](Response& response, LiveReply with) {
      response.status = with.status;
      if (with.status >= 400)  // its length must be known before the error handler is asked
        response.set_content(with.body, with.type);
      else
        send(response, std::move(with.body), with.type);
    };
    for (const auto& [name, part] : answers.parts)
      server.Get("/[0-9a-f]+/" + name,
                 [reply, &part = part](const Request&, Response& response) { reply(response, part()); });
    for (const auto& [name, order] : answers.orders)
      server.Post("/[0-9a-f]+/" + name, [reply, &order = order](const Request& request, Response& response) {
        reply(response, order(request.body));
      });
  }
};

LiveServer::LiveServer(int port, LiveAnswers answers) try : parts_(std::make_unique<Parts>()) {
  parts_->answers = std::move(answers);
  parts_->set_up();
  parts_->port = port > 0 ? (parts_->server.bind_to_port(host, port) ? port : -1)
                          : parts_->server.bind_to_any_port(host);
  if (parts_->port <= 0)
    throw Rejected(Exit::io, "--port", std::to_string(port), "is in use or not permitted",
                   "omit it to use any free port");
  parts_->listener = std::thread([parts = parts_.get()] { parts->server.listen_after_bind(); });
  while (!parts_->server.is_running())
    std::this_thread::yield();  // else stop() would come too early to be heard
  parts_->readers->grow();
} catch (const std::system_error& error) {
  const std::string option = answers.option;  // a pointer, which is there after the move too
  throw Rejected(Exit::interrupted, option, error.what(), "needs two threads beside the run",
                 "end other programs, raise the limit on processes (ulimit -u), or leave " + option + " out");
}

LiveServer::~LiveServer() {
  parts_->server.close_all();
  parts_->server.stop();
  parts_->listener.join();
}

std::string LiveServer::address() const {
  return fmt::format("http://{}:{}/{}/", host, parts_->port, parts_->token);
}

}  // namespace app
