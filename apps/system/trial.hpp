/// A first try of what may end the program.
#pragma once

#include <functional>
#include <string>

namespace app {

/// Read a file in a process of its own, which is thrown away. HDF5 1.10 checks little of what a damaged file
/// tells it, and with some of them it ends the program by a signal, or never comes back.
/// @param read  its exceptions are none of the trial: they come again when the program itself reads the file.
/// @param seconds  of computing that it may take; 0 = 20 s, and a second more for each 20 MB of the file.
/// @throws Rejected (Exit::data) when the process died, or took longer. Where no process can be had there is
/// no trial.
void try_reading(const std::string& path, const std::function<void()>& read, unsigned seconds = 0);

}  // namespace app
