/// Less memory than asked for is an error that says so; without a limit the system would end the program, or
/// another one, without a word.
#pragma once

#include <cstdint>
#include <string>

namespace app {

/// What a program may take [bytes]: what the machine has, or its container may use.
/// @param machine  with its swap space [bytes].   @param container  the file memory.max of the control group;
/// empty = none.
[[nodiscard]] std::uint64_t memory_to_take(std::uint64_t machine, const std::string& container);

/// From here on an allocation beyond the memory there is throws std::bad_alloc. Programs under a sanitizer,
/// which lays out more addresses than there is memory, keep no limit.
void limit_memory();

}  // namespace app
