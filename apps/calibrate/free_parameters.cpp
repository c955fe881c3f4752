#include "apps/calibrate/free_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>

#include "apps/text/quantity.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

constexpr double default_range = 20;    ///< times and parts of the start
constexpr double inside_share = 0.999;  ///< of the way from the start to a bound of the setting

[[noreturn]] void refuse(const std::string& item, std::string allowed, std::string cure = {}) {
  throw Rejected(Exit::usage, option_name("free"), item, std::move(allowed), std::move(cure));
}

double rounded(double value) { return std::strtod(fmt::format("{:.5g}", value).c_str(), nullptr); }

Value written(double value, Dimension dimension) {
  if (dimension == Dimension::ratio) return {value};
  return {format_quantity(value, dimension)};
}

/// The number that a setting holds; nullopt for words such as "unbreakable".
std::optional<double> number_of(const Field& field, const Settings& settings) {
  const Value value = field.get(settings);
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  try {
    return parse_quantity(std::get<std::string>(value.data), field.form.measure->dimension);
  } catch (const Mistake&) {
    return std::nullopt;
  }
}

std::vector<std::string> names_of_phases(const mpm::Scene& scene) {
  std::vector<std::string> names;
  for (const auto& phase : scene.phases)
    if (phase) names.push_back(phase->name);
  return names;
}

bool is_property(const std::string& name) {
  return std::any_of(phase_fields().begin(), phase_fields().end(),
                     [&](const PhaseField& property) { return property.key == name; });
}

bool can_fail(const mpm::Scene& scene, const std::string& name) {
  return std::any_of(scene.phases.begin(), scene.phases.end(),
                     [&](const auto& phase) { return phase && phase->name == name && phase->can_fail(); });
}

class ParameterReader {
 public:
  ParameterReader(const Settings& settings, const mpm::Scene& scene)
      : settings_(settings), scene_(scene), phases_(names_of_phases(scene)) {}

  std::vector<FreeParameter> read(const std::string& text) {
    std::vector<FreeParameter> parameters;
    for (const std::string& item : items_between(text, ',')) parameters.push_back(read_parameter(item));
    return parameters;
  }

 private:
  FreeParameter read_parameter(const std::string& item) {
    const std::size_t equals = item.find('=');
    FreeParameter parameter{
        std::string(trimmed(item.substr(0, equals))), {}, 1 / default_range, default_range};
    for (const std::string& key : items_between(parameter.name, '+')) add_settings(key, parameter);
    if (equals != std::string::npos) read_bounds(item, item.substr(equals + 1), parameter);
    for (const ScaledSetting& setting : parameter.settings) confine(setting, parameter);
    if (!(parameter.low < parameter.high))
      refuse(item, fmt::format("leaves no room for {}", parameter.settings.front().field.key),
             "give it other bounds with =LOW..HIGH");
    return parameter;
  }

  void add_settings(const std::string& key, FreeParameter& parameter) {
    if (key.empty())
      refuse(parameter.name, "must be a key, or several with commas between them",
             "write e.g. tensile_scale,mortar.young");
    std::string wanted = key;
    std::replace(wanted.begin() + static_cast<std::ptrdiff_t>(key.size() - leaf_of(key).size()), wanted.end(),
                 '-', '_');
    if (is_property(wanted))
      add_property(wanted, parameter);
    else
      add_key(wanted, parameter);
  }

  /// Of all phases where it is a number that matters.
  void add_property(const std::string& property, FreeParameter& parameter) {
    const std::size_t before = parameter.settings.size();
    for (const std::string& phase : phases_) {
      const auto field = find_field(fmt::format("phases.{}.{}", phase, property));
      const auto start = number_of(*field, settings_);
      const bool matters = property != "weibull_modulus" || can_fail(scene_, phase);
      if (start && *start > 0 && matters) add(*field, *start, parameter);
    }
    if (parameter.settings.size() == before)
      refuse(property, "no phase has one that can be scaled", "give a value in the scene to begin with");
  }

  void add_key(const std::string& given, FreeParameter& parameter) {
    const bool is_full = find_field(given).has_value();
    const std::string key = is_full ? given : "phases." + given;
    const auto field = find_field(key);
    if (!field) refuse(given, "unknown key", suggestion_for(given));
    check_field(*field, given);
    const auto start = number_of(*field, settings_);
    if (!start || !(*start > 0))
      refuse(given, fmt::format("is {} in the scene; must be a number > 0, as it is scaled", shown(*field)),
             "give a value in the scene to begin with");
    add(*field, *start, parameter);
  }

  [[nodiscard]] std::string suggestion_for(const std::string& given) const {
    std::vector<std::string> properties;
    for (const PhaseField& property : phase_fields()) properties.push_back(property.key);
    if (given.find('.') != std::string::npos)
      return text(suggest_key(is_group(group_of(given)) ? given : "phases." + given, settings_));
    return text(
        Suggestion{closest(given, properties), "the properties of phases are " + listed(properties, "and")});
  }

  [[nodiscard]] std::string shown(const Field& field) const {
    const Value value = field.get(settings_);
    const auto* text = std::get_if<std::string>(&value.data);
    return text != nullptr ? *text : toml_text(value);
  }

  void check_field(const Field& field, const std::string& given) const {
    const std::string group = group_of(field.key);
    if (!field.form.measure) refuse(given, "is no quantity that can be scaled");
    if ((group != "phases" && group != "loading" && group != "damage") ||
        field.key.starts_with("loading.stop_"))
      refuse(given, "no property of the model; must be a quantity of phases, loading or damage");
    if (const std::string reason = why_unused(field.key, settings_); !reason.empty()) refuse(given, reason);
    if (group != "phases") return;
    const std::string phase = field.key.substr(7, field.key.rfind('.') - 7);
    if (std::find(phases_.begin(), phases_.end(), phase) == phases_.end())
      refuse(given, "the specimen has " + listed(phases_, "and"), did_you_mean(phase, phases_));
  }

  void add(const Field& field, double start, FreeParameter& parameter) {
    if (!taken_.insert(field.key).second) refuse(field.key, "is free twice", "name it once");
    parameter.settings.push_back({field, start});
  }

  static void read_bounds(const std::string& item, const std::string& text, FreeParameter& parameter) {
    const ScaledSetting& first = parameter.settings.front();
    const Dimension dimension = first.field.form.measure->dimension;
    const std::size_t dots = text.find("..");
    const std::string low = text.substr(0, dots);
    const std::string high = dots == std::string::npos ? "" : text.substr(dots + 2);
    try {
      parameter.low = parse_quantity(low, dimension) / first.start;
      parameter.high = parse_quantity(high, dimension) / first.start;
    } catch (const Mistake& mistake) {
      refuse(item, "bounds: " + mistake.allowed,
             fmt::format("write e.g. {}={}..{}", parameter.name, first.text(0.5), first.text(2)));
    }
    if (!(parameter.low > 0 && parameter.low < parameter.high))
      refuse(item, "bounds must be > 0 and rise", "the lower one comes first");
  }

  /// Bounds of the schema, less a little: some are not allowed themselves.
  static void confine(const ScaledSetting& setting, FreeParameter& parameter) {
    const Bounds& bounds = setting.field.form.measure->bounds;
    const auto just_inside = [&](double bound) {
      return (setting.start + inside_share * (bound - setting.start)) / setting.start;
    };
    if (bounds.low > 0) parameter.low = std::max(parameter.low, just_inside(bounds.low));
    if (std::isfinite(bounds.high)) parameter.high = std::min(parameter.high, just_inside(bounds.high));
  }

  const Settings& settings_;
  const mpm::Scene& scene_;
  std::vector<std::string> phases_;
  std::set<std::string> taken_;
};

constexpr double bound_width = 0.05;  ///< of the logarithm of a factor

}  // namespace

double ScaledSetting::value(double factor) const { return rounded(start * factor); }

std::string ScaledSetting::text(double factor) const {
  const Dimension dimension = field.form.measure->dimension;
  if (dimension == Dimension::ratio) return format_number(value(factor));
  return format_like(value(factor), start, dimension);
}

std::vector<FreeParameter> parse_free(const std::string& text, const Settings& settings,
                                      const mpm::Scene& scene) {
  return ParameterReader(settings, scene).read(text);
}

void scale(Settings& settings, const std::vector<FreeParameter>& parameters,
           const std::vector<double>& factors) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const ScaledSetting& setting : parameters[i].settings)
      setting.field.set(settings, written(setting.value(factors[i]), setting.field.form.measure->dimension));
}

bool is_at_low_bound(const FreeParameter& parameter, double factor) {
  return std::log(factor / parameter.low) < bound_width;
}

bool is_at_high_bound(const FreeParameter& parameter, double factor) {
  return std::log(parameter.high / factor) < bound_width;
}

}  // namespace app
