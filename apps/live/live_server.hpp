/// A web server for this machine only; its address holds a secret.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace app {

/// 128 bits of the system's own randomness as 32 hexadecimal digits.   @throws std::system_error without it.
[[nodiscard]] std::string random_token();

/// In a time that does not depend on where they differ.
[[nodiscard]] bool same_secret(std::string_view given, std::string_view secret);

/// What is sent back.
struct LiveReply {
  int status = 200;
  std::string body{};
  const char* type = "application/json";
};

/// What it answers with; called from threads of its own, several at a time.
struct LiveAnswers {
  std::function<std::optional<std::string>()> page;  ///< HTML; nothing = it is too early
  /// JSON of what is newer than the reader has; nothing = there is nothing newer.
  std::function<std::optional<std::string>(std::int64_t have)> update;
  std::function<void()> stop;  ///< the reader wants the run to end
  /// What further names below the address give.
  std::map<std::string, std::function<LiveReply()>> parts{};
  /// What is done where something is posted to further names, with its content.
  std::map<std::string, std::function<LiveReply(const std::string& content)>> orders{};
  std::size_t largest_order = 1;   ///< [bytes]; of more content nothing is done, and the answer is 413
  const char* option = "--serve";  ///< what the user asked for, in messages
};

/// Listens on 127.0.0.1 alone. All that it has lies below a secret path, and a request that names another
/// host is refused, so that no page from elsewhere reaches it through the reader's browser; nor does one that
/// is posted by a page of another origin.
class LiveServer {
 public:
  /// @param port  0 = any that is free.   @throws Rejected (Exit::io) when it is not to be had.
  LiveServer(int port, LiveAnswers answers);
  /// Ends every connection.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  [[nodiscard]] std::string address() const;  ///< "http://127.0.0.1:41234/SECRET/"

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace app
