#include "apps/report/key_figures.hpp"

#include <algorithm>
#include <limits>

#include "apps/drawing/damage_stages.hpp"
#include "specimen/describe/statistics.hpp"

namespace output {

double secant_modulus(const mpm::Result& result) {
  const auto reached = [&](const mpm::HistoryRow& row) {
    return row.strain > 0 && row.stress > 0 && row.stress >= 0.4 * result.peak_stress;
  };
  const auto row = std::find_if(result.history.begin(), result.history.end(), reached);
  return row == result.history.end() ? std::numeric_limits<double>::quiet_NaN() : row->stress / row->strain;
}

std::vector<std::pair<std::string, double>> phase_shares(const specimen::LabelledMask& mask) {
  const std::vector<double> fractions = specimen::fractions(mask);
  std::vector<std::pair<std::string, double>> shares;
  for (std::size_t label = 0; label < fractions.size(); ++label)
    if (fractions[label] > 0) shares.emplace_back(mask.phases[label], fractions[label]);
  return shares;
}

std::vector<std::string> all_notes(const RunRecord& record) {
  std::vector<std::string> notes = record.notes;
  const std::string missing = missing_note(damage_stages(record.result));
  if (!missing.empty()) notes.push_back(missing);
  return notes;
}

std::string version() { return MESOPIX_VERSION; }

}  // namespace output
