#include "apps/run/run_remarks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/report/key_figures.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/figures.hpp"

namespace output {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ErrorSource, name, compared, peak_stress, peak_strain,
                                                stress_error, strain_error, wall_time, peak_reached)

}  // namespace output

namespace app {

using nlohmann::json;

namespace {

constexpr double tolerated_energy_error = 0.01;  ///< over the energy put in [-]

/// What keeps more of the energy than the scene does.
std::string less_dissipation(const mpm::Scene& scene) {
  const mpm::Motion& motion = scene.motion;
  if (motion.transfer == mpm::Transfer::apic || motion.flip_ratio < 1)
    return "motion.transfer = \"flip\" with motion.flip_ratio = 1 loses less";
  if (motion.scheme == mpm::Scheme::usl) return "motion.scheme = \"musl\" or \"usf\" loses less";
  return "a smaller solver.cfl loses less";
}

}  // namespace

std::string energy_note(const mpm::Result& result, const mpm::Scene& scene) {
  if (!(result.energy_error > tolerated_energy_error)) return {};
  const std::string put_in = output::has_platens(scene) ? "the platen work" : "the energy of the flight";
  if (scene.damage.crack_closure == mpm::CrackClosure::clipped)
    return fmt::format(
        "the ledger of energies is off by {:.2g} % of {}; damage.crack_closure = \"clipped\" "
        "does not keep energy, \"unilateral\" does",
        100 * result.energy_error, put_in);
  if (scene.kinematics == mpm::Kinematics::small_strain)
    return fmt::format("the ledger of energies is off by {:.2g} % of {}; try a smaller solver.cfl",
                       100 * result.energy_error, put_in);
  return fmt::format(
      "{:.2g} % of {} was lost to numerical dissipation, as moving points average velocities "
      "through the grid; {}",
      100 * result.energy_error, put_in, less_dissipation(scene));
}

namespace {

constexpr double noticeable = 0.05;  ///< share of motion, or above the peak, that passes without a word [-]
constexpr double uneven =
    1.0 / 3;  ///< imbalance of the platens that passes: waves of failures ring at any rate
/// Share of the work that may go into damping: what points set free as they fail goes there too.
constexpr double usually_damped = 0.4;

void add_phrase(std::string& text, const std::string& phrase) { text += (text.empty() ? "" : ", ") + phrase; }

std::string share_phrase(double share, double limit, const char* what) {
  return share > limit ? fmt::format("{:.0f} % {}", 100 * share, what) : std::string();
}

std::string inertia_phrase(const output::InertiaShares& shares) {
  std::string text;
  for (const std::string& phrase :
       {share_phrase(shares.imbalance, uneven, "of the reactions of the platens do not balance"),
        share_phrase(shares.kinetic, noticeable, "of the work of the platens is motion"),
        share_phrase(shares.damped, usually_damped, "of it went into local damping")})
    if (!phrase.empty()) add_phrase(text, phrase);
  return text;
}

/// What brings a run nearer to equilibrium.
std::string calmer(const output::InertiaShares& shares) {
  const char* less = shares.damped > usually_damped
                         ? "choose a smaller loading.velocity or solver.local_damping"
                         : "choose a smaller loading.velocity";
  return std::string(less) + ", or solver.method = \"quasi_static\", which has neither rate nor damping";
}

std::string megapascals_text(double stress) { return fmt::format("{:.4g} MPa", 1e-6 * stress); }

/// The largest mean reaction of the platens, where it is none that the specimen carries.
std::string wave_phrase(const mpm::Result& result) {
  const auto largest = std::max_element(
      result.history.begin(), result.history.end(),
      [](const mpm::HistoryRow& a, const mpm::HistoryRow& b) { return a.stress < b.stress; });
  if (!(largest->stress > (1 + noticeable) * result.peak_stress)) return {};
  return fmt::format(
      "the mean reaction of the platens reaches {}, at strain {} and {:.0f} % out of balance, which is a "
      "wave and no peak",
      megapascals_text(largest->stress), strain_text(largest->strain), 100 * mpm::platen_imbalance(*largest));
}

/// A peak that comes after a break: parts that move more than they carry, and ring.
std::string ringing_phrase(const mpm::Result& result) {
  double most = 0;
  double strain = 0;
  for (const mpm::HistoryRow& row : result.history) {
    if (row.strain >= result.peak_strain) break;
    if (mpm::platen_imbalance(row) <= mpm::balanced && row.stress > most) {
      most = row.stress;
      strain = row.strain;
    }
    const bool is_broken = row.tension_failures + row.shear_failures > 0 && row.kinetic > row.elastic &&
                           most > 0.2 * result.peak_stress && row.stress < 0.5 * most;
    if (is_broken)
      return fmt::format(
          "the specimen had broken before the peak: after {} at strain {} the stress fell below half of "
          "that, "
          "with more motion than elastic energy, and rose again as its parts rang",
          megapascals_text(most), strain_text(strain));
  }
  return {};
}

}  // namespace

std::string inertia_note(const mpm::Result& result, const mpm::Scene& scene) {
  if (!output::has_platens(scene) || scene.method == mpm::SolverMethod::quasi_static ||
      result.history.empty())
    return {};
  const output::InertiaShares shares = output::inertia_of(output::peak_row(result));
  std::string text;
  if (const std::string found = inertia_phrase(shares); !found.empty())
    text = (mpm::peak_reached(result) ? "the peak is not that of a slow test: at it "
                                      : "the largest stress is not that of a slow test: at it ") +
           found;
  for (const std::string& phrase : {wave_phrase(result), ringing_phrase(result)})
    if (!phrase.empty()) text += (text.empty() ? "" : "; ") + phrase;
  return text.empty() ? text : text + "; " + calmer(shares);
}

std::string remarks_text(const RunRemarks& remarks) {
  const json all{{"notes", remarks.notes},
                 {"estimate_error", remarks.estimate_error},
                 {"tolerated", remarks.tolerated.sources},
                 {"checkpoint_every", remarks.checkpoint_every}};
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

RunRemarks parse_remarks(const std::string& text, const std::string& path) try {
  const json all = json::parse(text);
  RunRemarks remarks;
  all.at("notes").get_to(remarks.notes);
  all.at("estimate_error").get_to(remarks.estimate_error);
  all.at("tolerated").get_to(remarks.tolerated.sources);
  all.at("checkpoint_every").get_to(remarks.checkpoint_every);
  return remarks;
} catch (const json::exception& error) {
  throw Rejected(Exit::data, path, error.what(), "must be a file that mesopix simulate wrote",
                 "begin the run anew");
}

namespace {

constexpr double nano = 1e-9;

std::string bytes_text(double bytes) { return bytes > 0 ? fmt::format("{:.0f}", bytes) : std::string("-"); }

/// A difference that is smaller than what such a measurement can tell, below 0 at times, is shown as such.
std::string time_text(const mpm::Feature& feature, double run) {
  if (!feature.time) return "-";
  const double least = 0.05 * run;
  if (*feature.time < least) return fmt::format("< {:.2f}", least / nano);
  return fmt::format("{:.2f}", *feature.time / nano);
}

std::string rows(const mpm::Explanation& explanation, bool in, std::size_t width) {
  std::string text;
  for (const mpm::Feature& feature : explanation.features)
    if (feature.in == in)
      text += fmt::format("  {:<{}}  {:>5}  {:>7}  {}\n", feature.name, width, bytes_text(feature.bytes),
                          time_text(feature, explanation.time), feature.why);
  return text;
}

}  // namespace

std::string explanation_text(const mpm::Explanation& explanation) {
  std::size_t width = 0;
  for (const mpm::Feature& feature : explanation.features) width = std::max(width, feature.name.size());
  std::string text =
      fmt::format("{}: {:.0f} bytes a point, {:.2f} ns a point and step, measured on this scene\n\n",
                  explanation.kinematics, explanation.bytes, explanation.time / nano);
  text += fmt::format("  {:<{}}  {:>5}  {:>7}\n", "", width, "bytes", "ns");
  text += "In, and what it takes a point:\n" + rows(explanation, true, width);
  text += "Left out, and what that saves a point:\n" + rows(explanation, false, width);
  return text;
}

nlohmann::ordered_json explanation_json(const mpm::Explanation& explanation) {
  nlohmann::ordered_json features = nlohmann::ordered_json::array();
  for (const mpm::Feature& feature : explanation.features) {
    nlohmann::ordered_json one{
        {"name", feature.name}, {"in", feature.in}, {"why", feature.why}, {"bytes_per_point", feature.bytes}};
    if (feature.time) one["s_per_point_update"] = *feature.time;
    features.push_back(std::move(one));
  }
  return {{"kinematics", explanation.kinematics},
          {"bytes_per_point", explanation.bytes},
          {"s_per_point_update", explanation.time},
          {"features", std::move(features)}};
}

}  // namespace app
