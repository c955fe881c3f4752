#include "libmpm/files/frame_file.hpp"

#include <array>
#include <numeric>

#include "libmpm/files/hdf5_write.hpp"
#include "libmpm/files/replace_file.hpp"
#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

using namespace hdf5;

constexpr std::uint8_t vertex = 1;  // VTK_VERTEX
/// The run waits for its frames, and the noise of 32-bit numbers grows by 2 % only.
constexpr unsigned fast = 2;

/// VTK reads its type as text of a fixed length only.
void write_type(hid_t group, const std::string& name) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "out of memory");
  H5Tset_size(type, name.size());
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  write_attribute(group, "Type", type, type, name.data());
}

void write_version(hid_t group) {
  const std::array<std::int64_t, 2> version{1, 0};
  const hsize_t length = version.size();
  const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose, "out of memory");
  const Handle attribute(H5Acreate2(group, "Version", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "Version cannot be created");
  require(H5Awrite(attribute, H5T_NATIVE_INT64, version.data()) >= 0, "Version cannot be written");
}

template <class T>
void write_value(hid_t group, const char* name, T value, const Column& column) {
  write_values(group, name, {1}, &value, column);
}

/// A table with the numbers of each point, which value_of(point) gives as an array.
template <class ValueOf>
void write_table(hid_t group, const char* name, const Frame& frame, const ValueOf& value_of, Column column) {
  column.effort = fast;
  using Row = decltype(value_of(FramePoint{}));
  std::vector<Row> rows;
  rows.reserve(frame.points.size());
  for (const FramePoint& point : frame.points) rows.push_back(value_of(point));
  constexpr std::size_t width = std::tuple_size_v<Row>;
  static_assert(sizeof(Row) == width * sizeof(typename Row::value_type));
  std::vector<hsize_t> extent{rows.size()};
  if (width > 1) extent.push_back(width);
  write_values(group, name, extent, rows.empty() ? nullptr : rows.data()->data(), column);
}

template <class... Values>
std::array<float, sizeof...(Values)> floats(Values... values) {
  return {static_cast<float>(values)...};
}

void write_cells(hid_t group, std::size_t points) {
  const auto count = static_cast<std::int64_t>(points);
  write_value(group, "NumberOfPoints", count, {"1", "points"});
  write_value(group, "NumberOfCells", count, {"1", "vertices"});
  write_value(group, "NumberOfConnectivityIds", count, {"1", "points of all vertices"});
  std::vector<std::int64_t> numbers(points + 1);
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  write_values(group, "Connectivity", {points}, numbers.data(), {"1", "point of each vertex"});
  write_values(group, "Offsets", {points + 1}, numbers.data(), {"1", "where vertices begin in Connectivity"});
  const std::vector<std::uint8_t> types(points, vertex);
  write_values(group, "Types", {points}, types.data(), {"1", "kind of each cell: 1 = vertex"});
}

std::string meaning_of_phase(const Scene& scene) {
  std::string text = "label in the mask";
  for (std::size_t label = 0; label < scene.phases.size(); ++label)
    if (scene.phases[label]) text += ", " + std::to_string(label) + " = " + scene.phases[label]->name;
  return text;
}

void write_point_data(hid_t group, const Frame& frame, const Scene& scene) {
  const auto table = [&](const char* name, const auto& value_of, const Column& column) {
    write_table(group, name, frame, value_of, column);
  };
  table("displacement", [](const FramePoint& p) { return floats(p.ux, p.uy, 0); }, {"m", "since the start"});
  table("velocity", [](const FramePoint& p) { return floats(p.vx, p.vy, 0); }, {"m/s", "of the points"});
  table("stress", [](const FramePoint& p) { return floats(p.sxx, p.sxy, 0, p.sxy, p.syy, 0, 0, 0, p.szz); },
        {"Pa", "stress that a point carries: xx xy xz yx yy yz zx zy zz; tension is positive"});
  table("damage", [](const FramePoint& p) { return floats(p.damage); }, {"1", "0 = intact, 1 = failed"});
  table("phase", [](const FramePoint& p) { return std::array{p.phase}; }, {"1", meaning_of_phase(scene)});
  table("id", [](const FramePoint& p) { return std::array{static_cast<std::int32_t>(p.id)}; },
        {"1", "row * columns + column of the pixel; extra points follow"});
}

void write_field_data(hid_t group, const Frame& frame) {
  write_value(group, "TimeValue", frame.time, {"s", "time of the points"});
  write_value(group, "strain", frame.strain, {"1", "platen displacement over height, of the points"});
  write_value(group, "step", frame.step, {"1", "steps so far"});
  write_value(group, "history_row", frame.row, {"1", "last row of the history written before"});
}

}  // namespace

void write_frame(const std::string& path, const Frame& frame, const Scene& scene,
                 const std::string& run) try {
  const Quiet quiet;
  const Handle file = memory_file();
  if (!run.empty()) write_text(file, "run", run);
  const Handle root = create_group(file, "VTKHDF");
  write_version(root);
  write_type(root, "UnstructuredGrid");
  write_cells(root, frame.points.size());
  write_table(root, "Points", frame, [](const FramePoint& p) { return floats(p.x, p.y, 0); },
              {"m", "position of the points; y upwards from the lower edge of the picture"});
  write_point_data(create_group(root, "PointData"), frame, scene);
  write_field_data(create_group(root, "FieldData"), frame);
  replace_file(path, image_of(file));
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "");
}

}  // namespace mpm
