#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/system/files.hpp"
#include "specimen/file/specimen_file.hpp"
#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_specimen.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace stiffness_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Layers of mortar, aggregate and, where it is wanted, void.
specimen::Specimen layers(int aggregate_rows, int void_rows = 0) {
  specimen::Specimen made = test::small_specimen();
  made.inclusions.clear();
  made.rings.clear();
  made.itz.mode = specimen::ItzMode::none;
  made.provenance.source = "generated";  // to order, whatever it is like
  made.mask.pixel_size = 1e-3;
  made.mask.labels = specimen::Raster<std::uint8_t>(12, 12);
  for (int row = 0; row < 12; ++row)
    for (int col = 0; col < 12; ++col)
      made.mask.labels(row, col) =
          static_cast<std::uint8_t>(row < aggregate_rows               ? specimen::phase::aggregate
                                    : row < aggregate_rows + void_rows ? specimen::phase::void_
                                                                       : specimen::phase::mortar);
  return made;
}

class StiffnessCommand : public test::ProgramInFolder {
 protected:
  StiffnessCommand() : ProgramInFolder("stiffness") {}
  void SetUp() override {
    specimen::write_specimen("half.h5", layers(6));
    specimen::write_specimen("mortar.h5", layers(0));
  }
  json told(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-q"});
    EXPECT_EQ(run(arguments), Exit::ok) << err_.str();
    EXPECT_EQ(err_.str(), "");
    return json::parse(out_.str());
  }
};

TEST_F(StiffnessCommand, TellsLayersAlongAndAcross) {
  const json half = told({"half.h5", "--cell", "pixel", "--mortar.poisson", "0", "--aggregate.poisson", "0"})
                        .at("specimens")
                        .at(0);
  EXPECT_EQ(half["name"], "half.h5");
  EXPECT_EQ(half["cell"], "pixel");
  EXPECT_EQ(half["plane"], "strain");
  EXPECT_EQ(half["phases"]["mortar"]["fraction"], 0.5);
  const json& tensor = half["periodic"]["stiffness_Pa"];
  EXPECT_NEAR(tensor[0][0].get<double>(), 30e9, 30e3);
  EXPECT_NEAR(tensor[1][1].get<double>(), 80e9 / 3, 27e3);
  EXPECT_NEAR(half["bounds"]["voigt"]["young_Pa"].get<double>(), 30e9, 1);
  EXPECT_NEAR(half["bounds"]["reuss"]["young_Pa"].get<double>(), 80e9 / 3, 1);
  EXPECT_GT(half["periodic"]["anisotropy"].get<double>(), 0.01);
  for (const char* boundary : {"uniform_stress", "periodic", "uniform_strain"})
    EXPECT_TRUE(half[boundary]["solved"].get<bool>());
}

TEST_F(StiffnessCommand, WarnsOfAPictureThatIsNoConcrete) {
  specimen::Specimen from_picture = layers(0);
  from_picture.provenance.source = "photo.png";
  specimen::write_specimen("photo.h5", from_picture);
  ASSERT_EQ(run({"photo.h5", "--json", "-q"}), Exit::ok) << err_.str();
  EXPECT_THAT(err_.str(), HasSubstr("warning: there is no aggregate"));
  EXPECT_THAT(json::parse(out_.str())["specimens"][0]["warnings"].dump(), HasSubstr("there is no aggregate"));
}

TEST_F(StiffnessCommand, GivesThePhasesBackInBothPlanes) {
  for (const char* plane : {"strain", "stress"})
    for (const char* cell : {"pixel", "3 x 3"}) {
      const json mortar = told({"mortar.h5", "--plane", plane, "--cell", cell, "--mortar.young", "25 GPa"})
                              .at("specimens")
                              .at(0);
      EXPECT_EQ(mortar["plane"], plane);
      EXPECT_NEAR(mortar["uniform_stress"]["young_Pa"].get<double>(), 25e9, 250);
      EXPECT_NEAR(mortar["uniform_strain"]["poisson"].get<double>(), 0.2, 1e-8);
    }
}

TEST_F(StiffnessCommand, PrintsATable) {
  ASSERT_EQ(run({"mortar.h5", "--cell", "2 x 2"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "");
  EXPECT_THAT(out_.str(), HasSubstr("mortar.h5: 12 x 12 pixels of 1 mm, plane strain, cells of 2 x 2 pixels\n"
                                    "  mortar 100.0 % (E 20 GPa, nu 0.2)\n"));
  EXPECT_THAT(out_.str(),
              HasSubstr("\n  stiffness (GPa)           uniform stress        periodic  uniform strain\n"
                        "  C xx xx                           22.222          22.222          22.222\n"));
  EXPECT_THAT(out_.str(),
              HasSubstr("\n  E (GPa)                           20.000          20.000          20.000\n"));
  EXPECT_THAT(out_.str(),
              HasSubstr("\n  Voigt                             20.000          13.889           8.333\n"));
}

TEST_F(StiffnessCommand, SeveralSpecimensHaveARowEachAndTheirSpread) {
  ASSERT_EQ(run({"mortar.h5", "half.h5", "-o", "both.json"}), Exit::ok) << err_.str();
  EXPECT_EQ(err_.str(), "wrote both.json\n");
  EXPECT_THAT(out_.str(), HasSubstr("\n  mortar.h5                       20.000          20.000"));
  EXPECT_THAT(out_.str(), HasSubstr("\n  half.h5 "));
  EXPECT_THAT(out_.str(), HasSubstr("\n  standard deviation "));
  const json both = json::parse(app::read_text_file("both.json"));
  const double first = both["specimens"][0]["periodic"]["young_Pa"];
  const double second = both["specimens"][1]["periodic"]["young_Pa"];
  EXPECT_NEAR(both["spread"]["periodic"]["young_Pa"]["mean"].get<double>(), 0.5 * (first + second), 1);
  EXPECT_NEAR(both["spread"]["periodic"]["young_Pa"]["standard_deviation"].get<double>(),
              std::abs(first - second) / std::sqrt(2.0), 1);
}

TEST_F(StiffnessCommand, SaysWhereNothingCanPull) {
  specimen::write_specimen("open.h5", layers(6, 2));
  ASSERT_EQ(run({"open.h5"}), Exit::ok) << err_.str();
  EXPECT_EQ(
      err_.str(),
      "note: open.h5: nothing can pull at the void along its edges, so under uniform stress its stiffness "
      "is 0 in xx, yy and xy\n");
  const json open = told({"open.h5"}).at("specimens").at(0);
  EXPECT_THAT(open["uniform_stress"]["carried"], ElementsAre(false, false, false));
  EXPECT_EQ(open["uniform_stress"]["young_Pa"], 0);
  EXPECT_EQ(open["bounds"]["hashin_shtrikman_lower"]["young_Pa"], 0);
  EXPECT_GT(open["periodic"]["stiffness_Pa"][0][0].get<double>(), 20e9);
}

TEST_F(StiffnessCommand, TakesAScene) {
  test::write_text("scene.toml",
                   "[specimen]\nfile = \"half.h5\"\n[solver]\nplane = \"stress\"\ncell = \"pixel\"\n"
                   "[phases.mortar]\nyoung = \"30 GPa\"\ntensile_scale = \"3 MPa\"\n");
  const json scene = told({"scene.toml"}).at("specimens").at(0);
  EXPECT_EQ(scene["plane"], "stress");
  EXPECT_EQ(scene["phases"]["mortar"]["young_Pa"], 30e9);
  EXPECT_NEAR(scene["bounds"]["voigt"]["shear_Pa"].get<double>(), 35e9 / 2.4, 1);
}

TEST_F(StiffnessCommand, RefusesWhatHasNoEffectOrNoStiffness) {
  expect_refusal({}, "INPUT: missing; mesopix stiffness INPUT");
  expect_refusal({"half.h5", "-o", "half.txt"}, "-o: half.txt; must end in .json");
  expect_refusal({"half.h5", "--mortar.tensile-scale", "3 MPa"},
                 "--mortar.tensile-scale: has no effect on the stiffness; remove it");
  EXPECT_EQ(run({"half.h5", "--velocity", "1 m/s"}), Exit::usage);
  EXPECT_EQ(run({"half.h5", "--cfl", "0.5"}), Exit::usage);
  EXPECT_EQ(run({"none.h5"}), Exit::io);
  test::write_text(
      "points.toml",
      "[generate]\nwidth = \"20 mm\"\nheight = \"20 mm\"\npixel_size = \"1 mm\"\nfraction = 0.3\n"
      "d_min = \"4 mm\"\nd_max = \"6 mm\"\n[itz]\nmode = \"points\"\n");
  expect_refusal({"points.toml"}, Exit::data,
                 "points.toml:9:8: itz.mode: points; the stiffness of a specimen needs the ITZ as pixels; "
                 "choose itz.mode ring");
}

}  // namespace stiffness_command_test
