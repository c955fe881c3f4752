/// Whole files as text.
#pragma once

#include <cstddef>
#include <string>

namespace app {

inline constexpr std::size_t longest_text = std::size_t{16} << 20U;    ///< of what a person writes [bytes]
inline constexpr std::size_t longest_table = std::size_t{256} << 20U;  ///< of what a machine measured [bytes]

/// Pipes and devices are read too, and not beyond `longest` bytes.
/// @throws Rejected naming the file: (Exit::io) with the reason of the system, (Exit::data) when it is
/// longer.
[[nodiscard]] std::string read_text_file(const std::string& path, std::size_t longest = longest_text);

}  // namespace app
