/// HDF5 serves one thread at a time.
#pragma once

#include <functional>
#include <memory>

namespace app {

/// To be held while a file of HDF5 is read or written by one of several threads; none is held by an empty
/// one.
using Hdf5Turn = std::shared_ptr<const void>;

/// Wait until no other thread has the turn, and take it.
[[nodiscard]] Hdf5Turn hdf5_turn();

/// Where others in the process use HDF5 as well, and take turns in their own way: `take` is called in place
/// of the lock that the program has. Once, before there are threads.
void take_hdf5_turns_by(std::function<Hdf5Turn()> take);

}  // namespace app
