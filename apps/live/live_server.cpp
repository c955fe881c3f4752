#include "apps/live/live_server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <openssl/crypto.h>
#include <sys/random.h>
#include <array>
#include <cerrno>
#include <charconv>
#include <system_error>
#include <thread>

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
constexpr int threads = 8;          ///< more readers than that wait for each other
constexpr int patience_s = 2;       ///< with a reader who does not go on
constexpr int largest_request = 1;  ///< [bytes] of content: there is none to send

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

struct LiveServer::Parts {
  LiveAnswers answers;
  std::string token = random_token();
  httplib::Server server;
  int port = 0;
  std::thread listener;

  [[nodiscard]] bool may_ask(const httplib::Request& request) const {
    const std::string asked = request.get_header_value("Host");
    if (asked != fmt::format("{}:{}", host, port) && asked != fmt::format("localhost:{}", port)) return false;
    const std::string_view path = request.path;
    return path.size() > token.size() + 1 && path[token.size() + 1] == '/' &&
           same_secret(path.substr(1, token.size()), token);
  }

  void set_up() {
    using httplib::Request;
    using httplib::Response;
    using Handled = httplib::Server::HandlerResponse;
    server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server.set_socket_options([](int socket) {  // a port that another process holds is not shared with it
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_keep_alive_max_count(1);  // a connection that stays open would hold up the end
    server.set_read_timeout(patience_s);
    server.set_write_timeout(patience_s);
    server.set_payload_max_length(largest_request);
    server.set_default_headers(headers());
    server.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (may_ask(request)) return Handled::Unhandled;
      response.status = 404;
      return Handled::Handled;
    });
    server.set_exception_handler([](const Request&, Response& response, const std::exception_ptr&) {
      response.status = 500;  // the run does not suffer from those who watch it
    });
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
  }
};

LiveServer::LiveServer(int port, LiveAnswers answers) : parts_(std::make_unique<Parts>()) {
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
}

LiveServer::~LiveServer() {
  parts_->server.stop();
  parts_->listener.join();
}

std::string LiveServer::address() const {
  return fmt::format("http://{}:{}/{}/", host, parts_->port, parts_->token);
}

}  // namespace app
