#include "apps/run/run_task.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/job/job.hpp"
#include "apps/live/live_view.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/checkpoint_folder.hpp"
#include "apps/run/frame_folder.hpp"
#include "apps/run/run_folder.hpp"
#include "apps/run/run_length.hpp"
#include "apps/run/run_location.hpp"
#include "apps/run/solving.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/system/files.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/replace_file.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"
#include "specimen/body/files.hpp"
#include "specimen/file/specimen_file.hpp"

namespace app {
namespace {

/// The checkpoints of a run on its way. A disk that is full ends no run: the next one may find room.
class Keeper {
 public:
  Keeper(const RunTask& task, Console& console)
      : task_(task),
        console_(console),
        every_(task.remarks.checkpoint_every),
        folder_(task.folder),
        has_scene_(task.from) {
    folder_.remove_behind(task.from ? task.from->step : -1);
    if (!task.from) retire_results(task.folder, task.scene_toml, task.job.specimen);
    if (every_ > 0 && !has_scene_) write_scene();
    writer_.emplace(folder_, task.scene_toml, remarks_text(task.remarks));
  }

  /// When the next one is to be made: so that it is on the disk before an interval has passed since the state
  /// of the one before, and a kill loses no more. What writing takes counts, and the row until it is asked
  /// for again.
  /// @param since  wall time since the state of the last one [s].
  [[nodiscard]] bool is_due(double since) {
    const double row = std::max(0.0, since - asked_);
    asked_ = since;
    if (writer_->is_busy()) {
      warn_of_delay(kept_before_ + since, "the disk has not taken the last one yet");
      return false;
    }
    if (!writer_->trouble().empty()) warn("a checkpoint is missing: " + writer_->trouble());
    warn_of_delay(kept_before_ + writer_->last_time(),
                  fmt::format("the disk took {:.2g} s for one", writer_->last_time()));
    warn_of_delay(since, fmt::format("they are made at rows of the history, {:.2g} s apart", row));
    return since + std::min(writer_->last_time() + row, 0.5 * every_) >= every_;
  }

  void keep(mpm::Checkpoint checkpoint) {
    writer_->wait();
    kept_before_ = (writer_->trouble().empty() ? 0 : kept_before_) + std::exchange(asked_, 0);
    trouble_.clear();
    try {
      if (!has_scene_) write_scene();
      writer_->write(std::move(checkpoint));
    } catch (const mpm::FileError& error) {
      trouble_ = error.what();
    } catch (const specimen::Error& error) {
      trouble_ = error.what();
    }
  }

  /// Once no more come; waits for the last.
  void close() {
    writer_->wait();
    if (trouble_.empty()) trouble_ = writer_->trouble();
    writer_.reset();
  }

  void report(double wall_time) const {
    if (!trouble_.empty()) console_.say("warning: the last checkpoint is missing: " + trouble_);
    if (folder_.written() > 0 && every_ > 0)
      console_.say(fmt::format("{} written in {:.3f} s beside the run of {:.3f} s",
                               counted(folder_.written(), "checkpoint"), folder_.wall_time(), wall_time));
  }
  [[nodiscard]] bool has_kept() const { return folder_.written() > 0 || task_.from; }
  void remove() const { folder_.remove(); }

 private:
  void warn(const std::string& text) {
    if (std::exchange(warned_, true)) return;
    console_.say((console_.err_is_terminal ? "\n" : "") + ("warning: " + text));
  }

  /// @param exposed  what a kill may lose, or could have lost until the last one was on the disk [s].
  void warn_of_delay(double exposed, const std::string& why) {
    if (exposed < 1.5 * every_) return;
    warn(
        fmt::format("checkpoints come late, a kill may lose {:.2g} s instead of {:g} s: {}; choose a longer "
                    "--checkpoint-every",
                    exposed, every_, why));
  }

  /// With these the folder is enough to go on from.
  void write_scene() {
    mpm::replace_file((task_.folder / "scene.toml").string(), task_.scene_toml);
    specimen::write_specimen((task_.folder / "specimen.h5").string(), task_.job.specimen);
    has_scene_ = true;
  }

  const RunTask& task_;
  Console& console_;
  double every_;  ///< wall time between two [s]; 0 = only when the run is ended
  CheckpointFolder folder_;
  bool has_scene_;
  bool warned_ = false;
  double asked_ = 0;        ///< at the last row, since the state of the last one [s]
  double kept_before_ = 0;  ///< from the state of the one before the last to that of the last [s]
  std::string trouble_;     ///< why there is no last one
  std::optional<CheckpointWriter> writer_;
};

std::string percent_text(double error) { return output::rounded(100 * error, 2) + " %"; }

std::string estimate_text(const output::ErrorEstimate& estimate) {
  std::string parts;
  for (const output::ErrorSource& source : estimate.sources)
    parts += (parts.empty() ? "" : ", ") + source.name + (source.peak_reached ? " " : " at least ") +
             percent_text(source.stress_error);
  return fmt::format(
      "the peak stress may be wrong by {0}{1} and its strain by {0}{2} ({3}), estimated in {4:.2f} s more",
      estimate.is_least() ? "at least " : "", percent_text(estimate.stress_error()),
      percent_text(estimate.strain_error()), parts, estimate.wall_time());
}

std::string result_text(const mpm::Result& result, const mpm::Scene& scene) {
  if (scene.fixture.has_loads())
    return fmt::format(
        "{} force {:.4g} N at a displacement of {:.4g} mm, {} tension and {} shear failures, {} steps in "
        "{:.2f} s",
        mpm::peak_reached(result) ? "peak" : "no peak, largest",
        output::leading_force(scene, result.peak_stress),
        1e3 * output::leading_displacement(scene, result.peak_strain), result.tension_failures,
        result.shear_failures, result.steps, result.wall_time);
  const bool platens = output::has_platens(scene);
  return fmt::format(
      "{} {}{:.4g} MPa at {} {}, {} tension and {} shear failures, {} steps in {:.2f} s",
      mpm::peak_reached(result) ? "peak" : "no peak, largest",
      platens ? (mpm::peak_reached(result) ? "" : "stress ") : output::name_of_stress(scene) + " ",
      1e-6 * result.peak_stress, platens ? "strain" : output::name_of_strain(scene),
      strain_text(result.peak_strain), result.tension_failures, result.shear_failures, result.steps,
      result.wall_time);
}

/// Notes that have come since there were `told` of them.
void say_notes(const Job& job, std::size_t told, Console& console) {
  for (std::size_t i = told; i < job.notes.size(); ++i) console.say("note: " + job.notes[i]);
}

void note_outcome(const Outcome& outcome, Job& job, Console& console) {
  for (const Remark& remark : remarks_on(outcome, job.scene)) {
    job.notes.push_back(remark.text);
    if (remark.kind == std::string_view("warning"))
      console.warn(remark.text);
    else if (*remark.kind != '\0')
      console.say(std::string(remark.kind) + ": " + remark.text);
  }
}

/// A disk that is full ends no run: it may have space again for the next frame, and for what comes of it all.
mpm::FrameSink frame_sink(FrameFolder& frames, Console& console) {
  return [&frames, &console, warned = false](const mpm::Frame& frame) mutable {
    if (frames.add(frame) || warned) return;
    warned = true;
    console.say(std::string(console.err_is_terminal ? "\n" : "") + "warning: " + frames.failure()->what() +
                "; the run goes on");
  };
}

/// What the disk did not take of the files that write_run() writes.
using Lost = std::vector<mpm::FileError>;

Lost write_what_fits(const std::filesystem::path& folder, const RunRecord& record) {
  try {
    write_run(folder, record);
  } catch (const NotWritten& missing) {
    return missing.files;
  }
  return {};
}

/// How a run ended, for those who watched it.
std::string last_words(const Outcome& outcome, const std::filesystem::path& folder, const Lost& lost) {
  const std::string how =
      outcome.divergence.empty() ? output::phrase_of(outcome.result.stop) : outcome.divergence;
  return "The run has ended: " + how + ". " +
         (lost.empty() ? "Its report is " + (folder / "report.html").string() : lost.front().what());
}

std::string way_on(const RunTask& task) {
  return "to go on: mesopix simulate --resume " + shell_word(task.folder.string());
}

/// @throws Rejected when the disk did not take all.
void check_disk(std::vector<Complaint> complaints, const Lost& lost, const FrameFolder& frames) {
  Lost all = lost;
  if (const auto failure = frames.failure()) all.insert(all.begin(), *failure);
  if (all.empty()) return;
  for (const mpm::FileError& file : all)
    complaints.push_back(complaint(file.field, file.value, file.allowed, file.cure));
  throw Rejected(Exit::io, std::move(complaints));
}

/// @throws Rejected when the physics went wrong, or the disk.
Exit exit_of(const Outcome& outcome, const RunTask& task, const Keeper& keeper, const Lost& lost,
             const FrameFolder& frames, Console& console) {
  std::vector<Complaint> diverged;
  if (!outcome.divergence.empty())
    diverged.push_back(
        complaint("simulate", outcome.divergence, "what was computed is in " + task.folder.string()));
  if (!lost.empty() && keeper.has_kept()) console.say("once there is space, " + way_on(task));
  check_disk(diverged, lost, frames);
  if (!diverged.empty()) throw Rejected(Exit::data, std::move(diverged));
  if (!outcome.interrupted()) return Exit::ok;
  console.say("interrupted; what was computed is kept");
  if (keeper.has_kept()) console.say(way_on(task));
  return Exit::interrupted;
}

}  // namespace

Exit carry_out(RunTask task, const InterruptGuard& guard, Console& console) {
  const HeldFolder held(task.folder);
  for (const char* part : {"", "frames", "checkpoints"}) remove_remainders(task.folder / part);
  Job& job = task.job;
  RunSubject subject{job.specimen,       job.scene,
                     task.scene_toml,    specimen::sha256_of_text(task.scene_toml),
                     job.settings.title, job.notes};
  std::optional<LiveView> view;
  if (task.port) {
    view.emplace(subject, *task.port);
    console.err << "watch the run at " << view->address() << std::endl;
  }
  Keeper keeper(task, console);
  FrameFolder frames(task.folder, job.scene, task.from ? task.from->frames : std::vector<mpm::FrameTaken>(),
                     run_digest(task.scene_toml, job.scene));
  mpm::RunHooks hooks;
  if (view) hooks.observer = [&](const mpm::Progress& progress) { return view->look(progress); };
  hooks.frames = frame_sink(frames, console);
  hooks.checkpoints = {[&](mpm::Checkpoint checkpoint) { keeper.keep(std::move(checkpoint)); },
                       task.remarks.checkpoint_every, [&](double since) { return keeper.is_due(since); }};
  if (!task.from && !console.quiet)
    if (const std::string length = announcement(job.scene); !length.empty()) console.say(length);
  const Outcome outcome =
      solve(job.scene, console, guard, std::move(hooks), task.from ? &*task.from : nullptr);
  keeper.close();
  keeper.report(outcome.result.wall_time);
  const std::size_t told = job.notes.size();
  const output::ErrorEstimate estimate = task.remarks.estimate_error
                                             ? estimate_of(outcome, job, second_run(console, guard))
                                             : of_a_peak(task.remarks.tolerated, outcome, job);
  say_notes(job, told, console);
  note_outcome(outcome, job, console);
  subject.notes = job.notes;
  const RunRecord record{subject, outcome.result, estimate};
  const Lost lost = write_what_fits(task.folder, record);
  if (view) view->finish(outcome.result, last_words(outcome, task.folder, lost));
  if (!outcome.interrupted() && lost.empty()) keeper.remove();
  if (task.json)
    console.out << json_text(summary(record));
  else
    console.say(result_text(outcome.result, job.scene));
  if (!estimate.sources.empty()) console.say(estimate_text(estimate));
  if (frames.count() > 0)
    console.say(fmt::format("{} frames for ParaView: {}", frames.count(), frames.series().string()));
  if (lost.empty()) console.say("wrote " + task.folder.string());
  return exit_of(outcome, task, keeper, lost, frames, console);
}

namespace {

namespace fs = std::filesystem;

/// A folder without a checkpoint that can be read.
void say_how_it_ended(const fs::path& folder, const std::vector<std::string>& faults, Console& console) {
  if (!faults.empty())
    throw Rejected(Exit::data, "--resume", folder.string() + " has no checkpoint that can be read", "",
                   "begin the run anew");
  const fs::path result = folder / "result.h5";
  if (fs::exists(result)) check_one_run(folder.string());
  if (!fs::exists(result) || read_result(result.string()).stop == mpm::StopReason::interrupted)
    throw Rejected(Exit::data, "--resume", folder.string() + " has no checkpoint", "",
                   "begin the run anew, with --checkpoint-every to have some");
  console.say("the run in " + folder.string() + " has come to its end, there is nothing to go on with");
}

/// Long ones, such as lists of ellipses, by their beginning.
std::string shown(const std::string& value) {
  constexpr std::size_t most = 60;
  if (value.empty()) return "nothing";
  return value.size() > most ? value.substr(0, most) + "..." : value;
}

/// The number of threads may be another one: it changes no bit.
void refuse_differences(const std::string& of_the_run, const std::string& now) {
  std::vector<Complaint> complaints;
  for (const SceneDifference& one : scene_differences({of_the_run, now}))
    if (one.key != "solver.threads")
      complaints.push_back(complaint(one.key, shown(one.values[1]),
                                     "the run began with " + shown(one.values[0]),
                                     "take that back, or begin another run"));
  if (!complaints.empty()) throw Rejected(Exit::data, complaints);
}

/// The settings of the run's folder with those given beside it.
Resolved settings_of(const fs::path& folder, const std::string& of_the_run,
                     const std::vector<Assignment>& given) {
  const std::string path = (folder / "scene.toml").string();
  return resolve(parse_scene(fs::exists(path) ? read_text_file(path) : of_the_run, path), given);
}

Job job_of(const fs::path& folder, Settings settings, const mpm::Checkpoint& checkpoint) {
  const std::string path = (folder / "specimen.h5").string();
  Job job = make_job(std::move(settings), {read_specimen(path), {}, {}});
  if (mpm::specimen_digest(job.scene) != checkpoint.specimen)
    throw Rejected(Exit::data, path, "is not the specimen that the run began with", "",
                   "bring it back as it was");
  return job;
}

}  // namespace

std::optional<RunTask> task_that_goes_on(const fs::path& folder, const std::vector<Assignment>& given,
                                         Console& console) {
  if (!fs::is_directory(folder))
    throw Rejected(Exit::usage, "--resume", folder.string(), "must be the folder of a run");
  CheckpointFolder::Found found = CheckpointFolder(folder).last();
  for (const std::string& fault : found.faults) console.say("warning: " + fault);
  if (!found.last) {
    say_how_it_ended(folder, found.faults, console);
    return std::nullopt;
  }
  mpm::CheckpointFile& file = found.last->file;
  Resolved resolved = settings_of(folder, file.scene_text, given);
  console.locate = located_by(resolved.origins);
  refuse_differences(file.scene_text, scene_text(resolved.settings, Extent::whole, folder));
  RunTask task;
  task.job = job_of(folder, std::move(resolved.settings), file.checkpoint);
  task.folder = folder;
  task.remarks = parse_remarks(file.remarks, found.last->path.string());
  task.job.notes = task.remarks.notes;
  task.scene_toml = std::move(file.scene_text);
  console.say(fmt::format("goes on at {:.0f} %, step {}, from {}", 100 * file.checkpoint.fraction,
                          file.checkpoint.step, found.last->path.string()));
  task.from = std::move(file.checkpoint);
  return task;
}

}  // namespace app
