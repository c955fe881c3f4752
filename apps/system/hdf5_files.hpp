/// HDF5 files as the commands read them: each at first in a process of its own, one thread at a time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "libmpm/files/result_file.hpp"
#include "libmpm/files/table_file.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/solver/frame.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// Read a file in a process of its own, which is thrown away. HDF5 1.10 checks little of what a damaged file
/// tells it, and with some of them it ends the program by a signal, or never comes back.
/// @param read  its exceptions are none of the trial: they come again when the program itself reads the file.
/// @param seconds  of computing that it may take; 0 = 20 s, and a second more for each 20 MB of the file.
/// @throws Rejected (Exit::data) when the process died, or took longer. Where no process can be had there is
/// no trial.
void try_reading(const std::string& path, const std::function<void()>& read, unsigned seconds = 0);

/// To be held while a file of HDF5 is read or written by one of several threads; none is held by an empty
/// one.
using Hdf5Turn = std::shared_ptr<const void>;

/// Wait until no other thread has the turn, and take it.
[[nodiscard]] Hdf5Turn hdf5_turn();

/// Where others in the process use HDF5 as well, and take turns in their own way: `take` is called in place
/// of the lock that the program has. Once, before there are threads.
void take_hdf5_turns_by(std::function<Hdf5Turn()> take);

/// As the functions of the libraries.
/// @throws what they throw, and Rejected (Exit::data) for a file that HDF5 does not survive.
[[nodiscard]] specimen::Specimen read_specimen(const std::string& path);
[[nodiscard]] mpm::Result read_result(const std::string& path);
[[nodiscard]] std::string read_scene_text(const std::string& path);
[[nodiscard]] mpm::RunTexts read_run_texts(const std::string& path);
[[nodiscard]] mpm::Frame read_frame(const std::string& path);
[[nodiscard]] mpm::Frame read_frame_heading(const std::string& path);
[[nodiscard]] std::vector<mpm::TableColumn> read_table(const std::string& path);

}  // namespace app
