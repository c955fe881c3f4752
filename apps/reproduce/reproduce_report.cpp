#include "apps/reproduce/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "apps/report/key_figures.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/version.hpp"

namespace app::reproduce {
namespace {

using output::escape;

constexpr const char* title = "The paper of Liu et al. (2020), reproduced";

std::string header() {
  return output::heading(
      title, fmt::format("Numerical Simulation of Mesodamage Behavior of Concrete Based on Material "
                         "Point Method, Advances in Civil Engineering. By mesopix {}.",
                         version()));
}

std::string how_it_was_run(const Reproduction& reproduction) {
  std::int64_t steps = 0;
  int runs = 0;
  for (const TrialResults::Entry& entry : reproduction.outcomes.entries()) {
    if (!entry.outcome.done) continue;
    ++runs;
    steps += entry.outcome.result.steps;
  }
  std::string text;
  const auto& entries = reproduction.outcomes.entries();
  const auto without = std::count_if(entries.begin(), entries.end(), [](const TrialResults::Entry& entry) {
    return entry.outcome.done && !mpm::peak_reached(entry.outcome.result);
  });
  if (runs > 0)
    text = fmt::format("{} of {} steps, {} at a time, took {:.0f} s. ", counted(runs, "run"),
                       output::grouped(steps), reproduction.workers, reproduction.wall_time);
  if (without > 0)
    text += counted(static_cast<int>(without), "run") + " of them reached no peak and stand in no mean. ";
  return text +
         "Every number that is not the paper's comes from these runs, and every verdict follows from the "
         "numbers.";
}

std::string claim_row(const Claim& claim) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}<br/><span class=\"why\">{}</span></td>"
      "<td class=\"verdict {}\">{}</td></tr>\n",
      escape(claim.figure), escape(claim.paper), escape(claim.measured), escape(claim.why),
      word_of(claim.verdict), word_of(claim.verdict) + (claim.verdict == Verdict::depends ? " on" : ""));
}

std::string claims_table(const std::vector<Claim>& claims) {
  std::string rows;
  for (const Claim& claim : claims) rows += claim_row(claim);
  return output::table("claims", {"Figure", "The paper says", "We find", "Verdict"}, rows);
}

std::string missing_text(const Reproduction& reproduction) {
  std::vector<std::string> names;
  for (const FigureResult& result : reproduction.figures)
    if (!result.done) names.push_back(name_of(*result.figure));
  return names.empty()
             ? ""
             : "It was interrupted before the runs of these were done: " + listed(names, "and") + ".";
}

std::string claims_section(const Reproduction& reproduction) {
  const std::vector<Claim> claims = claims_of(reproduction);
  std::string html;
  if (const std::string missing = missing_text(reproduction); !missing.empty())
    html += output::paragraph(missing);
  if (!claims.empty())
    html += output::paragraph("Of " + counted(static_cast<int>(claims.size()), "claim") + " of the paper " +
                              verdict_counts(claims) + ".") +
            claims_table(claims);
  return output::section(claims.empty() ? "How it was run" : "Claims",
                         html + output::remarks(output::paragraph(how_it_was_run(reproduction))));
}

std::string bears_on(const std::vector<Claim>& claims) {
  std::vector<std::string> parts;
  for (const Claim& claim : claims)
    parts.push_back(fmt::format("“{}” ({})", claim.paper, word_of(claim.verdict)));
  return parts.empty() ? "" : "Bears on: " + listed(parts, "and") + ".";
}

std::string figure_section(const FigureResult& result) {
  if (!result.done) return "";
  const std::string claims = bears_on(result.section.claims);
  return output::section(name_of(*result.figure) + ". " + result.figure->title,
                         result.section.html + output::remarks(output::paragraph(claims)));
}

std::string runs_section(const Reproduction& reproduction) {
  std::string commands;
  for (const TrialResults::Entry& entry : reproduction.outcomes.entries())
    if (entry.outcome.done)
      commands += fmt::format("{}    # {}{}, {}\n", command_of(entry.trial),
                              mpm::peak_reached(entry.outcome.result) ? "" : "no peak, largest stress ",
                              megapascals(entry.outcome.result.peak_stress),
                              microstrain(entry.outcome.result.peak_strain));
  if (commands.empty()) return "";
  return output::section(
      "Runs", output::paragraph("Each run alone, in the folder of the sources; behind it its peak.") +
                  output::folded("The commands", commands));
}

nlohmann::json json_of(const Claim& claim) {
  return {{"id", claim.id},
          {"figure", claim.figure},
          {"paper", claim.paper},
          {"measured", claim.measured},
          {"verdict", word_of(claim.verdict)},
          {"why", claim.why}};
}

nlohmann::json json_of(const FigureResult& result) {
  nlohmann::json json{{"ids", result.figure->ids}, {"title", result.figure->title}, {"done", result.done}};
  if (result.done) json["data"] = result.section.data;
  return json;
}

nlohmann::json json_of(const TrialResults::Entry& entry) {
  const mpm::Result& result = entry.outcome.result;
  nlohmann::json run = output::peak_figures(result);
  run.update({{"command", command_of(entry.trial)},
              {"tension_failures", result.tension_failures},
              {"shear_failures", result.shear_failures},
              {"energy_error", result.energy_error},
              {"steps", result.steps}});
  return run;
}

}  // namespace

std::string verdict_counts(const std::vector<Claim>& claims) {
  struct Words {
    Verdict verdict;
    const char *one, *many;
  };
  constexpr std::array words{
      Words{Verdict::agrees, "agrees with this run", "agree with this run"},
      Words{Verdict::disagrees, "disagrees", "disagree"},
      Words{Verdict::depends, "depends on a choice or on chance", "depend on a choice or on chance"}};
  std::vector<std::string> parts;
  for (const Words& it : words) {
    const auto count = std::count_if(claims.begin(), claims.end(),
                                     [&](const Claim& claim) { return claim.verdict == it.verdict; });
    if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? it.one : it.many));
  }
  return listed(parts, "and");
}

std::string report_html(const Reproduction& reproduction) {
  std::string html = header() + claims_section(reproduction);
  for (const FigureResult& result : reproduction.figures) html += figure_section(result);
  return output::page(title, html + runs_section(reproduction));
}

nlohmann::json report_json(const Reproduction& reproduction) {
  nlohmann::json json{{"version", version()},
                      {"interrupted", reproduction.interrupted},
                      {"specimens", reproduction.effort.specimens},
                      {"repeats", reproduction.effort.repeats},
                      {"wall_time_s", reproduction.wall_time},
                      {"claims", nlohmann::json::array()},
                      {"figures", nlohmann::json::array()},
                      {"runs", nlohmann::json::array()}};
  for (const Claim& claim : claims_of(reproduction)) json["claims"].push_back(json_of(claim));
  for (const FigureResult& result : reproduction.figures) json["figures"].push_back(json_of(result));
  for (const TrialResults::Entry& entry : reproduction.outcomes.entries())
    if (entry.outcome.done) json["runs"].push_back(json_of(entry));
  return json;
}

}  // namespace app::reproduce
