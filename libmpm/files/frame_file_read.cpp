#include <array>
#include <cmath>

#include "libmpm/files/frame_file.hpp"
#include "libmpm/files/hdf5_read.hpp"
#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

using namespace hdf5;

/// Of a file that packs more, the points would ask for more memory than any run had.
constexpr hsize_t most_points = 200'000'000;

template <class T>
T read_value(hid_t group, const char* name, const char* unit = "1") {
  T value{};
  read_values<T>(group, name, 1, unit, [&](const std::vector<hsize_t>& extent) {
    require(extent[0] == 1, std::string("dataset ") + name + " must hold one value");
    return &value;
  });
  return value;
}

/// Gives set(point, row) the numbers of each point, `width` of them.
template <class T, std::size_t width, class Set>
void read_table(hid_t group, const char* name, const char* unit, Frame& frame, const Set& set) {
  std::vector<T> values;
  read_values<T>(group, name, width == 1 ? 1 : 2, unit, [&](const std::vector<hsize_t>& extent) {
    require(extent[0] == frame.points.size() && (width == 1 || extent.back() == width),
            std::string("dataset ") + name + " has a wrong shape");
    values.resize(width * frame.points.size());
    return values.data();
  });
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    std::array<double, width> row{};
    for (std::size_t k = 0; k < width; ++k) row[k] = static_cast<double>(values[width * i + k]);
    set(frame.points[i], row);
  }
}

/// Their number follows from the data that are there, not from NumberOfPoints.
void read_ids(hid_t group, Frame& frame) {
  std::vector<std::int32_t> ids;
  read_values<std::int32_t>(group, "id", 1, "1", [&](const std::vector<hsize_t>& extent) {
    require(extent[0] <= most_points, "dataset id has more than " + std::to_string(most_points) + " values");
    ids.resize(extent[0]);
    return ids.data();
  });
  std::int64_t before = -1;
  for (const std::int32_t id : ids) {
    require(id > before, "dataset id holds numbers that do not increase from 0");
    before = id;
  }
  frame.points.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) frame.points[i].id = static_cast<std::uint32_t>(ids[i]);
}

void read_motion(hid_t root, hid_t data, Frame& frame) {
  read_table<float, 3>(root, "Points", "m", frame, [](FramePoint& point, const auto& row) {
    point.x = row[0];
    point.y = row[1];
  });
  read_table<float, 3>(data, "displacement", "m", frame, [](FramePoint& point, const auto& row) {
    point.ux = row[0];
    point.uy = row[1];
  });
  read_table<float, 3>(data, "velocity", "m/s", frame, [](FramePoint& point, const auto& row) {
    point.vx = row[0];
    point.vy = row[1];
  });
}

void read_state(hid_t data, Frame& frame) {
  read_table<float, 9>(data, "stress", "Pa", frame, [](FramePoint& point, const auto& row) {
    point.sxx = row[0];
    point.sxy = row[1];
    point.syy = row[4];
    point.szz = row[8];
  });
  read_table<float, 1>(data, "damage", "1", frame, [](FramePoint& point, const auto& row) {
    require(row[0] >= 0 && row[0] <= 1, "dataset damage holds a value that does not lie in [0, 1]");
    point.damage = row[0];
  });
  read_table<std::uint8_t, 1>(data, "phase", "1", frame, [](FramePoint& point, const auto& row) {
    point.phase = static_cast<std::uint8_t>(row[0]);
  });
}

void read_points(hid_t root, Frame& frame) {
  const Handle data = open_group(root, "PointData");
  read_ids(data, frame);
  require(read_value<std::int64_t>(root, "NumberOfPoints") == static_cast<std::int64_t>(frame.points.size()),
          "dataset NumberOfPoints differs from the number of values in id");
  read_motion(root, data, frame);
  read_state(data, frame);
}

Handle open_root(hid_t file) {
  require(H5Lexists(file, "VTKHDF", H5P_DEFAULT) > 0, "is not a mesopix frame");
  Handle root = open_group(file, "VTKHDF");
  std::array<std::int64_t, 2> version{};
  read_attribute(root, "Version", H5T_INTEGER, sizeof version[0], H5T_NATIVE_INT64, version.data(), 2);
  require(version[0] == 1, "has VTKHDF version " + std::to_string(version[0]) + ", this program reads 1");
  return root;
}

Frame read_heading(hid_t root) {
  const Handle field = open_group(root, "FieldData");
  Frame frame;
  frame.time = read_value<double>(field, "TimeValue", "s");
  frame.strain = read_value<double>(field, "strain");
  frame.step = read_value<std::int64_t>(field, "step");
  frame.row = read_value<std::int64_t>(field, "history_row");
  require(std::isfinite(frame.strain), "dataset strain is not a number");
  return frame;
}

template <class Read>
Frame read_from(const std::string& path, const Read& read) try {
  const Quiet quiet;
  const Handle file = open_file(path);
  Frame frame = read(open_root(file));
  if (H5Aexists(file, "run") > 0) frame.run = read_text(file, "run");
  return frame;
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "must be a frame that mesopix wrote", "run the simulation again");
}

}  // namespace

Frame read_frame(const std::string& path) {
  return read_from(path, [](hid_t root) {
    Frame frame = read_heading(root);
    read_points(root, frame);
    return frame;
  });
}

Frame read_frame_heading(const std::string& path) {
  return read_from(path, [](hid_t root) { return read_heading(root); });
}

}  // namespace mpm
