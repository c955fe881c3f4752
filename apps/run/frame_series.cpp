#include "apps/run/frame_series.hpp"

#include <algorithm>
#include <array>

#include "apps/text/text.hpp"

namespace output {
namespace {

constexpr std::size_t digits = 6;
const std::string stem = "p_";
const std::string ending = ".hdf";

/// A dataset in the file of a frame. @param width  numbers a point. @param type  with its precision.
std::string data_item(const FrameEntry& frame, const std::string& dataset, int width,
                      const std::string& type) {
  return "<DataItem Dimensions=\"" + std::to_string(frame.points) + " " + std::to_string(width) + "\" " +
         type + " Format=\"HDF\">" + frame.path + ":/VTKHDF/" + dataset + "</DataItem>";
}

const std::string float32 = R"(NumberType="Float" Precision="4")";
const std::string int64 = R"(NumberType="Int" Precision="8")";
const std::string int32 = R"(NumberType="Int" Precision="4")";
const std::string uint8 = R"(NumberType="UChar" Precision="1")";

struct Attribute {
  const char* name;
  const char* kind;
  int width;
  const std::string& type;
};
const std::array<Attribute, 6> attributes{{{"displacement", "Vector", 3, float32},
                                           {"velocity", "Vector", 3, float32},
                                           {"stress", "Tensor", 9, float32},
                                           {"damage", "Scalar", 1, float32},
                                           {"phase", "Scalar", 1, uint8},
                                           {"id", "Scalar", 1, int32}}};

}  // namespace

std::string frame_name(std::int64_t number) {
  const std::string text = std::to_string(number);
  return stem + std::string(digits - std::min(digits, text.size()), '0') + text + ending;
}

bool is_frame_name(const std::string& name) {
  if (name.size() < stem.size() + digits + ending.size() || !name.starts_with(stem) ||
      !name.ends_with(ending))
    return false;
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()),
                     name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                     [](char c) { return c >= '0' && c <= '9'; });
}

void FrameSeries::add(const FrameEntry& frame) {
  if (!files_.empty()) files_ += ",\n";
  files_ += "    {\"name\": \"" + frame.path + "\", \"time\": " + exact(frame.time) + "}";
}

std::string FrameSeries::text() const {
  return "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n" + files_ + "\n  ]\n}\n";
}

void FrameXdmf::add(const FrameEntry& frame) {
  if (frame.points == 0) return;
  grids_ += "      <Grid Name=\"" + frame.path + "\" GridType=\"Uniform\">\n        <Time Value=\"" +
            exact(frame.time) + "\"/>\n        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" +
            std::to_string(frame.points) + "\" NodesPerElement=\"1\">" +
            data_item(frame, "Connectivity", 1, int64) +
            "</Topology>\n        <Geometry GeometryType=\"XYZ\">" + data_item(frame, "Points", 3, float32) +
            "</Geometry>\n";
  for (const Attribute& one : attributes)
    grids_ += std::string("        <Attribute Name=\"") + one.name + "\" AttributeType=\"" + one.kind +
              "\" Center=\"Node\">" +
              data_item(frame, std::string("PointData/") + one.name, one.width, one.type) + "</Attribute>\n";
  grids_ += "      </Grid>\n";
}

std::string FrameXdmf::text() const {
  return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
         "    <Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" +
         grids_ + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}  // namespace output
