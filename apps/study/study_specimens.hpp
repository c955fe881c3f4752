/// Specimens that the members of a study share.
#pragma once

#include <cstddef>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include "apps/settings/settings.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// Makes each specimen once for all members that follow each other with the same settings of it. May be
/// asked by several threads at once.
class SpecimenStore {
 public:
  /// @param capacity  specimens kept at a time, >= 1: those that were asked for last.
  explicit SpecimenStore(std::size_t capacity) : capacity_(capacity) {}

  /// The specimen of settled settings, cropped to whole cells.   @throws what prepare_cells() throws.
  [[nodiscard]] std::shared_ptr<const specimen::Specimen> of(const Settings& settings);

 private:
  using Made = std::shared_future<std::shared_ptr<const specimen::Specimen>>;
  struct Entry {
    std::string key;
    Made made;
  };

  std::size_t capacity_;
  std::mutex mutex_;
  std::deque<Entry> entries_;  ///< asked for last: at the back
};

}  // namespace app
