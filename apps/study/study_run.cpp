#include "apps/study/study_run.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "apps/job/job.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"
#include "specimen/describe/doubts.hpp"

namespace app {
namespace {

using Shared = std::shared_ptr<const specimen::Specimen>;

std::string key_of(const Settings& settings) {
  return std::to_string(settings.scene.points_per_cell) + scene_values(settings, Extent::specimen);
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

namespace {

constexpr double interval = 60;  // [s]

}  // namespace

mpm::Result MemberCheckpoints::run(const mpm::Scene& scene, const mpm::Observer& observer) {
  mpm::RunHooks hooks;
  hooks.observer = observer;
  hooks.checkpoints = {[this](const mpm::Checkpoint& checkpoint) { keep(checkpoint); }, interval};
  const CheckpointFolder::Found found = folder_.last();
  if (found.last && found.last->file.scene_text == identity_) try {
      return mpm::resume(scene, found.last->file.checkpoint, hooks);
    } catch (const mpm::FileError&) {  // no checkpoint for this machine; those of the hooks throw nothing
    }
  remove();  // of another run, behind which those of this one would count as old
  return mpm::simulate(scene, hooks);
}

void MemberCheckpoints::keep(const mpm::Checkpoint& checkpoint) {
  try {
    folder_.write(checkpoint, identity_, "");
  } catch (const mpm::FileError&) {  // the one before stays
  }
}

void MemberCheckpoints::remove() const {
  std::error_code ignored;
  try {
    folder_.remove();
  } catch (const mpm::FileError&) {
    return;
  }
  std::filesystem::remove(path_, ignored);  // once it is empty
}

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
    const Settings& settings = *member.settings;
    const mpm::Scene scene = build_scene(*specimens_.of(settings), settings);
    MemberCheckpoints checkpoints(folder_.run_folder(member), identity_text(settings));
    const mpm::Result result =
        checkpoints.run(scene, [this](const mpm::Progress&) { return watch_.goes_on(); });
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
    watch_.tell(tally_);
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
  const std::optional<Prepared>& of(const Settings& settings) {
    const SpecimenChoice& choice = settings.specimen;
    const auto [found, is_new] =
        specimens_.try_emplace(Files{choice.file, choice.picture, choice.ellipses}, std::nullopt);
    if (!is_new) return found->second;
    try {
      found->second = prepare_specimen(settings);
    } catch (const specimen::Error&) {
    }
    return found->second;
  }

  /// Of all of them, each once.
  [[nodiscard]] std::vector<std::string> doubts() const {
    std::vector<std::string> doubts;
    for (const auto& [files, prepared] : specimens_)
      if (prepared)
        for (std::string& doubt : specimen::doubts_of(prepared->specimen))
          if (std::find(doubts.begin(), doubts.end(), doubt) == doubts.end())
            doubts.push_back(std::move(doubt));
    return doubts;
  }

 private:
  std::map<Files, std::optional<Prepared>> specimens_;
};

}  // namespace

namespace {

/// 0 where the plan is refused, which is left to the run of the member.
RunSize size_if_known(const mpm::Scene& scene) {
  try {
    return app::size_of(scene);
  } catch (const mpm::Error&) {
    return {};
  }
}

}  // namespace

CheckedScenes check_scenes(const Study& study, const std::vector<Member>& members) {
  SampleSpecimens specimens;
  CheckedScenes checked;
  for (const Member& member : members) {
    try {
      const Settings& settings = *member.settings;
      const auto& specimen = specimens.of(settings);
      checked.sizes.push_back(
          specimen ? size_if_known(make_job(settings, fit_to_cells(*specimen, settings)).scene) : RunSize());
    } catch (const Rejected& rejected) {
      refuse_member(study, member, rejected.complaints);
    } catch (const mpm::Error& error) {
      refuse_member(study, member, {complaint(error.field, error.value, error.allowed, error.cure)});
    }
  }
  checked.doubts = specimens.doubts();
  return checked;
}

std::vector<std::string> doubts_of(const std::vector<Member>& members) {
  SampleSpecimens specimens;
  for (const Member& member : members)
    if (const Source source = source_of(*member.settings);
        source == Source::file || source == Source::picture)
      (void)specimens.of(*member.settings);
  return specimens.doubts();
}

std::string announcement(const StudyFolder& folder, const std::vector<Member>& members,
                         const std::vector<RunSize>& sizes, int workers) {
  std::vector<RunSize> open;
  std::vector<const Member*> runs;
  bool may_end_before = false;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (folder.has_result(members[i]) || folder.has_failed(members[i])) continue;
    open.push_back(sizes[i]);
    runs.push_back(&members[i]);
    may_end_before = may_end_before || members[i].settings->scene.loading.stop_drop;
  }
  const auto scene_of = [&](std::size_t i) {
    const Settings& settings = *runs[i]->settings;
    return make_job(settings, prepare_cells(settings)).scene;
  };
  const double seconds = time_of_runs(open, scene_of, workers);
  if (!is_long(seconds)) return {};
  return fmt::format("{} of up to {}, which take {} {} here, {} at a time",
                     counted(static_cast<int>(open.size()), "member"), size_text(open),
                     precision_word(open, may_end_before), duration_text(seconds), workers);
}

StudyTally run_members(const Study& study, const StudyFolder& folder, const std::vector<Member>& members,
                       int workers, const StudyWatch& watch) {
  return Runner(study, folder, workers, watch).run(members, workers);
}

}  // namespace app
