#include "apps/bench/problem_table.hpp"

#include <fmt/format.h>
#include <cmath>
#include <utility>

#include "libmpm/problems/flights.hpp"
#include "libmpm/problems/plate.hpp"
#include "libmpm/problems/waves.hpp"

namespace app::bench {
namespace {

namespace known = mpm::problems;
using mpm::Precision;
using mpm::Scheme;
using mpm::Shape;
using mpm::Transfer;

Measured measured(double error, const known::Cost& cost, std::string trouble) {
  return {error, cost.wall_time, cost.point_updates, std::move(trouble)};
}

/// A method of moving points and its Courant number.
struct Recipe {
  known::Method method;
  double cfl = 0.5;

  [[nodiscard]] std::string name() const {
    return method.name() + (cfl == 0.5 ? "" : fmt::format(" CFL {}", cfl));
  }
};

/// Shapes, schemes, transfers, precision and the step, each varied alone from GIMP MUSL FLIP.
std::vector<Recipe> recipes(bool with_usf = true) {
  std::vector<Recipe> all{{{Shape::gimp}}, {{Shape::linear}}, {{Shape::bspline}}};
  if (with_usf) all.push_back({{Shape::gimp, Scheme::usf}});
  all.push_back({{Shape::gimp, Scheme::usl}});
  all.push_back({{Shape::gimp, Scheme::musl, Transfer::apic}});
  all.push_back({{Shape::bspline, Scheme::musl, Transfer::apic}});
  all.push_back({{Shape::gimp, Scheme::musl, Transfer::flip, 0}});
  all.push_back({{Shape::gimp, Scheme::musl, Transfer::flip, 1, Precision::single}});
  all.push_back({{Shape::gimp}, 0.25});
  return all;
}

/// @param solve  a way and a number of cells into what was measured.
template <class Solve>
std::vector<Method> over_cells(const std::vector<Recipe>& recipes, const std::vector<int>& cells,
                               const Solve& solve) {
  std::vector<Method> methods;
  for (const Recipe& way : recipes) {
    Method method{way.name(), "cell", "", {}, {}};
    for (const int n : cells) {
      method.sizes.push_back(1.0 / n);
      method.runs.emplace_back([=] { return solve(way, n); });
    }
    methods.push_back(std::move(method));
  }
  return methods;
}

/// How a plate is pulled.
struct PlateWay {
  std::string name;
  mpm::Kinematics kinematics = mpm::Kinematics::small_strain;
  Shape shape = Shape::gimp;
  Precision precision = Precision::double_;
  double cfl = 0.5;
  bool pixel_cells = false;
  mpm::SolverMethod solver = mpm::SolverMethod::explicit_;

  [[nodiscard]] bool is_still() const { return solver == mpm::SolverMethod::quasi_static; }
};

std::vector<PlateWay> plate_ways() {
  using mpm::Kinematics;
  using mpm::SolverMethod;
  return {{"small strain"},
          {"small strain single", Kinematics::small_strain, Shape::gimp, Precision::single},
          {"small strain CFL 0.9", Kinematics::small_strain, Shape::gimp, Precision::double_, 0.9},
          {"pixel cells", Kinematics::small_strain, Shape::gimp, Precision::double_, 0.5, true},
          {.name = "quasi-static", .solver = SolverMethod::quasi_static},
          {.name = "quasi-static pixel cells", .pixel_cells = true, .solver = SolverMethod::quasi_static},
          {"moving linear", Kinematics::moving, Shape::linear},
          {"moving GIMP", Kinematics::moving, Shape::gimp},
          {"moving B-spline", Kinematics::moving, Shape::bspline}};
}

/// Pixels across a plate that each kind of run can afford.
struct PlateSizes {
  std::vector<int> lattice, still, moving;

  [[nodiscard]] const std::vector<int>& of(const PlateWay& way) const {
    if (way.is_still()) return still;
    return way.kinematics == mpm::Kinematics::moving ? moving : lattice;
  }
};

/// @param scene_of  a scene for a way and a number of pixels; @param error_of  its error from the way, the
/// number of pixels and the plate that was pulled.
template <class SceneOf, class ErrorOf>
std::vector<Method> over_pixels(const PlateSizes& sizes, const SceneOf& scene_of, const ErrorOf& error_of) {
  std::vector<Method> methods;
  for (const PlateWay& way : plate_ways()) {
    Method method{way.name, "pixel", "", {}, {}};
    for (const int pixels : sizes.of(way)) {
      method.sizes.push_back(1.0 / pixels);
      method.runs.emplace_back([=] {
        mpm::Scene scene = scene_of(way, pixels);
        scene.threads = 1;
        scene.pixel_cells = way.pixel_cells;
        scene.points_per_cell = way.pixel_cells ? 1 : 2;
        scene.kinematics = way.kinematics;
        scene.motion.shape = way.shape;
        scene.precision = way.precision;
        scene.cfl = way.cfl;
        scene.method = way.solver;
        const known::StaticPlate plate = known::pull(scene);
        return measured(error_of(way, pixels, plate), plate.cost, plate.trouble);
      });
    }
    methods.push_back(std::move(method));
  }
  return methods;
}

/// Of disc and hole, in widths of the plate. A plate of twenty radii adds up to 0.5 %; without waves twice as
/// wide a one costs little.
double radius_for(const PlateWay& way) { return way.is_still() ? 0.025 : 0.05; }

}  // namespace

Problem bar_problem() {
  const std::vector<int> sizes{8, 16, 32, 64};
  Problem problem{"bar",
                  "Axial vibration of a bar over ten periods",
                  "distance from the solution in the plane of displacement and velocity, over the amplitude",
                  "v = v₀ sin(πx / 2L) cos ωt",
                  "Phase error and dissipation together: a bar that lags or fades away is off by up to 1.",
                  {},
                  over_cells(recipes(), sizes, [](const Recipe& way, int cells) {
                    const known::Vibration it = known::vibrate_bar(way.method, cells, way.cfl);
                    return measured(it.error, it.cost, it.trouble);
                  })};
  Method pixels{"pixel cells", "cell", "", {}, {}};
  for (const int cells : sizes) {
    pixels.sizes.push_back(1.0 / cells);
    pixels.runs.emplace_back([cells] {
      const known::Vibration it = known::vibrate_bar_of_pixels(cells);
      return measured(it.error, it.cost, it.trouble);
    });
  }
  problem.methods.push_back(std::move(pixels));
  return problem;
}

Problem manufactured_problem() {
  std::vector<Recipe> ways = recipes(false);
  ways.back() = {{Shape::gimp}, 0.4};
  return {
      "manufactured",
      "Large deformation of a square, made up beforehand",
      "root of the mean square of the displacement's error, the largest in time, over its amplitude",
      "u = A sin 2πX sin cπt with the body force that it needs, A = 0.05 of the width",
      "Points cross up to six cells: linear functions stop to converge, GIMP and B-splines go on. FLIP keeps "
      "the noise that points make as they cross, and MUSL amplifies it, the more the longer the step: at "
      "CFL 0.4 GIMP MUSL FLIP diverges from 1/64 on, so that the step is half as long here. APIC damps "
      "the noise, and converges at either step. USF is left out, because the body force comes as a kick "
      "before the step.",
      {},
      over_cells(ways, {8, 16, 32, 64}, [](const Recipe& way, int cells) {
        const double cfl = way.cfl == 0.5 ? 0.2 : way.cfl;
        const known::Deformation it = known::deform_as_made_up(way.method, cells, 0.05, cfl);
        return measured(it.error, it.cost, it.trouble);
      })};
}

Problem inclusion_problem() {
  return {
      "inclusion",
      "A disc twice as stiff in a plate, drawn as pixels",
      "root of the mean square of the stress error within half the radius, over the stress of the plate",
      "Goodier (1933): the stress inside is uniform",
      "The stair-shaped boundary, against the pixel. The plate is twenty radii wide, which leaves 0.1 to 0.2 "
      "%; without waves it is forty, and what remains is the stair.",
      {},
      over_pixels(
          {{80, 160, 320}, {80, 160, 320, 640}, {80, 160}},
          [](const PlateWay& way, int pixels) {
            mpm::Scene scene = known::plate(pixels);
            known::draw_disc(scene, radius_for(way), 2);
            scene.local_damping = 0.3;
            return scene;
          },
          [](const PlateWay& way, int, const known::StaticPlate& plate) {
            return known::inclusion_errors(plate, radius_for(way)).inner;
          })};
}

Problem hole_problem() {
  return {
      "hole",
      "A round hole in a plate, drawn as pixels",
      "root of the mean square of the stress error beside the hole, from 1.25 to 3 radii, over the stress of "
      "the plate",
      "Kirsch (1898): three times the stress at the edge",
      "Stress concentration from pixels. The plate is twenty radii wide, which leaves 0.5 %; without waves "
      "it is forty. The stair along the edge has another pattern at each size, so that the error beside it "
      "need not fall from one to the "
      "next.",
      {},
      over_pixels(
          {{80, 160, 320}, {80, 160, 320, 640}, {80, 160}},
          [](const PlateWay& way, int pixels) {
            mpm::Scene scene = known::plate(pixels);
            known::draw_disc(scene, radius_for(way), 0);
            return scene;
          },
          [](const PlateWay& way, int pixels, const known::StaticPlate& plate) {
            return known::hole_error(plate, radius_for(way), 1.0 / pixels);
          })};
}

Problem layers_problem() {
  return {"layers",
          "A strip of two layers, pulled across them",
          "error of the modulus",
          "Reuss: the layers in series",
          "Interfaces on the edges of cells are exact at any size: what remains is the waves of the loading, "
          "which no "
          "pixel changes, and with B-splines the smoothing over the interface.",
          {},
          over_pixels(
              {{16, 32, 64, 128}, {16, 32, 64, 128}, {16, 32, 64}},
              [](const PlateWay&, int pixels) { return known::layered_plate(pixels, known::Layers::across); },
              [](const PlateWay&, int, const known::StaticPlate& plate) {
                return plate.modulus / known::layered_modulus(known::Layers::across) - 1;
              })};
}

Problem flight_problem() {
  return {"flight",
          "Constant strain: none, on irregular points that cross cells",
          "largest sum of a point's stresses, over Young's modulus",
          "nothing may be strained in uniform flight",
          "The patch test: rounding alone, so that it grows with the number of steps.",
          {},
          over_cells(recipes(), {6, 12, 24}, [](const Recipe& way, int cells) {
            known::Patch it = known::fly_uniformly(way.method, cells, 25 * cells);
            return measured(it.stress, it.cost, it.trouble);
          })};
}

Problem spin_problem() {
  return {"spin",
          "A disc in free flight that turns by 1.2 rad",
          "share of its angular momentum that is lost",
          "angular momentum stays",
          "APIC keeps it, to rounding with B-splines; FLIP loses it with the square of the cell, PIC in each "
          "step.",
          {},
          over_cells(recipes(), {8, 16, 32, 64}, [](const Recipe& way, int cells) {
            const known::Flight it = known::fly(way.method, cells, way.cfl);
            return measured(it.lost_spin, it.cost, it.trouble);
          })};
}

Problem collision_problem() {
  return {"collision",
          "Two elastic discs that meet and part",
          "share of the energy that is lost or made by the end",
          "total energy stays",
          "Contact through the grid, and what crossing cells does to the energy.",
          {},
          over_cells(recipes(), {20, 40, 80}, [](const Recipe& way, int cells) {
            const known::Collision it = known::collide(way.method, cells, way.cfl);
            return measured(it.kept_energy - 1, it.cost, it.trouble);
          })};
}

}  // namespace app::bench
