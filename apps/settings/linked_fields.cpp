#include "apps/settings/linked_fields.hpp"

#include <cctype>

#include "apps/settings/codec.hpp"

namespace app {

Field cell_field() {
  const WordCodec words{{"auto", "pixel", "1 x 1", "2 x 2", "3 x 3", "4 x 4"}};
  return {"solver.cell",
          "cell of the grid: pixel = one pixel, integrated in full; k x k = that many pixels, each a point; "
          "auto = pixel, and 2 x 2 for points that move",
          words.form(),
          [words](Settings& settings, const Value& value) {
            const std::string word = words.read(value);
            settings.automatic_cell = word == "auto";
            settings.scene.pixel_cells = word == "pixel";
            settings.scene.points_per_cell = std::isdigit(word.front()) != 0 ? word.front() - '0' : 1;
            follow_kinematics(settings);
          },
          [words](const Settings& settings) {
            const auto k = static_cast<std::size_t>(settings.scene.points_per_cell);
            return words.write(settings.automatic_cell      ? "auto"
                               : settings.scene.pixel_cells ? "pixel"
                                                            : words.words.at(k + 1));
          }};
}

Field points_per_cell_field() {
  const IntegerCodec<> number{between(1, 4)};
  return {"solver.points_per_cell", "now solver.cell", number.form(),
          [number](Settings& settings, const Value& value) {
            settings.scene.points_per_cell = number.read(value);
            settings.scene.pixel_cells = settings.automatic_cell = false;
          },
          [number](const Settings& settings) { return number.write(settings.scene.points_per_cell); }};
}

Field damping_field() {
  const QuantityCodec share{Dimension::ratio, below(0, 1), Word{"auto", -1}};
  return {"solver.local_damping",
          "share of the unbalanced force that opposes the motion; auto = 0.2, and none for points that move",
          share.form(),
          [share](Settings& settings, const Value& value) {
            settings.scene.local_damping = share.read(value);
            settings.automatic_damping = settings.scene.local_damping < 0;
            follow_kinematics(settings);
          },
          [share](const Settings& settings) {
            return share.write(settings.automatic_damping ? -1 : settings.scene.local_damping);
          }};
}

Field kinematics_field() {
  using mpm::Kinematics;
  const ChoiceCodec<Kinematics> choices{{{"small_strain", Kinematics::small_strain},
                                         {"moving", Kinematics::moving},
                                         {"auto", Kinematics::automatic}}};
  return {"solver.kinematics",
          "points that keep their place, or move with the specimen; auto = move once they need to",
          choices.form(),
          [choices](Settings& settings, const Value& value) {
            settings.scene.kinematics = choices.read(value);
            follow_kinematics(settings);
          },
          [choices](const Settings& settings) { return choices.write(settings.scene.kinematics); }};
}

}  // namespace app
