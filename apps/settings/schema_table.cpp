// The one table of settings: each key with its codec and its help. A default is the initialiser of the
// member.
#include "apps/settings/schema.hpp"

#include <numbers>

#include "apps/settings/linked_fields.hpp"
#include "specimen/pack/grading.hpp"

namespace app {
namespace {

/// The member of a settings object, const or not.
#define MEMBER(path) ([](auto& object) -> auto& { return object.path; })

template <class Codec, class Access>
Field field(const char* key, Codec codec, const char* help, Access access) {
  return make_field<Settings>(key, help, std::move(codec), access);
}

template <class Codec, class Access>
PhaseField property(const char* key, Codec codec, const char* help, Access access) {
  return make_field<mpm::Phase>(key, help, std::move(codec), access);
}

QuantityCodec ratio(Bounds bounds) { return {Dimension::ratio, bounds}; }
QuantityCodec length(Bounds bounds) { return {Dimension::length, bounds}; }

/// Lengths of which 0 means that the program finds it out.
QuantityCodec length_or_auto() { return {Dimension::length, above(0), Word{"auto", 0}}; }

/// Numbers of pixels of which -1 means that the conversion chooses.
IntegerCodec<> pixels_or_auto() { return {between(0, 1000), Word{"auto", -1}}; }

QuantityCodec strength() {
  return {Dimension::pressure, above(0), Word{"unbreakable", mpm::Phase::unbreakable}};
}

std::vector<Field> specimen_fields() {
  return {
      field("specimen.file", PathCodec{{"h5"}}, "specimen.h5 that generate or convert wrote",
            MEMBER(specimen.file)),
      field("specimen.picture", PathCodec{picture_endings()}, "picture to convert", MEMBER(specimen.picture)),
      field("specimen.ellipses", PathCodec{{"csv"}},
            "CSV list of ellipses with columns like x_mm, y_mm, a_mm, b_mm, angle_deg",
            MEMBER(specimen.ellipses)),
      field("specimen.sha256", TextCodec{}, "expected SHA-256 of that file; another one is refused",
            MEMBER(specimen.sha256)),
  };
}

std::vector<Field> generate_fields() {
  return {
      field("generate.width", length(above(0)), "of the specimen", MEMBER(packing.width)),
      field("generate.height", length(above(0)), "of the specimen", MEMBER(packing.height)),
      field("generate.pixel_size", length(above(0)), "edge of a pixel, which is one material point",
            MEMBER(pixel_size)),
      field("generate.fraction", ratio(below(0, 1)), "area of the aggregates over that of the specimen",
            MEMBER(packing.fraction)),
      field("generate.grading", WordCodec{specimen::grading_names()}, "sieve curve of the aggregates",
            MEMBER(grading.name)),
      field("generate.d_min", length(above(0)), "smallest aggregate", MEMBER(grading.d_min)),
      field("generate.d_max", length(above(0)), "largest aggregate", MEMBER(grading.d_max)),
      field("generate.walraven", BooleanCodec{}, "turn the volume curve into area shares of a plane cut",
            MEMBER(grading.walraven)),
      field("generate.classes", SizeClassesCodec{},
            "size classes in place of a sieve curve, \"5 mm .. 10 mm: 40 %\"", MEMBER(grading.classes)),
      field("generate.aspect_min", ratio(up_to(0, 1)), "least short over long axis",
            MEMBER(packing.aspect_min)),
      field("generate.aspect_max", ratio(up_to(0, 1)), "largest short over long axis",
            MEMBER(packing.aspect_max)),
      field("generate.gap", length(at_least(0)), "least distance between aggregates and to the edges",
            MEMBER(packing.gap)),
      field("generate.seed", IntegerCodec<std::uint64_t>{at_least(0)}, "of the random aggregates",
            MEMBER(packing.seed)),
  };
}

ChoiceCodec<specimen::Segmentation> segmentation() {
  using specimen::Segmentation;
  return {{{"automatic", Segmentation::automatic},
           {"labels", Segmentation::labels},
           {"instances", Segmentation::instances},
           {"threshold", Segmentation::threshold},
           {"otsu", Segmentation::otsu},
           {"multi_otsu", Segmentation::multi_otsu},
           {"kmeans", Segmentation::kmeans},
           {"taught", Segmentation::taught}}};
}

ChoiceCodec<specimen::Outside> outside() {
  using specimen::Outside;
  return {{{"auto", Outside::automatic}, {"void", Outside::void_}, {"none", Outside::none}}};
}

WordCodec channel() {
  return {{"gray", "red", "green", "blue", "hue", "saturation", "value", "l", "a", "b"}};
}

std::vector<Field> segmentation_fields() {
  return {
      field("convert.method", segmentation(), "how phases are told apart", MEMBER(convert.method)),
      field("convert.channel", channel(), "that thresholds look at", MEMBER(convert.channel)),
      field("convert.thresholds", NumbersCodec{}, "rising grey levels, for method threshold",
            MEMBER(convert.thresholds)),
      field("convert.classes", IntegerCodec<>{between(2, 16), Word{"auto", 0}},
            "number of classes, for multi_otsu and kmeans", MEMBER(convert.classes)),
      field("convert.class_phases", TextsCodec{}, "phases of the classes, darkest first; empty = guessed",
            MEMBER(convert.class_phases)),
      field("convert.label_phases", LabelNamesCodec{},
            "phases of the values of a label picture, e.g. 0:void,1:mortar", MEMBER(convert.label_phases)),
  };
}

std::vector<Field> teaching_fields() {
  return {
      field(
          "convert.strokes", PathCodec{{"png", "tif", "tiff"}},
          "picture of strokes in the colours of the phases, transparent elsewhere, that teach method taught",
          MEMBER(convert.strokes)),
      field("convert.model", PathCodec{{"mesomodel"}}, "what strokes taught before, in place of strokes",
            MEMBER(convert.model)),
      field("convert.even_light", BooleanCodec{}, "even out light that changes slowly, for method taught",
            MEMBER(convert.even_light)),
      field("convert.smooth", pixels_or_auto(),
            "radius in pixels of the smoothing along edges, for method taught; 0 = none",
            MEMBER(convert.smooth)),
  };
}

std::vector<Field> scale_fields() {
  return {
      field("convert.pixel_size", length_or_auto(), "of the picture; auto = as its file says",
            MEMBER(convert.source_pixel_size)),
      field("convert.width", length_or_auto(), "of the cropped picture, the other way to give the scale",
            MEMBER(convert.width)),
      field("convert.crop", RectangleCodec{}, "pixels of the picture to keep; empty = all",
            MEMBER(convert.crop)),
      field(
          "convert.outside", outside(),
          "what lies outside of a round or tilted specimen: auto, void = all that reaches the corners, none",
          MEMBER(convert.outside)),
      field("convert.max_pixels", IntegerCodec<std::int64_t>{between(1, 2'000'000'000)},
            "of the picture; a larger one is refused before it is decoded", MEMBER(convert.max_pixels)),
      field("convert.pixels", IntegerCodec<>{between(1, 100000), Word{"auto", 0}},
            "columns of the specimen; auto = as the picture", MEMBER(convert.pixels)),
  };
}

std::vector<Field> cleaning_fields() {
  return {
      field("convert.median", pixels_or_auto(), "edge of the median filter in pixels, odd; 0 = none",
            MEMBER(convert.median)),
      field("convert.open", pixels_or_auto(), "radius in pixels of the opening of aggregates; 0 = none",
            MEMBER(convert.open)),
      field("convert.close", pixels_or_auto(), "radius in pixels of the closing of aggregates; 0 = none",
            MEMBER(convert.close)),
      field("convert.drop_islands", QuantityCodec{Dimension::area, at_least(0), Word{"auto", -1}},
            "islands of less area join their surroundings", MEMBER(convert.drop_islands)),
      field("convert.fill_holes", BooleanCodec{}, "of aggregates", MEMBER(convert.fill_holes)),
      field("convert.split_touching", BooleanCodec{}, "cut aggregates that touch at their necks",
            MEMBER(convert.split_touching)),
      field("convert.split_depth", ratio(inside(0, 1)), "depth of a neck over the inner radius of the grain",
            MEMBER(convert.split_depth)),
  };
}

std::vector<Field> itz_fields() {
  using specimen::ItzMode;
  const ChoiceCodec<ItzMode> mode{
      {{"ring", ItzMode::ring}, {"points", ItzMode::points}, {"none", ItzMode::none}}};
  return {
      field("itz.mode", mode, "ITZ as pixels, as extra material points, or none", MEMBER(itz.mode)),
      field("itz.thickness", length_or_auto(), "of the ring; auto = one pixel", MEMBER(itz.thickness)),
      field("itz.segments", IntegerCodec<>{between(3, 10000), Word{"auto", 0}},
            "corners of a ring; auto = 36, and as many as follow the outline of an aggregate of a picture",
            MEMBER(itz.segments)),
  };
}

std::vector<Field> loading_fields() {
  using mpm::Direction;
  using mpm::Platen;
  const ChoiceCodec<Direction> direction{
      {{"tension", Direction::tension}, {"compression", Direction::compression}, {"none", Direction::none}}};
  const ChoiceCodec<Platen> platen{{{"smooth", Platen::smooth}, {"rough", Platen::rough}}};
  const ChoiceCodec<mpm::LoadingPath> path{
      {{"strain", mpm::LoadingPath::strain}, {"snap_back", mpm::LoadingPath::snap_back}}};
  return {
      field("loading.direction", direction, "way of the top platen; none = no platens, the specimen flies",
            MEMBER(scene.loading.direction)),
      field("loading.velocity", QuantityCodec{Dimension::velocity, above(0)}, "of the top platen",
            MEMBER(scene.loading.velocity)),
      field("loading.ramp_time", QuantityCodec{Dimension::time, at_least(0), Word{"auto", -1}},
            "from rest to full velocity; auto = two transits of the slowest wave, sideways too",
            MEMBER(scene.loading.ramp_time)),
      field("loading.platen", platen, "smooth lets the specimen slide sideways, rough holds it",
            MEMBER(scene.loading.platen)),
      field("loading.separation", BooleanCodec{}, "let the specimen part from the platens that press it",
            MEMBER(scene.loading.separation)),
      field(
          "loading.path", path,
          "quasi_static: strain = platens never go back; snap_back = back to the strain of the next failure",
          MEMBER(scene.loading.path)),
      field("loading.stop_strain", ratio(inside(0, 1)),
            "strain at which the run ends; larger in compression or with stop_drop, unless given",
            MEMBER(scene.loading.stop_strain)),
      field("loading.stop_displacement", OptionalQuantityCodec{length(above(0)), "none"},
            "of the leading load or the platen at which the run ends, in place of a strain",
            MEMBER(stop_displacement)),
      field("loading.thickness", length(above(0)), "of the specimen, for forces in newtons",
            MEMBER(scene.fixture.thickness)),
      field("loading.stop_drop", OptionalQuantityCodec{ratio(inside(0, 1)), "none"},
            "ends the run below this share of the peak stress", MEMBER(scene.loading.stop_drop)),
  };
}

std::vector<Field> flight_fields() {
  const QuantityCodec velocity{Dimension::velocity};
  return {
      field("loading.initial_velocity_x", velocity, "of the flying specimen, to the right",
            MEMBER(scene.loading.initial_velocity_x)),
      field("loading.initial_velocity_y", velocity, "of the flying specimen, upwards",
            MEMBER(scene.loading.initial_velocity_y)),
      field("loading.duration", QuantityCodec{Dimension::time, above(0), Word{"none", 0}},
            "of a run without platens", MEMBER(scene.loading.duration)),
  };
}

std::vector<Field> damage_fields() {
  using mpm::CrackClosure;
  const ChoiceCodec<CrackClosure> closure{{{"off", CrackClosure::off},
                                           {"clipped", CrackClosure::clipped},
                                           {"unilateral", CrackClosure::unilateral}}};
  return {
      field("damage.seed", IntegerCodec<std::uint64_t>{at_least(0)}, "of the random strengths",
            MEMBER(scene.damage.seed)),
      field("damage.crack_closure", closure,
            "compression across a crack: off = none, clipped = tension cut off, unilateral = the same, "
            "energy kept",
            MEMBER(scene.damage.crack_closure)),
      field("damage.residual_stiffness", ratio(below(0, 1)),
            "share of the stiffness that a failed point keeps", MEMBER(scene.damage.residual_stiffness)),
      field("damage.correlation_length", QuantityCodec{Dimension::length, above(0), Word{"none", 0}},
            "of the random strengths, the same field for any pixel size; none = every point on its own",
            MEMBER(scene.damage.correlation_length)),
  };
}

std::vector<Field> solver_fields() {
  using mpm::Plane;
  using mpm::Precision;
  const ChoiceCodec<Plane> plane{{{"strain", Plane::strain}, {"stress", Plane::stress}}};
  const ChoiceCodec<std::string> instruction_set{
      {{"auto", ""}, {"avx512", "avx512"}, {"avx2", "avx2"}, {"baseline", "baseline"}}};
  const ChoiceCodec<Precision> precision{{{"double", Precision::double_}, {"single", Precision::single}}};
  const ChoiceCodec<mpm::SolverMethod> method{
      {{"explicit", mpm::SolverMethod::explicit_}, {"quasi_static", mpm::SolverMethod::quasi_static}}};
  return {
      field(
          "solver.method", method,
          "explicit = motion in small time steps; quasi_static = equilibrium at every strain, without waves",
          MEMBER(scene.method)),
      field("solver.event_tolerance", ratio(below(0, 1)),
            "quasi_static: failures within this share of strain happen at once; 0 = one at a time",
            MEMBER(scene.event_tolerance)),
      kinematics_field(),
      field("solver.plane", plane, "plane strain or plane stress", MEMBER(scene.plane)),
      cell_field(),
      field("solver.cfl", ratio(up_to(0, 1)), "time step over the time a wave needs to cross a cell",
            MEMBER(scene.cfl)),
      damping_field(),
      field("solver.precision", precision, "of stresses; of all numbers of moving points",
            MEMBER(scene.precision)),
      field("solver.instruction_set", instruction_set,
            "of the sweeps; auto = the fastest that the processor has", MEMBER(scene.instruction_set)),
      field("solver.threads", IntegerCodec<>{between(1, 1024), Word{"auto", 0}},
            "does not change the result; auto = as many as have work and an idle core",
            MEMBER(scene.threads)),
  };
}

std::vector<Field> motion_fields() {
  using mpm::Scheme;
  using mpm::Shape;
  using mpm::Transfer;
  const ChoiceCodec<Shape> shape{
      {{"linear", Shape::linear}, {"gimp", Shape::gimp}, {"bspline", Shape::bspline}}};
  const ChoiceCodec<Scheme> scheme{{{"usf", Scheme::usf}, {"usl", Scheme::usl}, {"musl", Scheme::musl}}};
  const ChoiceCodec<Transfer> transfer{{{"flip", Transfer::flip}, {"apic", Transfer::apic}}};
  return {
      field("motion.shape", shape, "functions between points and nodes: tents, GIMP, or quadratic B-splines",
            MEMBER(scene.motion.shape)),
      field("motion.scheme", scheme,
            "stress follows the nodes first in a step, last, or last from the new velocity mapped back",
            MEMBER(scene.motion.scheme)),
      field("motion.transfer", transfer, "nodes give points a change of velocity, or velocity and gradient",
            MEMBER(scene.motion.transfer)),
      field("motion.flip_ratio", ratio(between(0, 1)), "1 = FLIP, keeps energy; 0 = PIC, damps",
            MEMBER(scene.motion.flip_ratio)),
      field("motion.margin", QuantityCodec{Dimension::length, at_least(0), Word{"auto", -1}},
            "of the grid beyond closed and open edges; auto = a quarter of the width",
            MEMBER(scene.motion.margin)),
      field("motion.deformation_gradient", BooleanCodec{}, "keep that of every point at the end in result.h5",
            MEMBER(scene.motion.deformation_gradient)),
  };
}

std::vector<Field> edge_fields() {
  using mpm::Edge;
  const ChoiceCodec<Edge> edge{{{"closed", Edge::closed},
                                {"open", Edge::open},
                                {"symmetry", Edge::symmetry},
                                {"smooth_wall", Edge::smooth_wall},
                                {"rough_wall", Edge::rough_wall}}};
  return {
      field("motion.left", edge, "edge: points must not leave, may leave, or meet a plane or a wall there",
            MEMBER(scene.motion.left)),
      field("motion.right", edge, "the same at the right", MEMBER(scene.motion.right)),
      field("motion.bottom", edge, "the same at the bottom, without platens", MEMBER(scene.motion.bottom)),
      field("motion.top", edge, "the same at the top, without platens", MEMBER(scene.motion.top)),
  };
}

std::vector<Field> handover_fields() {
  return {
      field("handover.strain", ratio(above(0)), "strain of a live point from which on points move",
            MEMBER(scene.handover.strain)),
      field("handover.displacement", ratio(above(0)),
            "of a node from the mean motion, in cells, from which on points move",
            MEMBER(scene.handover.displacement)),
  };
}

std::vector<Field> output_fields() {
  return {
      field("output.title", TextCodec{}, "of the report", MEMBER(title)),
      field("output.history_rows", IntegerCodec<>{between(10, 1'000'000)}, "rows of the stress-strain curve",
            MEMBER(scene.history_rows)),
      field("output.frames", IntegerCodec<>{between(0, 100'000)},
            "states of all points for ParaView and plot --what stress, even in strain, closer before a peak "
            "far below "
            "stop_strain; 0 = none",
            MEMBER(scene.frames)),
  };
}

std::vector<PhaseField> properties() {
  using mpm::SofteningCurve;
  const QuantityCodec angle{Dimension::angle, below(0, std::numbers::pi / 2)};
  const ChoiceCodec<SofteningCurve> curve{{{"exponential", SofteningCurve::exponential},
                                           {"bilinear", SofteningCurve::bilinear},
                                           {"hordijk", SofteningCurve::hordijk}}};
  return {
      property("young", QuantityCodec{Dimension::pressure, above(0)}, "Young's modulus", &mpm::Phase::young),
      property("poisson", ratio(between(0, 0.5)), "Poisson's ratio", &mpm::Phase::poisson),
      property("density", QuantityCodec{Dimension::density, above(0)}, "mass density", &mpm::Phase::density),
      property("tensile_scale", strength(),
               "Weibull scale of the tensile strength: 63.2 % of the points have less",
               &mpm::Phase::tensile_scale),
      property("cohesion", strength(), "Mohr-Coulomb cohesion", &mpm::Phase::cohesion),
      property("friction_angle", angle, "Mohr-Coulomb friction angle", &mpm::Phase::friction_angle),
      property("weibull_modulus", ratio(above(0)), "scatter of the strengths: small = much",
               &mpm::Phase::weibull_modulus),
      property("fracture_energy", QuantityCodec{Dimension::energy, above(0), Word{"brittle", 0}},
               "of a crack, spent as it opens; brittle = points crack at one blow",
               &mpm::Phase::fracture_energy),
      property(
          "softening", curve,
          "of a crack with a fracture_energy: as an exponential, in two lines (Petersson), or as Hordijk "
          "measured it",
          &mpm::Phase::softening),
      property("shear_fracture_energy", QuantityCodec{Dimension::energy, above(0), Word{"brittle", 0}},
               "of a shear band, spent as it slips; needs damage.crack_closure",
               &mpm::Phase::shear_fracture_energy),
  };
}

#undef MEMBER

}  // namespace

const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"specimen", "Specimen", ""},    {"generate", "Random aggregates", ""},
      {"convert", "Picture", ""},      {"itz", "ITZ rings", "itz-"},
      {"phases", "Phases", ""},        {"loading", "Loading", ""},
      {"damage", "Damage", ""},        {"solver", "Solver", ""},
      {"motion", "Moving points", ""}, {"handover", "From small strain to moving points", "handover-"},
      {"output", "Output", ""},
  };
  return all;
}

const std::vector<Field>& fields() {
  static const std::vector<Field> all = [] {
    std::vector<Field> table;
    for (auto* part :
         {&specimen_fields, &generate_fields, &segmentation_fields, &teaching_fields, &scale_fields,
          &cleaning_fields, &itz_fields, &loading_fields, &flight_fields, &damage_fields, &solver_fields,
          &motion_fields, &edge_fields, &handover_fields, &output_fields})
      for (Field& one : part()) table.push_back(std::move(one));
    return table;
  }();
  return all;
}

const std::vector<Field>& former_fields() {
  static const std::vector<Field> all(1, points_per_cell_field());
  return all;
}

const std::vector<PhaseField>& phase_fields() {
  static const std::vector<PhaseField> all = properties();
  return all;
}

}  // namespace app
