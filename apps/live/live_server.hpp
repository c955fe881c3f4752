/// A web server for this machine only; its address holds a secret.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace app {

/// 128 bits of the system's own randomness as 32 hexadecimal digits.   @throws std::system_error without it.
[[nodiscard]] std::string random_token();

/// In a time that does not depend on where they differ.
[[nodiscard]] bool same_secret(std::string_view given, std::string_view secret);

/// What it answers with; called from threads of its own, several at a time.
struct LiveAnswers {
  std::function<std::optional<std::string>()> page;  ///< HTML; nothing = it is too early
  /// JSON of what is newer than the reader has; nothing = there is nothing newer.
  std::function<std::optional<std::string>(std::int64_t have)> update;
  std::function<void()> stop;  ///< the reader wants the run to end
};

/// Listens on 127.0.0.1 alone. All that it has lies below a secret path, and a request that names another
/// host is refused, so that no page from elsewhere reaches it through the reader's browser.
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
