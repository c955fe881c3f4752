#include "apps/reproduce/words.hpp"

#include "apps/text/text.hpp"

namespace app::reproduce {
namespace {

std::string with_deviation(const Spread& spread, double factor, const std::string& unit) {
  std::string text = output::rounded(factor * spread.mean);
  if (spread.deviation > 0) text += " ± " + output::rounded(factor * spread.deviation, 2);
  return text + " " + unit;
}

}  // namespace

std::string megapascals(double stress) { return output::rounded(1e-6 * stress) + " MPa"; }
std::string microstrain(double strain) { return output::rounded(1e6 * strain) + " microstrain"; }
std::string megapascals(const Spread& stress) { return with_deviation(stress, 1e-6, "MPa"); }
std::string microstrain(const Spread& strain) { return with_deviation(strain, 1e6, "microstrain"); }

std::string counted(int count, const std::string& noun) {
  return count == 1 ? "one " + noun : std::to_string(count) + " " + noun + "s";
}

nlohmann::json json_of(const Spread& spread) {
  return {{"mean", spread.mean},
          {"standard_deviation", spread.deviation},
          {"least", spread.low},
          {"largest", spread.high}};
}

}  // namespace app::reproduce
