/// One parameter of the model varied, all others as in Table 1.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/reproduce/figure.hpp"
#include "apps/statistics/statistics.hpp"

namespace app::reproduce {

/// A test in which the parameter is varied.
struct Case {
  std::string name;   ///< "tension"
  std::string scene;  ///< of data/paper
  std::vector<Setting> settings;
  int repeats = 0;  ///< random specimens a value; 0 = as many as the effort says
};

struct Sweep {
  std::string symbol;  ///< "f_t"
  std::string unit;    ///< "MPa"; empty = none
  std::vector<double> values;
  double table1 = 0;  ///< the value of the scenes as they stand
  std::function<std::vector<Setting>(double)> settings;
  std::vector<Case> cases;
};

/// What one case gave, value by value.
struct CaseResult {
  std::string name;
  int specimens = 0;  ///< random specimens a value
  std::vector<double> values;
  std::vector<Spread> peak_stress;  ///< [Pa]
  std::vector<Spread> peak_strain;  ///< [-]
  std::vector<double> drop;         ///< strain at 50 % of the peak behind it over that at the peak [-], mean
  std::vector<double> shear_share;  ///< of all failures up to the end [-]
  std::vector<const mpm::Result*> first;  ///< of the first specimen

  [[nodiscard]] std::vector<double> mean_stress() const;
};

[[nodiscard]] std::vector<Trial> trials_of(const Sweep& sweep, const Effort& effort);
[[nodiscard]] std::vector<CaseResult> results_of(const Sweep& sweep, const Effort& effort,
                                                 const TrialResults& outcomes);

/// Charts, two beside each other, and a table for each case.
[[nodiscard]] std::string sweep_html(const Sweep& sweep, const std::vector<CaseResult>& results);
[[nodiscard]] nlohmann::json sweep_json(const std::vector<CaseResult>& results);

/// "tension 2.94 to 5.68 MPa, compression ... for m = 1 to 6".
[[nodiscard]] std::string ends_text(const Sweep& sweep, const std::vector<CaseResult>& results);

/// Names of the cases in which a condition holds, or does not: "tension and compression"; "none".
[[nodiscard]] std::string names_where(const std::vector<CaseResult>& results, const std::vector<bool>& holds,
                                      bool wanted);

/// Both phases that can fail: the ITZ keeps its share of the mortar's strength.
[[nodiscard]] std::vector<Setting> strength_settings(const std::string& property, double mortar_megapascals);

}  // namespace app::reproduce
