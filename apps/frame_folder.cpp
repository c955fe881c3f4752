#include "apps/frame_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "libmpm/error.hpp"
#include "libmpm/frame_file.hpp"
#include "libmpm/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* folder_name = "frames";
constexpr const char* series_name = "frames.hdf.series";
constexpr const char* xdmf_name = "frames.xdmf";

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw mpm::FileError(path.string(), "of an earlier run cannot be removed: " + error.message(), "",
                         "choose another folder");
}

/// What is not a frame stays, and with it the folder.
void remove_frames(const fs::path& run) {
  for (const fs::path& frame : frames_of(run)) remove_file(frame);
  std::error_code error;
  if (fs::is_directory(run / folder_name, error)) fs::remove(run / folder_name, error);
}

}  // namespace

std::vector<fs::path> frames_of(const fs::path& run) {
  std::error_code error;
  std::vector<fs::path> frames;
  for (const fs::directory_entry& entry : fs::directory_iterator(run / folder_name, error))
    if (output::is_frame_name(entry.path().filename().string())) frames.push_back(entry.path());
  std::sort(frames.begin(), frames.end(), [](const fs::path& a, const fs::path& b) {
    const std::string left = a.filename().string(), right = b.filename().string();
    return left.size() != right.size() ? left.size() < right.size() : left < right;  // more digits come later
  });
  return frames;
}

FrameFolder::FrameFolder(fs::path run, const mpm::Scene& scene) : run_(std::move(run)), scene_(scene) {
  remove_file(run_ / series_name);
  remove_file(run_ / xdmf_name);
  remove_frames(run_);
}

bool FrameFolder::add(const mpm::Frame& frame) {
  try {
    write(frame, added_++);
    return true;
  } catch (const mpm::FileError& error) {
    if (!failure_) failure_ = error;
    return false;
  }
}

std::optional<mpm::FileError> FrameFolder::failure() const {
  if (!failure_ || written_ == added_) return failure_;
  return mpm::FileError(failure_->field, failure_->value, failure_->cure,
                        fmt::format("{} of {} frames are missing", added_ - written_, added_));
}

void FrameFolder::write(const mpm::Frame& frame, std::int64_t number) {
  const fs::path folder = run_ / folder_name;
  std::error_code error;
  fs::create_directory(folder, error);
  if (error)
    throw mpm::FileError(folder.string(), "cannot be created: " + error.message(), "",
                         "choose a folder that may be written to");
  const std::string name = output::frame_name(number);
  mpm::write_frame((folder / name).string(), frame, scene_);
  ++written_;
  const output::FrameEntry entry{std::string(folder_name) + "/" + name, frame.time,
                                 static_cast<std::int64_t>(frame.points.size())};
  list_.add(entry);
  xdmf_.add(entry);
  mpm::replace_file((run_ / series_name).string(), list_.text());
  mpm::replace_file((run_ / xdmf_name).string(), xdmf_.text());
}

fs::path FrameFolder::series() const { return run_ / series_name; }

}  // namespace app
