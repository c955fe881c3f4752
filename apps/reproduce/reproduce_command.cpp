#include "apps/reproduce/campaign.hpp"

#include <fmt/format.h>

#include <chrono>
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

/// One line on the terminal that tells how far the runs are.
class CampaignLine {
 public:
  explicit CampaignLine(Console& console)
      : console_(console), enabled_(console.err_is_terminal && !console.quiet) {}
  ~CampaignLine() {
    if (enabled_) console_.err << wipe << std::flush;
  }
  CampaignLine(const CampaignLine&) = delete;
  CampaignLine& operator=(const CampaignLine&) = delete;

  void show(std::size_t done, std::size_t all) const {
    if (!enabled_) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const double left = elapsed.count() * static_cast<double>(all - done) / static_cast<double>(done);
    console_.err << fmt::format("{}{} of {} runs   {:.0f} s left", wipe, done, all, left) << std::flush;
  }

 private:
  static constexpr const char* wipe = "\r\x1b[K";
  Console& console_;
  bool enabled_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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

}  // namespace

ReproduceCommand::ReproduceCommand(CLI::App& program)
    : Command(program, "reproduce", "Repeat the figures of the paper, and judge its claims",
              reproduce_footer) {
  options().value("--figure", figures_, "figure of the paper, e.g. 12; may be given again [all]",
                  WholeNumberCodec().form());
  options().add_flag("--all", all_, "all figures");
  options().value("-o,--output", output_, "folder [runs/reproduce, runs/reproduce-2, ...]", folder_form());
  options()
      .value("-j,--jobs", jobs_, "runs at a time [one a core]", WholeNumberCodec().form())
      ->check(CLI::Range(1, 1024));
  options().add_flag("--overwrite", overwrite_, "write into a folder that is not empty");
  options().add_flag("--json", json_, "reproduction.json on standard output too");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

Exit ReproduceCommand::run(Console& console) {
  console.quiet = quiet_;
  if (all_ && !figures_.empty())
    throw Rejected(Exit::usage, complaint("--all", "given with --figure", "", "give one of the two"));
  const auto figures = reproduce::select_figures(figures_);
  const fs::path folder = make_run_folder(output_, "reproduce", overwrite_);
  const int workers = jobs_ > 0 ? jobs_ : core_count();
  const InterruptGuard guard;
  const auto reproduction = [&] {
    const CampaignLine line(console);
    return reproduce::reproduce_figures(figures, reproduce::Study(), workers,
                                        {[&](std::size_t done, std::size_t all) { line.show(done, all); },
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

}  // namespace app
