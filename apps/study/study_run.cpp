#include "apps/study/study_run.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <mutex>
#include <new>
#include <optional>

#include "apps/system/hdf5_turn.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/study/member_checkpoints.hpp"
#include "apps/job/scene_builder.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/study/study_specimens.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/files/result_file.hpp"
#include "specimen/body/error.hpp"

namespace app {
namespace {

std::string reason_of(const Rejected& rejected) { return text(rejected.complaints.front()); }

/// What members run with, and what comes of it.
class Runner {
 public:
  Runner(const Study& study, const StudyFolder& folder, int workers, const StudyWatch& watch)
      : study_(study), folder_(folder), watch_(watch), specimens_(static_cast<std::size_t>(workers) + 1) {}

  StudyTally run(const std::vector<Member>& members, int workers) {
    std::vector<std::function<void()>> jobs;
    for (const Member& member : members)
      if (!folder_.has_result(member) && !folder_.has_failed(member))
        jobs.emplace_back([this, &member] { run(member); });
    tally_.all = members.size();
    tally_.before = members.size() - jobs.size();
    run_jobs(jobs, workers, {{}, watch_.go_on});
    return tally_;
  }

 private:
  bool goes_on() const { return !watch_.go_on || watch_.go_on(); }

  /// Only a failing disk, and a mistake of ours, ends the study.
  void run(const Member& member) {
    std::string reason;
    try {
      if (solve(member)) count(true);
      return;
    } catch (const mpm::FileError&) {
      throw;
    } catch (const mpm::Error& error) {
      reason = error.what();
    } catch (const mpm::Diverged& diverged) {
      reason = diverged.what();
    } catch (const specimen::Error& error) {
      if (error.fault == specimen::Fault::write) throw;
      reason = error.what();
    } catch (const Rejected& rejected) {
      if (rejected.code == Exit::io) throw;
      reason = reason_of(rejected);
    } catch (const std::bad_alloc&) {
      reason = "memory: not enough; use fewer, larger pixels, or --jobs 1";
    }
    folder_.write_failure(study_, member, reason);
    count(false);
  }

  /// @return whether the run came to its end.
  bool solve(const Member& member) {
    const Settings settings = member_settings(study_, member);
    const mpm::Scene scene = build_scene(*specimens_.of(settings), settings);
    MemberCheckpoints checkpoints(folder_.run_folder(member), member_scene(settings));
    const mpm::Result result = checkpoints.run(scene, [this](const mpm::Progress&) { return goes_on(); });
    if (result.stop == mpm::StopReason::interrupted) return false;
    {
      const Hdf5Turn turn = hdf5_turn();
      mpm::write_result(folder_.result_file(member).string(), result, member_scene(settings));
    }
    checkpoints.remove();
    return true;
  }

  void count(bool done) {
    const std::scoped_lock lock(mutex_);
    ++(done ? tally_.done : tally_.failed);
    if (watch_.looked) watch_.looked(tally_);
  }

  const Study& study_;
  const StudyFolder& folder_;
  const StudyWatch& watch_;
  SpecimenStore specimens_;
  std::mutex mutex_;
  StudyTally tally_;
};

using Files = std::array<std::string, 3>;

/// Specimens to check scenes with: one a file, or one of all that are random. None where it cannot be made:
/// that is left to the run.
class SampleSpecimens {
 public:
  const std::optional<specimen::Specimen>& of(const Settings& settings) {
    const SpecimenChoice& choice = settings.specimen;
    const auto [found, is_new] =
        specimens_.try_emplace(Files{choice.file, choice.picture, choice.ellipses}, std::nullopt);
    if (!is_new) return found->second;
    try {
      found->second = prepare_specimen(settings).specimen;
    } catch (const specimen::Error&) {
    }
    return found->second;
  }

 private:
  std::map<Files, std::optional<specimen::Specimen>> specimens_;
};

void check_scene(const Settings& settings, specimen::Specimen specimen) {
  (void)crop_to_cells(specimen, settings.scene.points_per_cell);
  mpm::validate(build_scene(specimen, settings));
}

}  // namespace

void check_scenes(const Study& study, const std::vector<Member>& members) {
  SampleSpecimens specimens;
  for (const Member& member : members) {
    try {
      const Settings settings = member_settings(study, member);
      if (const auto& specimen = specimens.of(settings)) check_scene(settings, *specimen);
    } catch (const Rejected& rejected) {
      refuse_member(study, member, rejected.complaints);
    } catch (const mpm::Error& error) {
      refuse_member(study, member, {complaint(error.field, error.value, error.allowed, error.cure)});
    }
  }
}

StudyTally run_members(const Study& study, const StudyFolder& folder, const std::vector<Member>& members,
                       int workers, const StudyWatch& watch) {
  return Runner(study, folder, workers, watch).run(members, workers);
}

}  // namespace app
