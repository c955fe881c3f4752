#include "apps/system/hdf5_files.hpp"

#include "apps/system/trial.hpp"
#include "libmpm/files/frame_file.hpp"
#include "libmpm/files/result_file.hpp"
#include "specimen/file/specimen_file.hpp"

namespace app {
namespace {

template <class Read>
auto tried(const std::string& path, Read read) {
  try_reading(path, [&] { (void)read(path); });
  return read(path);
}

}  // namespace

specimen::Specimen read_specimen(const std::string& path) { return tried(path, specimen::read_specimen); }

mpm::Result read_result(const std::string& path) { return tried(path, mpm::read_result); }

std::string read_scene_text(const std::string& path) { return tried(path, mpm::read_scene_text); }

mpm::Frame read_frame(const std::string& path) { return tried(path, mpm::read_frame); }

mpm::Frame read_frame_heading(const std::string& path) { return tried(path, mpm::read_frame_heading); }

}  // namespace app
