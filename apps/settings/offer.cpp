#include "apps/settings/offer.hpp"

#include <algorithm>

#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

bool among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct Named {
  std::string name;
  std::string key;
};

/// Short names of the own settings, in the spelling of keys.
std::vector<Named> short_names(const Offer& offer) {
  std::vector<Named> names;
  for (const Group& group : groups())
    for (const Field& field : fields_of(group.name))
      if (offer.is_own(group.name) && offer.has(field.key))
        names.push_back({with_underscores(short_option(group, field)), field.key});
  return names;
}

std::string suggest_name(const Offer& offer, const std::string& name) {
  if (name.find('.') != std::string::npos) return text(suggest_key(name, Settings()));
  std::vector<std::string> known;
  for (const Named& one : short_names(offer)) known.push_back(one.name);
  Suggestion near{closest(name, known), {}};
  for (const Field& field : fields())
    if (near.meant.empty() && leaf_of(field.key) == name && offer.has(field.key)) near.meant = field.key;
  return text(near);
}

}  // namespace

bool Offer::is_own(const std::string& group) const { return among(own, group); }

bool Offer::has(const std::string& key) const {
  const std::string group = group_of(key);
  return (among(own, group) || among(others, group)) && !among(hidden, key);
}

const Offer& offer_of_generate() {
  static const Offer offer{
      {"specimen", "generate", "itz"}, {}, {"specimen.file", "specimen.picture", "specimen.sha256"}};
  return offer;
}

const Offer& offer_of_convert() {
  static const Offer offer{{"convert", "itz"}, {}, {}};
  return offer;
}

const Offer& offer_of_twin() {
  static const Offer offer{
      {"convert", "itz"}, {"specimen", "generate"}, {"specimen.file", "specimen.picture"}};
  return offer;
}

const Offer& offer_of_simulate() {
  static const Offer offer{{"phases", "loading", "damage", "solver", "motion", "handover", "output"},
                           {"specimen", "generate", "convert", "itz"},
                           {}};
  return offer;
}

const Offer& offer_of_calibrate() {
  static const Offer offer{{"phases"},
                           {"specimen", "generate", "convert", "itz", "loading", "damage", "solver", "motion",
                            "handover", "output"},
                           {}};
  return offer;
}

const Offer& offer_of_stiffness() {
  static const Offer offer{
      {"phases", "solver"},
      {"specimen", "generate", "convert", "itz"},
      {"solver.method", "solver.event_tolerance", "solver.kinematics", "solver.cfl", "solver.local_damping",
       "solver.precision", "solver.threads", "phases.tensile_scale", "phases.cohesion",
       "phases.friction_angle", "phases.weibull_modulus", "phases.fracture_energy", "phases.softening",
       "phases.shear_fracture_energy"}};
  return offer;
}

std::string with_dashes(std::string text) {
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

std::string with_underscores(std::string text) {
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

std::string short_option(const Group& group, const Field& field) {
  return group.option_prefix + with_dashes(leaf_of(field.key));
}

std::string phase_key(const std::string& option) {
  const std::size_t dot = option.rfind('.');
  if (dot == std::string::npos) return {};
  std::string phase = option.substr(0, dot);
  if (phase.rfind("phases.", 0) == 0) phase = phase.substr(7);
  const std::string property = with_underscores(option.substr(dot + 1));
  if (is_group(phase) && find_field(phase + "." + property)) return {};
  const std::string key = "phases." + phase + "." + property;
  return find_field(key) ? key : std::string();
}

std::string key_named(const Offer& offer, const std::string& name) {
  const std::string spelt = with_underscores(name);
  for (const Named& one : short_names(offer))
    if (one.name == spelt) return one.key;
  const std::string of_phase = phase_key(name);
  const std::string key = !of_phase.empty() ? of_phase : spelt;
  if (!find_field(key)) throw Rejected(Exit::usage, name, "unknown option", suggest_name(offer, spelt));
  if (!offer.has(key)) throw Rejected(Exit::usage, name, "has no effect here", "remove it");
  return key;
}

}  // namespace app
