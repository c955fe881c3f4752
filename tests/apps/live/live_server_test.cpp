#include "apps/live/live_server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "apps/text/complaint.hpp"

namespace live_server_test {

/// A server with a fixed page, and a client of it.
class Server : public testing::Test {
 protected:
  /// "/SECRET/"
  [[nodiscard]] std::string root() const { return address_.substr(address_.find('/', 7)); }
  [[nodiscard]] std::string origin() const { return address_.substr(0, address_.find('/', 7)); }
  [[nodiscard]] int port() const { return std::stoi(address_.substr(address_.rfind(':') + 1)); }
  [[nodiscard]] int status(const std::string& path) {
    const httplib::Result result = client_.Get(path);
    return result ? result->status : 0;
  }

  std::atomic<int> stops_ = 0;
  [[nodiscard]] std::string ordered() {
    const std::lock_guard lock(mutex_);
    return std::exchange(ordered_, "");
  }

  std::mutex mutex_;
  std::string ordered_;
  std::optional<std::string> page_ = "<p>page</p>";
  app::LiveServer server_{
      0,
      {[this] { return page_; },
       [](std::int64_t have) {
         if (have == 13) throw std::runtime_error("no luck");
         return have < 7 ? std::optional<std::string>("{\"number\": 7}") : std::nullopt;
       },
       [this] { ++stops_; },
       {{"part",
         [] {
           return app::LiveReply{200, "\x01\x02", "application/octet-stream"};
         }}},
       {{"order",
         [this](const std::string& content) {
           ordered_ = content;
           return content == "bad" ? app::LiveReply{400, "{\"error\": \"bad\"}"} : app::LiveReply{200, "{}"};
         }}},
       1000}};
  std::string address_ = server_.address();
  httplib::Client client_{origin()};
};

TEST_F(Server, GivesThePageAndWhatIsNew) {
  EXPECT_EQ(client_.Get(root())->body, "<p>page</p>");
  const auto update = client_.Get(root() + "now?have=6");
  EXPECT_EQ(update->status, 200);
  EXPECT_EQ(update->body, "{\"number\": 7}");
  EXPECT_EQ(status(root() + "now?have=7"), 204);
  EXPECT_EQ(client_.Get(root() + "now?have=x")->body, "{\"number\": 7}") << "no number has nothing";
}

TEST_F(Server, StopsOnlyWhenItIsPosted) {
  EXPECT_EQ(status(root() + "stop"), 404);
  EXPECT_EQ(stops_, 0);
  EXPECT_EQ(client_.Post(root() + "stop")->status, 204);
  EXPECT_EQ(stops_, 1);
}

TEST_F(Server, GivesFurtherPartsAndTakesOrders) {
  const auto part = client_.Get(root() + "part");
  EXPECT_EQ(part->body, "\x01\x02");
  EXPECT_EQ(part->get_header_value("Content-Type"), "application/octet-stream");
  EXPECT_EQ(client_.Post(root() + "order", "do it", "application/json")->status, 200);
  EXPECT_EQ(ordered(), "do it");
  EXPECT_EQ(status(root() + "order"), 404) << "it must be posted";
  const auto refused = client_.Post(root() + "order", "bad", "application/json");
  EXPECT_EQ(refused->status, 400);
  EXPECT_EQ(refused->body, "{\"error\": \"bad\"}");
}

TEST_F(Server, DoesNothingWithAnOrderThatIsTooLarge) {
  EXPECT_EQ(client_.Post(root() + "order", std::string(1000, 'x'), "text/plain")->status, 200);
  EXPECT_EQ(ordered().size(), 1000U);
  for (const std::size_t size : {std::size_t{1001}, std::size_t{30'000}, std::size_t{5'000'000}}) {
    const auto answer = client_.Post(root() + "order", std::string(size, 'x'), "text/plain");
    ASSERT_TRUE(answer) << size;
    EXPECT_EQ(answer->status, 413) << size;
  }
  const auto in_pieces = client_.Post(
      root() + "order",
      [](std::size_t offset, httplib::DataSink& sink) {
        if (offset >= 100'000) sink.done();
        return sink.write(std::string(1000, 'x').data(), 1000);
      },
      "text/plain");
  EXPECT_TRUE(!in_pieces || in_pieces->status == 413);
  EXPECT_EQ(ordered(), "");
  EXPECT_EQ(client_.Post(root() + "order", "again", "text/plain")->status, 200);
}

TEST_F(Server, TakesNoOrdersFromOthers) {
  std::string wrong = root();
  wrong[5] = wrong[5] == '0' ? '1' : '0';
  EXPECT_EQ(client_.Post(wrong + "order", "x", "text/plain")->status, 404);
  EXPECT_EQ(client_.Post(root() + "order", {{"Host", "evil.example"}}, "x", "text/plain")->status, 404);
  for (const std::string origin : {"http://evil.example", "null", "http://127.0.0.1:1"})
    EXPECT_EQ(client_.Post(root() + "order", {{"Origin", origin}}, "x", "text/plain")->status, 404) << origin;
  EXPECT_EQ(client_.Post(root() + "stop", {{"Origin", "http://evil.example"}}, "", "text/plain")->status,
            404);
  EXPECT_EQ(ordered(), "");
  EXPECT_EQ(stops_, 0);
  EXPECT_EQ(client_.Post(root() + "order", {{"Origin", this->origin()}}, "x", "text/plain")->status, 200);
}

TEST_F(Server, AsksToComeAgainWhereThereIsNoPageYet) {
  page_.reset();
  const auto answer = client_.Get(root());
  EXPECT_EQ(answer->status, 503);
  EXPECT_NE(answer->body.find("http-equiv=\"refresh\""), std::string::npos);
}

TEST_F(Server, HasNothingForThoseWhoDoNotKnowTheSecret) {
  std::string wrong = root();
  wrong[5] = wrong[5] == '0' ? '1' : '0';
  for (const std::string& path :
       {std::string("/"), std::string("//"), wrong, wrong + "now", root().substr(0, 33),
        root() + "../../etc/passwd", std::string("/favicon.ico"), "/" + std::string(100'000, 'a') + "/"})
    EXPECT_GE(status(path), 400) << path.substr(0, 60);
  EXPECT_EQ(client_.Post(wrong + "stop")->status, 404);
  EXPECT_EQ(stops_, 0);
}

// A page from elsewhere whose name was made to mean this machine.
TEST_F(Server, HasNothingForThoseWhoNameAnotherHost) {
  for (const std::string host : {"evil.example", "evil.example:80", "127.0.0.1", "127.0.0.1:1"})
    EXPECT_EQ(client_.Get(root(), {{"Host", host}})->status, 404) << host;
  EXPECT_EQ(client_.Get(root(), {{"Host", "localhost:" + std::to_string(port())}})->status, 200);
}

TEST_F(Server, SaysThatNobodyElseMayShowOrKeepIt) {
  const auto answer = client_.Get(root());
  EXPECT_EQ(answer->get_header_value("Cache-Control"), "no-store");
  EXPECT_EQ(answer->get_header_value("Referrer-Policy"), "no-referrer");
  EXPECT_EQ(answer->get_header_value("Content-Security-Policy"), "frame-ancestors 'none'");
  EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
  EXPECT_FALSE(answer->has_header("Access-Control-Allow-Origin"));
}

TEST_F(Server, OutlivesAnAnswerThatFails) {
  const auto answer = client_.Get(root() + "now?have=13");
  EXPECT_EQ(answer->status, 500);
  EXPECT_EQ(answer->body.find("no luck"), std::string::npos);
  EXPECT_EQ(status(root()), 200);
}

TEST_F(Server, ListensOnThisMachineAlone) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in other{};
  other.sin_family = AF_INET;
  other.sin_port = htons(static_cast<std::uint16_t>(port()));
  inet_pton(AF_INET, "127.0.0.2", &other.sin_addr);  // leads here too, where all addresses are listened to
  EXPECT_NE(connect(socket, reinterpret_cast<const sockaddr*>(&other), sizeof other), 0);
  close(socket);
}

TEST_F(Server, SaysWhenThePortIsTaken) {
  try {
    const app::LiveServer second(port(), {});
    FAIL() << "two servers on one port";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::io);
    EXPECT_EQ(std::string(rejected.what()), "--port: " + std::to_string(port()) +
                                                "; is in use or not permitted; omit it to use any free port");
  }
}

/// Who connects, and does not do what others do.
class Guest {
 public:
  explicit Guest(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, "127.0.0.1", &here.sin_addr);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here), 0);
  }
  Guest(const Guest&) = delete;
  Guest& operator=(const Guest&) = delete;
  ~Guest() { close(socket_); }

  /// @return whether the other side still listens.
  [[nodiscard]] bool say(const std::string& text) const {
    return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
  }
  /// All that the other side says until it hangs up.
  [[nodiscard]] std::string hear() const {
    std::string all(1'000'000, '\0');
    std::size_t size = 0;
    for (ssize_t count = 1; count > 0 && size < all.size(); size += static_cast<std::size_t>(count)) {
      count = ::recv(socket_, &all[size], all.size() - size, 0);
      if (count <= 0) break;
    }
    return all.substr(0, size);
  }

 private:
  int socket_;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Who connects and says nothing holds nobody up.
TEST_F(Server, EndsBesideASilentGuest) {
  const Guest guest(port());
  EXPECT_EQ(status(root()), 200);
}

/// Guests of a server that say a letter now and then, so that no call on their sockets takes long.
class SlowGuests {
 public:
  SlowGuests(int port, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) guests_.push_back(std::make_unique<Guest>(port));
    for (const auto& guest : guests_) EXPECT_TRUE(guest->say("GET / HTTP/1.1\r\nName: "));
    thread_ = std::thread([this] {
      while (!ends_) {
        for (const auto& guest : guests_) (void)guest->say("x");
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    });
  }
  SlowGuests(const SlowGuests&) = delete;
  SlowGuests& operator=(const SlowGuests&) = delete;
  ~SlowGuests() {
    ends_ = true;
    thread_.join();
  }

 private:
  std::vector<std::unique_ptr<Guest>> guests_;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

TEST_F(Server, AnswersOthersBesideManySlowGuests) {
  const SlowGuests guests(port(), 40);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(status(root()), 200);
  EXPECT_LT(seconds_since(begin), 5) << "five times eight of them, of two seconds each, would take ten";
}

TEST(LiveServer, EndsAtOnceBesideSlowGuests) {
  auto server = std::make_unique<app::LiveServer>(
      0, app::LiveAnswers{[] { return "page"; }, [](std::int64_t) { return std::nullopt; }, [] {}});
  const std::string address = server->address();
  const SlowGuests guests(std::stoi(address.substr(address.rfind(':') + 1)), 12);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const auto begin = std::chrono::steady_clock::now();
  server.reset();
  EXPECT_LT(seconds_since(begin), 1);
}

TEST_F(Server, GivesASlowGuestLittleTime) {
  const Guest guest(port());
  const auto begin = std::chrono::steady_clock::now();
  bool listens = guest.say("GET / HTTP/1.1\r\nName: ");
  while (listens && seconds_since(begin) < 10) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    listens = guest.say("x");
  }
  EXPECT_LT(seconds_since(begin), 4);
}

TEST_F(Server, TakesOrdersBesideGuestsWhoseOrdersComeSlowly) {
  std::vector<std::unique_ptr<Guest>> guests;
  for (int i = 0; i < 40; ++i) {
    guests.push_back(std::make_unique<Guest>(port()));
    EXPECT_TRUE(guests.back()->say("POST " + root() + "order HTTP/1.1\r\nHost: localhost:" +
                                   std::to_string(port()) + "\r\nContent-Length: 900\r\n\r\nx"));
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(client_.Post(root() + "order", "mine", "text/plain")->status, 200);
  EXPECT_LT(seconds_since(begin), 5);
  EXPECT_EQ(ordered(), "mine") << "half an order is none";
}

TEST_F(Server, TakesNoEndlessHeader) {
  const Guest guest(port());
  EXPECT_TRUE(guest.say("GET " + root() + " HTTP/1.1\r\nHost: localhost:" + std::to_string(port()) + "\r\n"));
  std::string lines;
  for (int i = 0; i < 20'000; ++i) lines += "X-" + std::to_string(i) + ": 1\r\n";
  (void)guest.say(lines);
  (void)guest.say("\r\n");
  EXPECT_EQ(guest.hear().find("200 OK"), std::string::npos);
  EXPECT_EQ(status(root()), 200) << "of another guest";
}

TEST(Token, IsLongAndNeverTheSame) {
  const std::string token = app::random_token();
  EXPECT_THAT(token, testing::MatchesRegex("[0-9a-f]+"));
  EXPECT_EQ(token.size(), 32U);
  EXPECT_NE(token, app::random_token());
}

TEST(Token, IsTheSameInEveryLetterOnly) {
  EXPECT_TRUE(app::same_secret("0123abcd", "0123abcd"));
  EXPECT_FALSE(app::same_secret("0123abce", "0123abcd"));
  EXPECT_FALSE(app::same_secret("1123abcd", "0123abcd"));
  EXPECT_FALSE(app::same_secret("0123abc", "0123abcd"));
  EXPECT_FALSE(app::same_secret("0123abcd0", "0123abcd"));
  EXPECT_FALSE(app::same_secret("", "0123abcd"));
}

}  // namespace live_server_test
