/// Specimens that the members of a study share.
/// Members of a study that end early go on where they were.
/// Members of a study, run side by side.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "apps/run/checkpoint_folder.hpp"
#include "apps/run/run_length.hpp"
#include "apps/settings/settings.hpp"
#include "apps/study/study_folder.hpp"
#include "apps/system/job_pool.hpp"
#include "libmpm/run/simulate.hpp"
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

/// The checkpoints of one member: once a minute, and when the observer ends its run. They are a convenience:
/// one that cannot be written is left out, and one that cannot be gone on from (damaged, of another scene, of
/// an instruction set that the processor lacks) is passed over.
class MemberCheckpoints {
 public:
  /// @param folder  of the member alone.   @param identity  identity_text() of its settings.
  MemberCheckpoints(std::filesystem::path folder, std::string identity)
      : path_(std::move(folder)), folder_(path_), identity_(std::move(identity)) {}

  /// From the last checkpoint, or from the start where there is none.   @throws what mpm::simulate() throws.
  [[nodiscard]] mpm::Result run(const mpm::Scene& scene, const mpm::Observer& observer);

  /// All of them, once the result is kept. What cannot be removed stays.
  void remove() const;

 private:
  void keep(const mpm::Checkpoint& checkpoint);

  std::filesystem::path path_;
  CheckpointFolder folder_;
  std::string identity_;
};

/// How far the runs are.
struct StudyTally {
  std::size_t all = 0;     ///< members that were asked for
  std::size_t before = 0;  ///< that were done, or had failed, before
  std::size_t done = 0;    ///< that have a result now
  std::size_t failed = 0;  ///< that have failed now

  [[nodiscard]] std::size_t open() const { return all - before - done - failed; }
};

using StudyWatch = WatchOf<const StudyTally&>;

/// What is known of the members of a study before they run.
struct CheckedScenes {
  std::vector<RunSize> sizes;       ///< what the run of each computes, 0 where that is not known
  std::vector<std::string> doubts;  ///< of specimens from files and pictures, see specimen::doubts_of()
};

/// Whether every member's settings go with a specimen: phases, edges, solver. Specimens from files are all
/// looked at, of random ones the first; one that cannot be made is left to its run.
/// @throws Rejected (Exit::data) naming the first member that is not valid, and its values.
CheckedScenes check_scenes(const Study& study, const std::vector<Member>& members);

/// What speaks against the specimens of members, which come from files and pictures, each told once; see
/// specimen::doubts_of(). Nothing of those that cannot be made any more.
[[nodiscard]] std::vector<std::string> doubts_of(const std::vector<Member>& members);

/// What the members that have no result yet take, where that is long: "20 members of up to ... points and ...
/// steps, which take about 12 min here, 2 at a time". Measured on one of them within a second; empty for a
/// short study.   @param sizes  of check_scenes().   @param workers  as of run_members().
[[nodiscard]] std::string announcement(const StudyFolder& folder, const std::vector<Member>& members,
                                       const std::vector<RunSize>& sizes, int workers);

/// Run the members that have neither a result nor a failure, each on one thread; write the result of each
/// into the folder, or why it has failed. One that is interrupted goes on from its checkpoint the next time.
/// What a member gives depends on nothing but itself. No more than `workers` + 1 specimens and `workers`
/// results are held at a time.
/// @param workers  threads, >= 1.   @throws mpm::FileError, specimen::Error (Fault::write) when the disk
/// fails; no member is begun after that.
[[nodiscard]] StudyTally run_members(const Study& study, const StudyFolder& folder,
                                     const std::vector<Member>& members, int workers,
                                     const StudyWatch& watch);

}  // namespace app
