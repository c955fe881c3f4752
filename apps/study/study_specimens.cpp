#include "apps/study/study_specimens.hpp"

#include <algorithm>
#include <utility>

#include "apps/system/hdf5_turn.hpp"
#include "apps/job/job.hpp"
#include "apps/scene/scene_text.hpp"

namespace app {
namespace {

using Shared = std::shared_ptr<const specimen::Specimen>;

std::string key_of(const Settings& settings) {
  return std::to_string(settings.scene.points_per_cell) + scene_text(settings, Extent::specimen, {});
}

Shared make(const Settings& settings) {
  const Hdf5Turn turn = source_of(settings) == Source::file ? hdf5_turn() : Hdf5Turn();
  return std::make_shared<const specimen::Specimen>(prepare_cells(settings).specimen);
}

}  // namespace

Shared SpecimenStore::of(const Settings& settings) {
  std::promise<Shared> promise;
  std::string key = key_of(settings);
  std::unique_lock lock(mutex_);
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
  if (found != entries_.end()) {
    Entry entry = std::move(*found);
    entries_.erase(found);
    entries_.push_back(entry);
    lock.unlock();
    return entry.made.get();
  }
  Made made = promise.get_future().share();
  entries_.push_back({std::move(key), made});
  if (entries_.size() > capacity_) entries_.pop_front();
  lock.unlock();
  try {
    promise.set_value(make(settings));
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return made.get();
}

}  // namespace app
