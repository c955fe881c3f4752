#include "apps/job/job.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <utility>
#include <vector>

#include "apps/system/job_pool.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/words.hpp"
#include "specimen/describe/doubts.hpp"

namespace app {

Prepared fit_to_cells(Prepared prepared, const Settings& settings) {
  for (std::string& note : crop_to_cells(prepared.specimen, settings.scene.points_per_cell))
    prepared.notes.push_back(std::move(note));
  return prepared;
}

Prepared prepare_cells(const Settings& settings) {
  return fit_to_cells(prepare_specimen(settings), settings);
}

namespace {

constexpr const char* void_name = "void";

const mpm::Phase* material_of(const std::string& name, const Settings& settings) {
  for (const mpm::Phase& phase : settings.phases)
    if (phase.name == name) return &phase;
  return nullptr;
}

/// How many pixels and extra points each label has.
std::vector<std::int64_t> count_points(const specimen::Specimen& specimen) {
  std::vector<std::int64_t> points = specimen::count_labels(specimen.mask);
  if (specimen.itz.mode == specimen::ItzMode::points && !specimen.rings.empty())
    ++points[specimen::phase::itz];
  return points;
}

std::vector<std::string> names_in_use(const std::vector<std::string>& names,
                                      const std::vector<std::int64_t>& points) {
  std::vector<std::string> used;
  for (std::size_t label = 0; label < names.size(); ++label)
    if (points[label] > 0) used.push_back(names[label]);
  return used;
}

/// A material for a phase that the specimen does not know is a misspelt name; the phases of concrete are
/// there by default and may be without use.
void check_materials(const Settings& settings, const std::vector<std::string>& names,
                     std::vector<Complaint>& complaints) {
  const std::vector<mpm::Phase> standard = mpm::concrete_phases();
  for (const mpm::Phase& phase : settings.phases) {
    const bool is_standard = std::any_of(standard.begin(), standard.end(),
                                         [&](const mpm::Phase& known) { return known.name == phase.name; });
    const bool known = std::find(names.begin(), names.end(), phase.name) != names.end();
    if (phase.name == void_name)
      complaints.push_back(
          complaint("phases.void", "a material", "void is empty", "remove it, or name the phase otherwise"));
    else if (!known && !is_standard)
      complaints.push_back(complaint("phases." + phase.name, "no such phase",
                                     "the specimen has " + listed(names, "and"),
                                     did_you_mean(phase.name, names)));
  }
}

std::vector<std::optional<mpm::Phase>> phases_of(const specimen::Specimen& specimen,
                                                 const Settings& settings) {
  const std::vector<std::string>& names = specimen.mask.phases;
  const std::vector<std::int64_t> points = count_points(specimen);
  std::vector<Complaint> complaints;
  check_materials(settings, names, complaints);
  std::vector<std::optional<mpm::Phase>> phases(names.size());
  for (std::size_t label = 0; label < names.size(); ++label) {
    if (names[label] == void_name || points[label] == 0) continue;
    if (const mpm::Phase* material = material_of(names[label], settings))
      phases[label] = *material;
    else
      complaints.push_back(
          complaint("phases." + names[label], "has no material",
                    "the specimen has " + listed(names_in_use(names, points), "and"),
                    fmt::format("give young, poisson and density in [phases.{0}], or as --{0}.young ...",
                                names[label])));
  }
  if (!complaints.empty()) throw Rejected(Exit::data, complaints);
  return phases;
}

mpm::PixelField<std::uint8_t> lattice_of(const specimen::Raster<std::uint8_t>& labels) {
  return Eigen::Map<const mpm::PixelField<std::uint8_t>>(labels.data.data(), labels.rows, labels.cols);
}

bool all_void(const mpm::Scene& scene, Eigen::Index first_row) {
  for (const std::uint8_t label : scene.labels.middleRows(first_row, scene.points_per_cell).reshaped())
    if (scene.phases[label]) return false;
  return true;
}

/// A platen holds the nodes along an edge; where the cells there are empty it would move nothing.
void check_edges(const mpm::Scene& scene) {
  const bool top = all_void(scene, 0);
  if (!top && !all_void(scene, scene.labels.rows() - scene.points_per_cell)) return;
  throw Rejected(Exit::data, "specimen", top ? "void along its top edge" : "void along its bottom edge",
                 "must touch both platens",
                 "crop the picture with convert.crop to where the material begins");
}

/// How far down the solid pixels reach that hang together with the cells at the upper edge, which the platen
/// holds, in rows of pixels, by edges or corners. That cells of several pixels have nodes on both sides of a
/// gap carries nothing across it.
Eigen::Index depth_from_top(const mpm::Scene& scene) {
  const Eigen::Index rows = scene.labels.rows(), cols = scene.labels.cols();
  std::vector<char> open(static_cast<std::size_t>(rows * cols));  // solid, and not yet reached
  for (Eigen::Index i = 0; i < scene.labels.size(); ++i)
    open[static_cast<std::size_t>(i)] = scene.phases[scene.labels.data()[i]] ? 1 : 0;
  std::vector<Eigen::Index> todo;
  const auto reach = [&](Eigen::Index row, Eigen::Index col) {
    if (row < 0 || col < 0 || row >= rows || col >= cols) return;
    char& is_open = open[static_cast<std::size_t>(row * cols + col)];
    if (is_open == 0) return;
    is_open = 0;
    todo.push_back(row * cols + col);
  };
  for (Eigen::Index row = 0; row < scene.points_per_cell; ++row)
    for (Eigen::Index col = 0; col < cols; ++col) reach(row, col);
  Eigen::Index depth = 0;
  while (!todo.empty()) {
    const Eigen::Index row = todo.back() / cols, col = todo.back() % cols;
    todo.pop_back();
    depth = std::max(depth, row + 1);
    for (int d = 0; d < 9; ++d) reach(row + d / 3 - 1, col + d % 3 - 1);
  }
  return depth;
}

/// Least height of void that the platens must close before material touches from one to the other [m].
double least_gap(const mpm::Scene& scene) {
  Eigen::Index least = scene.labels.rows();
  for (Eigen::Index col = 0; col < scene.labels.cols(); ++col) {
    Eigen::Index empty = 0;
    for (const std::uint8_t label : scene.labels.col(col)) empty += scene.phases[label] ? 0 : 1;
    least = std::min(least, empty);
  }
  return static_cast<double>(least) * scene.pixel_size;
}

/// Where the upper part of a specimen ends that is in two; empty for one that holds together.
std::string where_parted(const mpm::Scene& scene) {
  const Eigen::Index depth = depth_from_top(scene);
  if (depth > scene.labels.rows() - scene.points_per_cell) return {};
  return fmt::format("void from side to side, {:.4g} mm below its top edge",
                     1e3 * static_cast<double>(depth) * scene.pixel_size);
}

/// Points that move, and are pressed, may meet across a void; within a cell they act on each other already.
bool may_meet(const mpm::Scene& scene) {
  const double cell = scene.points_per_cell * scene.pixel_size;
  return scene.kinematics != mpm::Kinematics::small_strain &&
         scene.loading.direction == mpm::Direction::compression &&
         least_gap(scene) <= scene.loading.stop_strain * scene.height() + cell;
}

/// With nothing from platen to platen there is no test, unless points that move still meet.
void check_connection(const mpm::Scene& scene) {
  const std::string where = where_parted(scene);
  if (where.empty() || may_meet(scene)) return;
  throw Rejected(Exit::data, "specimen", where, "must hold together from platen to platen",
                 "look at the phases with mesopix inspect; convert.class_phases says which class is void");
}

/// That the parts of a specimen have yet to meet.
std::vector<std::string> notes_on_parts(const mpm::Scene& scene) {
  if (scene.loading.direction == mpm::Direction::none || scene.fixture.has_loads()) return {};
  const std::string where = where_parted(scene);
  if (where.empty()) return {};
  return {
      fmt::format("the specimen is in parts, with {}: nothing is carried from platen to platen until they "
                  "meet; the least gap is {:.4g} mm, and the platen moves by {:.4g} mm",
                  where, 1e3 * least_gap(scene), 1e3 * scene.loading.stop_strain * scene.height())};
}

/// The paper's ITZ: a material point at each corner of each ring; corners outside the specimen are left out.
std::vector<mpm::ExtraPoint> itz_points(const specimen::Specimen& specimen, const std::vector<Cut>& cuts) {
  std::vector<mpm::ExtraPoint> points;
  if (specimen.itz.mode != specimen::ItzMode::points) return points;
  const double width = specimen.mask.width();
  const double height = specimen.mask.height();
  for (const specimen::Ring& ring : specimen.rings)
    for (const specimen::Point& vertex : ring.vertices)
      if (vertex.x >= 0 && vertex.x <= width && vertex.y >= 0 && vertex.y <= height &&
          !is_cut_out(vertex.x, vertex.y, cuts))
        points.push_back({vertex.x, vertex.y, specimen::phase::itz});
  return points;
}

/// The displacement at which a run ends, over the height of its specimen.
double stop_strain_of(double displacement, const mpm::Scene& scene) {
  const double strain = displacement / scene.height();
  if (strain < 1) return strain;
  throw Rejected(
      Exit::data, "loading.stop_displacement", format_quantity(displacement, Dimension::length),
      "must be less than the specimen is high, " + format_quantity(scene.height(), Dimension::length));
}

}  // namespace

std::vector<std::string> crop_to_cells(specimen::Specimen& specimen, int points_per_cell) {
  const specimen::Raster<std::uint8_t>& old = specimen.mask.labels;
  const int top = old.rows % points_per_cell;
  const int right = old.cols % points_per_cell;
  if (top == 0 && right == 0) return {};
  if (top == old.rows || right == old.cols)
    throw Rejected(Exit::data, "solver.cell", fmt::format("{0} x {0}", points_per_cell),
                   fmt::format("the specimen has only {} x {} pixels", old.cols, old.rows),
                   "use smaller pixels");
  specimen::Raster<std::uint8_t> cropped(old.rows - top, old.cols - right);
  for (int row = 0; row < cropped.rows; ++row)
    for (int col = 0; col < cropped.cols; ++col) cropped(row, col) = old(row + top, col);
  const std::string note = fmt::format(
      "the specimen was cropped from {} x {} to {} x {} pixels, at its top and right edges, to whole "
      "cells of {} x {} pixels",
      old.cols, old.rows, cropped.cols, cropped.rows, points_per_cell, points_per_cell);
  specimen.mask.labels = std::move(cropped);
  return {note};
}

std::vector<Complaint> flight_complaints(const mpm::Loading& loading) {
  if (loading.direction != mpm::Direction::none) return {};
  if (loading.initial_velocity_x != 0 || loading.initial_velocity_y != 0) return {};
  return {complaint("loading.initial_velocity_y", "0 m/s", "without platens a specimen at rest stays at rest",
                    "give loading.initial_velocity_x or loading.initial_velocity_y")};
}

mpm::Scene build_scene(const specimen::Specimen& specimen, const Settings& settings) {
  mpm::Scene scene = settings.scene;
  scene.labels = lattice_of(specimen.mask.labels);
  scene.pixel_size = specimen.mask.pixel_size;
  scene.phases = phases_of(specimen, settings);
  scene.extra_points = itz_points(specimen, settings.cuts);
  if (settings.stop_displacement)
    scene.loading.stop_strain = stop_strain_of(*settings.stop_displacement, scene);
  if (const auto complaints = flight_complaints(scene.loading); !complaints.empty())
    throw Rejected(Exit::data, complaints);
  if (scene.loading.direction != mpm::Direction::none && !scene.fixture.has_loads()) {
    check_edges(scene);
    check_connection(scene);
  }
  return scene;
}

mpm::Scene build_elastic_scene(const specimen::Specimen& specimen, const Settings& settings) {
  if (!itz_points(specimen, settings.cuts).empty())
    throw Rejected(Exit::data, "itz.mode", "points", "the stiffness of a specimen needs the ITZ as pixels",
                   "choose itz.mode ring");
  mpm::Scene scene;
  scene.labels = lattice_of(specimen.mask.labels);
  scene.pixel_size = specimen.mask.pixel_size;
  scene.phases = phases_of(specimen, settings);
  scene.plane = settings.scene.plane;
  scene.points_per_cell = settings.scene.points_per_cell;
  scene.pixel_cells = settings.scene.pixel_cells;
  scene.instruction_set = settings.scene.instruction_set;
  mpm::validate(scene);
  return scene;
}

namespace {

/// More threads than cores wait for each other most of the time, and no bit depends on them.
void hold_to_cores(mpm::Scene& scene, std::vector<std::string>& notes) {
  const int cores = core_count();
  if (scene.threads <= cores) return;
  notes.push_back(
      fmt::format("solver.threads = {} is more than there are cores: the run has {}, one for each",
                  scene.threads, counted(cores, "thread")));
  scene.threads = cores;
}

}  // namespace

Job make_job(Settings settings, Prepared cells) {
  mpm::Scene scene = build_scene(cells.specimen, settings);
  hold_to_cores(scene, cells.notes);
  mpm::validate(scene);
  for (std::string& note : notes_on_parts(scene)) cells.notes.push_back(std::move(note));
  return {std::move(settings), std::move(cells.specimen), std::move(scene), std::move(cells.notes)};
}

Job make_job(Settings settings) {
  Prepared cells = prepare_cells(settings);
  return make_job(std::move(settings), std::move(cells));
}

Job make_job(Settings settings, Console& console) {
  Prepared cells = prepare_cells(settings);
  for (const std::string& note : cells.notes) console.say("note: " + note);
  for (const std::string& doubt : specimen::doubts_of(cells.specimen)) console.warn(doubt);
  const std::size_t told = cells.notes.size();
  Job job = make_job(std::move(settings), std::move(cells));
  for (std::size_t i = told; i < job.notes.size(); ++i) console.say("warning: " + job.notes[i]);
  return job;
}

}  // namespace app
