#include "apps/system/hdf5_turn.hpp"

#include <mutex>
#include <utility>

namespace app {
namespace {

Hdf5Turn locked() {
  static std::mutex mutex;
  return std::make_shared<const std::scoped_lock<std::mutex>>(mutex);
}

std::function<Hdf5Turn()>& way() {
  static std::function<Hdf5Turn()> take = locked;
  return take;
}

}  // namespace

Hdf5Turn hdf5_turn() { return way()(); }

void take_hdf5_turns_by(std::function<Hdf5Turn()> take) { way() = std::move(take); }

}  // namespace app
