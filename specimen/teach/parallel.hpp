/// Work that is shared among threads; what comes of it does not depend on their number.
#pragma once

#include <functional>

namespace specimen {

/// Calls `work` once for each number from 0 to count - 1, in any order and on several threads at a time.
/// What a call writes, no other may read or write. The first exception of a call is thrown once all have
/// stopped.   @param threads  at most so many; 0 = as many as the machine has cores; fewer where
/// the system gives no more.
void share_out(int count, int threads, const std::function<void(int)>& work);

}  // namespace specimen
