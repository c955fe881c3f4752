#include "apps/reproduce/campaign.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "apps/reproduce/figure.hpp"
#include "apps/run/run_location.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/system/processes.hpp"
#include "apps/text/markup.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* reproduce_footer =
    "All of them take a few minutes. The scenes are those of data/paper, which mesopix simulate runs too.\n"
    "Example: the figures on the random specimen's curves and on the Weibull modulus\n"
    "  mesopix reproduce --figure 5 --figure 12 -o runs/paper";

/// How far the runs are.
std::string progress_text(std::size_t done, std::size_t all, double elapsed) {
  const double left = elapsed * static_cast<double>(all - done) / static_cast<double>(done);
  return fmt::format("{} of {} runs   {:.0f} s left", done, all, left);
}

void write(const fs::path& folder, const reproduce::Reproduction& reproduction) {
  mpm::replace_file((folder / "report.html").string(), reproduce::report_html(reproduction));
  mpm::replace_file(
      (folder / "reproduction.json").string(),
      reproduce::report_json(reproduction).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
          "\n");
}

/// Each claim in a line, then how many agree.
void say_verdicts(const reproduce::Reproduction& reproduction, Console& console) {
  const std::vector<reproduce::Claim> claims = reproduce::claims_of(reproduction);
  for (const reproduce::Claim& claim : claims)
    console.say(fmt::format("figure {:>2}, {:9}: {}", claim.figure, word_of(claim.verdict), claim.paper));
  if (!claims.empty())
    console.say(reproduce::counted(static_cast<int>(claims.size()), "claim") + ": " + verdict_counts(claims));
}

class ReproduceCommand : public Command {
 public:
  explicit ReproduceCommand(CLI::App& program)
      : Command(program, "reproduce", "Repeat the figures of the paper, and judge its claims",
                reproduce_footer) {
    option("--figure", figures_, "figure of the paper, e.g. 12; may be given again [all]",
           WholeNumberCodec().form());
    flag("--all", all_, "all figures");
    folder_and_overwrite("runs/reproduce, runs/reproduce-2, ...");
    option("-j,--jobs", jobs_, "runs at a time [one a core]", WholeNumberCodec().form())
        ->check(CLI::Range(1, 1024));
    json_and_quiet("reproduction.json on standard output too");
  }

  Exit run(Console& console) override {
    if (all_ && !figures_.empty())
      throw Rejected(Exit::usage, "--all", "given with --figure", "", "give one of the two");
    const auto figures = reproduce::select_figures(figures_);
    const fs::path folder = make_run_folder(output_, "reproduce", overwrite_);
    const Workers workers = workers_within_cores(jobs_ > 0 ? jobs_ : core_count(), "--jobs");
    if (!workers.note.empty()) console.say("note: " + workers.note);
    if (!console.quiet)
      if (const std::string length = announcement(figures, reproduce::Effort(), workers.count);
          !length.empty())
        console.say(length);
    const InterruptGuard guard;
    const auto reproduction = [&] {
      TerminalLine line(console);
      return reproduce::reproduce_figures(
          figures, reproduce::Effort(), workers.count,
          {[&](std::size_t done, std::size_t all) { line.show(progress_text(done, all, line.elapsed())); },
           [&] { return !guard.interrupted(); }});
    }();
    write(folder, reproduction);
    if (json_) console.out << json_text(reproduce::report_json(reproduction));
    say_verdicts(reproduction, console);
    console.say("wrote " + folder.string());
    if (!reproduction.interrupted) return Exit::ok;
    console.say("interrupted; what was computed is kept");
    return Exit::interrupted;
  }

 private:
  std::vector<std::string> figures_;
  int jobs_ = 0;  ///< 0 = as many as there are cores
  bool all_ = false;
};

}  // namespace

CommandPointer reproduce_command(CLI::App& parent) { return std::make_unique<ReproduceCommand>(parent); }

}  // namespace app
