#include "apps/scene/test_scenes.hpp"

#include <algorithm>

#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

using KeyTexts = std::vector<std::pair<std::string, std::string>>;

/// A rectangle of concrete whose cracks take energy, solved without inertia in plane stress.
KeyTexts concrete(const char* width, const char* height, const char* pixel) {
  return {{"generate.width", width},
          {"generate.height", height},
          {"generate.pixel_size", pixel},
          {"solver.method", "quasi_static"},
          {"solver.plane", "stress"},
          {"solver.event_tolerance", "5 %"},
          {"damage.seed", "1"}};
}

KeyTexts aggregates(const char* smallest, const char* largest) {
  return {{"generate.fraction", "35 %"},
          {"generate.d_min", smallest},
          {"generate.d_max", largest},
          {"generate.seed", "1"}};
}

/// Strength and fracture energy of the mortar and of its contact with the aggregates.
KeyTexts strength(const char* mortar, const char* itz, const char* energy, const char* energy_of_itz) {
  return {{"phases.mortar.tensile_scale", mortar},   {"phases.mortar.weibull_modulus", "12"},
          {"phases.mortar.fracture_energy", energy}, {"phases.itz.tensile_scale", itz},
          {"phases.itz.weibull_modulus", "12"},      {"phases.itz.fracture_energy", energy_of_itz}};
}

KeyTexts joined(std::initializer_list<KeyTexts> parts) {
  KeyTexts all;
  for (const KeyTexts& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// The beam D = 50 mm, notched to half its depth, of Gregoire, Rojas-Solano and Pijaudier-Cabot (2013).
TestScene three_point_bending() {
  return {"three-point-bending", "Three-point bending of a notched beam",
          joined({concrete("175 mm", "50 mm", "1 mm"),
                  aggregates("4 mm", "10 mm"),
                  strength("4.4 MPa", "2.6 MPa", "70 J/m2", "30 J/m2"),
                  {{"phases.aggregate.young", "50 GPa"},
                   {"phases.mortar.young", "33 GPa"},
                   {"phases.itz.young", "25 GPa"},
                   {"cuts[1].rectangle", "86 mm,0 mm,3 mm,25 mm"},
                   {"supports[1].at", "bottom"},
                   {"supports[1].from", "25 mm"},
                   {"supports[1].to", "25 mm"},
                   {"supports[1].fix", "xy"},
                   {"supports[2].at", "bottom"},
                   {"supports[2].from", "150 mm"},
                   {"supports[2].to", "150 mm"},
                   {"supports[2].fix", "y"},
                   {"loads[1].at", "top"},
                   {"loads[1].from", "85 mm"},
                   {"loads[1].to", "90 mm"},
                   {"loads[1].displacement", "down"},
                   {"gauges[1].name", "CMOD"},
                   {"gauges[1].from", "86 mm,0 mm"},
                   {"gauges[1].to", "89 mm,0 mm"},
                   {"gauges[1].direction", "x"},
                   {"gauges[1].controls", "true"},
                   {"gauges[1].until", "0.15 mm"},
                   {"loading.thickness", "50 mm"}}})};
}

/// Splitting of a cylinder, in its cross-section: strength 2 F / (pi D L).
TestScene brazilian() {
  return {"brazilian", "Splitting test of a disc",
          joined({concrete("50 mm", "50 mm", "0.5 mm"),
                  aggregates("3 mm", "8 mm"),
                  strength("5 MPa", "3 MPa", "60 J/m2", "20 J/m2"),
                  {{"cuts[1].circle", "25 mm,25 mm,25 mm"},
                   {"cuts[1].keeps", "inside"},
                   {"supports[1].at", "bottom"},
                   {"supports[1].from", "22 mm"},
                   {"supports[1].to", "28 mm"},
                   {"supports[1].fix", "xy"},
                   {"loads[1].at", "top"},
                   {"loads[1].from", "22 mm"},
                   {"loads[1].to", "28 mm"},
                   {"loads[1].displacement", "down"},
                   {"gauges[1].name", "across"},
                   {"gauges[1].from", "5 mm,25 mm"},
                   {"gauges[1].to", "45 mm,25 mm"},
                   {"gauges[1].direction", "x"},
                   {"gauges[1].controls", "true"},
                   {"gauges[1].until", "0.06 mm"},
                   {"loading.thickness", "50 mm"}}})};
}

/// The panel of Winkler (2001).
TestScene l_panel() {
  return {"l-panel", "L-shaped panel, pushed up at its arm",
          joined({concrete("500 mm", "500 mm", "5 mm"),
                  {{"generate.fraction", "0 %"},
                   {"phases.mortar.young", "25.85 GPa"},
                   {"phases.mortar.poisson", "0.18"},
                   {"phases.mortar.tensile_scale", "2.7 MPa"},
                   {"phases.mortar.cohesion", "unbreakable"},
                   {"phases.mortar.weibull_modulus", "20"},
                   {"phases.mortar.fracture_energy", "65 J/m2"},
                   {"phases.mortar.softening", "bilinear"},
                   {"solver.event_tolerance", "1 %"},
                   {"cuts[1].rectangle", "250 mm,0 mm,250 mm,250 mm"},
                   {"supports[1].at", "bottom"},
                   {"supports[1].fix", "xy"},
                   {"loads[1].at", "bottom"},
                   {"loads[1].from", "460 mm"},
                   {"loads[1].to", "480 mm"},
                   {"loads[1].displacement", "up"},
                   {"gauges[1].name", "mouth"},
                   {"gauges[1].from", "250 mm,245 mm"},
                   {"gauges[1].to", "300 mm,250 mm"},
                   {"gauges[1].direction", "y"},
                   {"loading.thickness", "100 mm"},
                   {"loading.stop_displacement", "1 mm"}}})};
}

TestScene double_edge_notch() {
  return {"double-edge-notch", "Tension of a plate with a notch in each edge",
          joined({concrete("60 mm", "120 mm", "1 mm"),
                  aggregates("4 mm", "10 mm"),
                  strength("5 MPa", "3 MPa", "60 J/m2", "20 J/m2"),
                  {{"cuts[1].rectangle", "0 mm,59 mm,5 mm,2 mm"},
                   {"cuts[2].rectangle", "55 mm,59 mm,5 mm,2 mm"},
                   {"supports[1].at", "bottom"},
                   {"supports[1].fix", "xy"},
                   {"loads[1].at", "top"},
                   {"loads[1].displacement", "up"},
                   {"loads[1].grips", "true"},
                   {"gauges[1].name", "whole"},
                   {"gauges[1].from", "30 mm,45 mm"},
                   {"gauges[1].to", "30 mm,75 mm"},
                   {"gauges[1].direction", "y"},
                   {"gauges[1].controls", "true"},
                   {"gauges[1].until", "0.06 mm"},
                   {"gauges[2].name", "left"},
                   {"gauges[2].from", "0 mm,45 mm"},
                   {"gauges[2].to", "0 mm,75 mm"},
                   {"gauges[2].direction", "y"},
                   {"gauges[3].name", "right"},
                   {"gauges[3].from", "60 mm,45 mm"},
                   {"gauges[3].to", "60 mm,75 mm"},
                   {"gauges[3].direction", "y"},
                   {"loading.thickness", "50 mm"}}})};
}

TestScene wedge_splitting() {
  return {"wedge-splitting", "Wedge splitting of a notched cube",
          joined({concrete("100 mm", "100 mm", "1 mm"),
                  aggregates("4 mm", "12 mm"),
                  strength("5 MPa", "3 MPa", "80 J/m2", "30 J/m2"),
                  {{"cuts[1].rectangle", "35 mm,80 mm,30 mm,20 mm"},
                   {"cuts[2].rectangle", "49 mm,50 mm,2 mm,30 mm"},
                   {"supports[1].at", "bottom"},
                   {"supports[1].from", "50 mm"},
                   {"supports[1].to", "50 mm"},
                   {"supports[1].fix", "xy"},
                   {"loads[1].at", "left"},
                   {"loads[1].from", "85 mm"},
                   {"loads[1].to", "95 mm"},
                   {"loads[1].displacement", "left"},
                   {"loads[1].leads", "true"},
                   {"loads[2].at", "right"},
                   {"loads[2].from", "85 mm"},
                   {"loads[2].to", "95 mm"},
                   {"loads[2].displacement", "right"},
                   {"gauges[1].name", "CMOD"},
                   {"gauges[1].from", "35 mm,90 mm"},
                   {"gauges[1].to", "65 mm,90 mm"},
                   {"gauges[1].direction", "x"},
                   {"gauges[1].controls", "true"},
                   {"gauges[1].until", "0.3 mm"},
                   {"loading.thickness", "100 mm"}}})};
}

}  // namespace

const std::vector<TestScene>& test_scenes() {
  static const std::vector<TestScene> all{three_point_bending(), l_panel(), brazilian(), wedge_splitting(),
                                          double_edge_notch()};
  return all;
}

const TestScene& test_scene_named(const std::string& name) {
  std::vector<std::string> names;
  for (const TestScene& test : test_scenes()) {
    if (test.name == name) return test;
    names.push_back(test.name);
  }
  throw Rejected(Exit::usage, "--test", name, "must be " + listed(names), did_you_mean(name, names));
}

}  // namespace app
