/// HDF5 files as the commands read them: each at first in a process of its own, see trial.hpp.
#pragma once

#include <string>

#include "libmpm/solver/frame.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// As the functions of the libraries.
/// @throws what they throw, and Rejected (Exit::data) for a file that HDF5 does not survive.
[[nodiscard]] specimen::Specimen read_specimen(const std::string& path);
[[nodiscard]] mpm::Result read_result(const std::string& path);
[[nodiscard]] std::string read_scene_text(const std::string& path);
[[nodiscard]] mpm::Frame read_frame(const std::string& path);
[[nodiscard]] mpm::Frame read_frame_heading(const std::string& path);

}  // namespace app
