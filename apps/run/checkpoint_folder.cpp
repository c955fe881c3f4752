#include "apps/run/checkpoint_folder.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

#include "libmpm/scene/error.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* stem = "step_";
constexpr const char* ending = ".checkpoint";
constexpr std::size_t kept = 2;

std::string name_of(std::int64_t step) { return fmt::format("{}{:012}{}", stem, step, ending); }

/// The step of a name that name_of() gives.
std::optional<std::int64_t> step_of(const std::string& name) {
  if (!name.starts_with(stem) || !name.ends_with(ending)) return std::nullopt;
  const char* begin = name.data() + std::strlen(stem);
  std::int64_t step = 0;
  const auto [end, error] = std::from_chars(begin, name.data() + name.size(), step);
  if (error != std::errc() || step < 0 || name != name_of(step)) return std::nullopt;
  return step;
}

/// Of a checkpoint that was not yet renamed when the program ended.
bool is_remainder(const std::string& name) {
  const std::size_t end = name.find(ending);
  return end != std::string::npos && step_of(name.substr(0, end + std::strlen(ending))) &&
         name.ends_with(".tmp");
}

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw mpm::FileError(path.string(), "cannot be removed: " + error.message(), "",
                         "choose a folder that may be written to");
}

}  // namespace

std::map<std::int64_t, fs::path> CheckpointFolder::files() const {
  std::map<std::int64_t, fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
    if (const auto step = step_of(entry.path().filename().string())) found[*step] = entry.path();
  return found;
}

void CheckpointFolder::write(const mpm::Checkpoint& checkpoint, const std::string& scene_text,
                             const std::string& remarks) {
  const auto begin = std::chrono::steady_clock::now();
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    throw mpm::FileError(folder_.string(), "cannot be created: " + error.message(), "",
                         "choose a folder that may be written to");
  mpm::write_checkpoint((folder_ / name_of(checkpoint.step)).string(), checkpoint, scene_text, remarks);
  std::map<std::int64_t, fs::path> all = files();
  for (; all.size() > kept; all.erase(all.begin())) remove_file(all.begin()->second);
  ++written_;
  wall_time_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

CheckpointFolder::Found CheckpointFolder::last() const {
  Found found;
  const std::map<std::int64_t, fs::path> all = files();
  for (auto one = all.rbegin(); one != all.rend() && !found.last; ++one) {
    try {
      found.last = Last{one->second, mpm::read_checkpoint(one->second.string())};
    } catch (const mpm::FileError& error) {
      found.faults.emplace_back(error.what());
    }
  }
  return found;
}

void CheckpointFolder::remove_behind(std::int64_t step) const {
  std::error_code error;
  std::vector<fs::path> doomed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
    if (is_remainder(entry.path().filename().string())) doomed.push_back(entry.path());
  for (const auto& [of_step, path] : files())
    if (of_step > step) doomed.push_back(path);
  for (const fs::path& path : doomed) remove_file(path);
  fs::remove(folder_, error);  // fails, as it should, while something is in it
}

CheckpointWriter::CheckpointWriter(CheckpointFolder& folder, std::string scene_text, std::string remarks)
    : folder_(folder), scene_text_(std::move(scene_text)), remarks_(std::move(remarks)) {
  try {
    thread_.emplace([this] { work(); });
  } catch (const std::system_error&) {
    thread_.reset();
  }
}

CheckpointWriter::~CheckpointWriter() {
  wait();
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
}

void CheckpointWriter::write(mpm::Checkpoint checkpoint) {
  wait();
  checkpoint_ = std::move(checkpoint);
  if (!thread_) return write_now();
  {
    const std::lock_guard lock(mutex_);
    busy_ = true;
  }
  changed_.notify_all();
}

void CheckpointWriter::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !busy_; });
}

void CheckpointWriter::work() {
  for (std::unique_lock lock(mutex_);;) {
    changed_.wait(lock, [&] { return busy_ || ends_; });
    if (!busy_) return;
    lock.unlock();
    write_now();
    lock.lock();
    busy_ = false;
    changed_.notify_all();
  }
}

void CheckpointWriter::write_now() {
  const double before = folder_.wall_time();
  trouble_.clear();
  try {
    folder_.write(checkpoint_, scene_text_, remarks_);
    last_time_ = folder_.wall_time() - before;
  } catch (const mpm::FileError& error) {
    trouble_ = error.what();
  } catch (const std::exception& error) {  // no memory for it
    trouble_ = error.what();
  }
  std::string().swap(checkpoint_.state);  // which an assignment of nothing would keep
}

}  // namespace app
