/// SHA-256, by which a checkpoint tells whether it is whole, and whose it is.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace mpm {

inline constexpr std::size_t sha256_bytes = 32;

/// One under way.
class Sha256 {
 public:
  Sha256();
  Sha256& add(std::string_view bytes);
  /// The digest as 32 bytes; nothing may be added any more.
  [[nodiscard]] std::string digest();

 private:
  struct Context;
  struct Free {
    void operator()(Context* context) const;
  };
  std::unique_ptr<Context, Free> context_;
};

}  // namespace mpm
