#include "apps/job/stiffness.hpp"

#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>

#include "apps/job/job.hpp"
#include "apps/settings/offer.hpp"
#include "apps/text/words.hpp"
#include "specimen/describe/doubts.hpp"
#include "specimen/describe/statistics.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double giga = 1e9;
constexpr std::array<const char*, 3> components{"xx", "yy", "xy"};

Moduli moduli_of(const Eigen::Matrix3d& tensor, mpm::Plane plane) {
  const mpm::NearestIsotropic nearest = mpm::nearest_isotropic(tensor);
  return {nearest.moduli, mpm::elastic_constants(nearest.moduli, plane), nearest.distance};
}

BoundaryStiffness measure(const mpm::Scene& scene, mpm::Boundary boundary) {
  const auto start = std::chrono::steady_clock::now();
  BoundaryStiffness found;
  found.effective = mpm::effective_stiffness(scene, boundary);
  found.moduli = moduli_of(found.effective.stiffness, scene.plane);
  found.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return found;
}

std::vector<MixedPhase> phases_in(const specimen::Specimen& specimen, const mpm::Scene& scene) {
  const std::vector<double> shares = specimen::fractions(specimen.mask);
  std::vector<MixedPhase> phases;
  for (std::size_t label = 0; label < shares.size(); ++label) {
    if (shares[label] <= 0) continue;
    const auto& phase = scene.phases[label];
    phases.push_back(
        {specimen.mask.phases[label], shares[label], phase ? phase->young : 0, phase ? phase->poisson : 0});
  }
  return phases;
}

/// The bounds by name, from the lowest to the highest.
struct NamedBound {
  const char* key;
  const char* title;
  mpm::PlaneModuli mpm::StiffnessBounds::*moduli;
};
constexpr std::array<NamedBound, 4> named_bounds{
    {{"reuss", "Reuss", &mpm::StiffnessBounds::reuss},
     {"hashin_shtrikman_lower", "Hashin-Shtrikman lower", &mpm::StiffnessBounds::hashin_shtrikman_lower},
     {"hashin_shtrikman_upper", "Hashin-Shtrikman upper", &mpm::StiffnessBounds::hashin_shtrikman_upper},
     {"voigt", "Voigt", &mpm::StiffnessBounds::voigt}}};

Json moduli_json(const mpm::PlaneModuli& moduli, mpm::Plane plane) {
  const mpm::ElasticConstants constants = mpm::elastic_constants(moduli, plane);
  return {{"young_Pa", constants.young}, {"bulk_Pa", moduli.bulk}, {"shear_Pa", moduli.shear}};
}

Json boundary_json(const BoundaryStiffness& one) {
  Json tensor = Json::array();
  for (int row = 0; row < 3; ++row) {
    tensor.push_back(Json::array());
    for (int col = 0; col < 3; ++col) tensor.back().push_back(one.effective.stiffness(row, col));
  }
  return {{"stiffness_Pa", tensor},
          {"young_Pa", one.moduli.constants.young},
          {"poisson", one.moduli.constants.poisson},
          {"bulk_Pa", one.moduli.plane.bulk},
          {"shear_Pa", one.moduli.plane.shear},
          {"anisotropy", one.moduli.anisotropy},
          {"carried", one.effective.carried},
          {"energy_error", one.effective.energy_error},
          {"solved", one.effective.solved},
          {"iterations", one.effective.iterations},
          {"wall_time_s", one.wall_time}};
}

/// A line with a figure for each condition at the edges.
std::string line_of(const StiffnessReport& report, const std::string& name, int decimals,
                    const std::function<double(const BoundaryStiffness&)>& figure) {
  std::string line = fmt::format("  {:<24}", name);
  for (const BoundaryStiffness& one : report.boundaries)
    line += fmt::format("{:>16.{}f}", figure(one), decimals);
  return line + '\n';
}

std::string heading(const StiffnessReport& report) {
  std::string text = fmt::format("{}: {} x {} pixels of {:.4g} mm, plane {}, cells of {}\n", report.name,
                                 report.cols, report.rows, 1e3 * report.pixel_size,
                                 report.plane == mpm::Plane::strain ? "strain" : "stress",
                                 report.cell == "pixel" ? "1 pixel" : report.cell + " pixels");
  std::vector<std::string> parts;
  for (const MixedPhase& phase : report.phases)
    parts.push_back(phase.young > 0 ? fmt::format("{} {:.1f} % (E {:.4g} GPa, nu {:.4g})", phase.name,
                                                  100 * phase.share, phase.young / giga, phase.poisson)
                                    : fmt::format("{} {:.1f} %", phase.name, 100 * phase.share));
  return text + "  " + listed(parts, "and") + "\n";
}

std::string bounds_text(const StiffnessReport& report) {
  std::string text = fmt::format("\n  {:<24}{:>16}{:>16}{:>16}\n", "bounds (GPa)", "E", "k", "G");
  for (const NamedBound& bound : named_bounds) {
    const mpm::PlaneModuli& moduli = report.bounds.*bound.moduli;
    text += fmt::format("  {:<24}{:>16.3f}{:>16.3f}{:>16.3f}\n", bound.title,
                        mpm::elastic_constants(moduli, report.plane).young / giga, moduli.bulk / giga,
                        moduli.shear / giga);
  }
  return text;
}

}  // namespace

const char* boundary_word(mpm::Boundary boundary) {
  switch (boundary) {
    case mpm::Boundary::uniform_stress:
      return "uniform_stress";
    case mpm::Boundary::periodic:
      return "periodic";
    case mpm::Boundary::uniform_strain:
      return "uniform_strain";
  }
  return "";
}

StiffnessReport measure_stiffness(const std::string& name, const specimen::Specimen& specimen,
                                  const Settings& settings) {
  const mpm::Scene scene = build_elastic_scene(specimen, settings);
  StiffnessReport report;
  report.name = name;
  report.cols = static_cast<int>(scene.labels.cols());
  report.rows = static_cast<int>(scene.labels.rows());
  report.pixel_size = scene.pixel_size;
  report.cell = scene.pixel_cells ? "pixel" : fmt::format("{0} x {0}", scene.points_per_cell);
  report.plane = scene.plane;
  report.phases = phases_in(specimen, scene);
  for (std::size_t i = 0; i < all_boundaries.size(); ++i)
    report.boundaries[i] = measure(scene, all_boundaries[i]);
  report.bounds = mpm::stiffness_bounds(mpm::phase_shares(scene));
  report.doubts = specimen::doubts_of(specimen);
  return report;
}

void refuse_strengths(const std::vector<Assignment>& given) {
  for (const Assignment& one : given)
    if (group_of(one.key) == "phases" && !offer_of_stiffness().has("phases." + leaf_of(one.key)))
      throw Rejected(Exit::usage, one.field, "has no effect on the stiffness", "remove it");
}

Json stiffness_json(const StiffnessReport& report) {
  Json json{{"name", report.name},
            {"columns", report.cols},
            {"rows", report.rows},
            {"pixel_size_m", report.pixel_size},
            {"plane", report.plane == mpm::Plane::strain ? "strain" : "stress"},
            {"cell", report.cell},
            {"warnings", report.doubts},
            {"phases", Json::object()}};
  for (const MixedPhase& phase : report.phases)
    json["phases"][phase.name] = {
        {"fraction", phase.share}, {"young_Pa", phase.young}, {"poisson", phase.poisson}};
  for (std::size_t i = 0; i < all_boundaries.size(); ++i)
    json[boundary_word(all_boundaries[i])] = boundary_json(report.boundaries[i]);
  for (const NamedBound& bound : named_bounds)
    json["bounds"][bound.key] = moduli_json(report.bounds.*bound.moduli, report.plane);
  return json;
}

std::string stiffness_text(const StiffnessReport& report) {
  std::string text = heading(report);
  text += fmt::format("\n  {:<24}{:>16}{:>16}{:>16}\n", "stiffness (GPa)", "uniform stress", "periodic",
                      "uniform strain");
  for (int row = 0; row < 3; ++row)
    for (int col = row; col < 3; ++col)
      text +=
          line_of(report,
                  fmt::format("C {} {}", components.at(static_cast<std::size_t>(row)),
                              components.at(static_cast<std::size_t>(col))),
                  3, [&](const BoundaryStiffness& one) { return one.effective.stiffness(row, col) / giga; });
  text += "  nearest isotropic\n";
  text += line_of(report, "E (GPa)", 3,
                  [](const BoundaryStiffness& one) { return one.moduli.constants.young / giga; });
  text += line_of(report, "nu", 4, [](const BoundaryStiffness& one) { return one.moduli.constants.poisson; });
  text += line_of(report, "k (GPa)", 3,
                  [](const BoundaryStiffness& one) { return one.moduli.plane.bulk / giga; });
  text += line_of(report, "G (GPa)", 3,
                  [](const BoundaryStiffness& one) { return one.moduli.plane.shear / giga; });
  text += line_of(report, "anisotropy (%)", 2,
                  [](const BoundaryStiffness& one) { return 100 * one.moduli.anisotropy; });
  text += line_of(report, "iterations", 0,
                  [](const BoundaryStiffness& one) { return static_cast<double>(one.effective.iterations); });
  text += line_of(report, "time (s)", 2, [](const BoundaryStiffness& one) { return one.wall_time; });
  return text + bounds_text(report);
}

std::vector<std::string> stiffness_notes(const StiffnessReport& report) {
  std::vector<std::string> notes;
  std::vector<std::string> missing;
  const auto& stress = report.boundaries.front().effective;
  for (std::size_t i = 0; i < components.size(); ++i)
    if (!stress.carried.at(i)) missing.emplace_back(components.at(i));
  if (!missing.empty())
    notes.push_back(
        report.name +
        ": nothing can pull at the void along its edges, so under uniform stress its stiffness is 0 in " +
        listed(missing, "and"));
  for (std::size_t i = 0; i < all_boundaries.size(); ++i)
    if (!report.boundaries[i].effective.solved)
      notes.push_back(
          fmt::format("{}: no equilibrium was found with the edges {}; those figures are not exact",
                      report.name, boundary_word(all_boundaries[i])));
  return notes;
}

}  // namespace app
