#include "apps/export/mesh_files.hpp"

#include <fmt/format.h>
#include <array>
#include <cstdint>
#include <string_view>

#include "apps/export/mesh_text.hpp"

namespace exchange {
namespace {

/// What every file says of its mesh.   @param mark  of a comment, on all lines but the first.
std::string words_on(const PixelMesh& mesh, const char* mark) {
  return fmt::format(
      "Specimen of mesopix, {0} x {1} pixels of {2} m\n"
      "{3}Lengths are in metres. The origin is the bottom left corner, x points right, y points up.\n"
      "{3}Pixels are elements 1, 2, 3, ... row by row from the top left; void pixels are none, and not "
      "counted.\n",
      mesh.cols(), mesh.rows(), length_text(mesh.mask().pixel_size), mark);
}

std::vector<std::string> phase_names(const PixelMesh& mesh) {
  std::vector<std::string> names;
  for (const MeshPhase& phase : mesh.phases()) names.push_back(phase.name);
  return names;
}

/// @param see  takes the number of a node and its coordinates as text.
template <class See>
void each_node(const PixelMesh& mesh, const See& see) {
  const std::vector<std::string> x = mesh.x_texts(), y = mesh.y_texts();
  mesh.for_each_node([&](MeshNode node) {
    see(mesh.number(node), x[static_cast<std::size_t>(node.col)], y[static_cast<std::size_t>(node.line)]);
  });
}

/// A line an element: its number and those of its corners.
void write_elements(TextStream& file, const PixelMesh& mesh, const MeshPhase& phase, const char* separator) {
  mesh.for_each_element(phase, [&](int row, int col) {
    file << mesh.element(row, col);
    for (const std::int64_t node : mesh.corners(row, col)) file << separator << node;
    file << "\n";
  });
}

/// @param sets  that get no material below.
void write_heading(TextStream& file, const PixelMesh& mesh, const std::vector<std::string>& sets) {
  file << "*HEADING\n" << words_on(mesh, "** ");
  if (sets.empty()) return;
  file << "** Before an analysis, give these element sets a material and a section, for instance:\n";
  for (const std::string& set : sets)
    file << fmt::format("**   *MATERIAL, NAME=M_{0}\n**   *SOLID SECTION, ELSET={0}, MATERIAL=M_{0}\n", set);
}

void write_node_block(TextStream& file, const PixelMesh& mesh) {
  file << "*NODE\n";
  each_node(mesh, [&](std::int64_t number, const std::string& x, const std::string& y) {
    file << number << ", " << x << ", " << y << "\n";
  });
}

/// At most 16 numbers may stand on a line.
void write_node_set(TextStream& file, Edge edge, const std::vector<std::int64_t>& numbers) {
  if (numbers.empty()) return;
  file << "*NSET, NSET=" << name_of(edge) << "\n";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    file << numbers[i] << (i % 16 == 15 || i + 1 == numbers.size() ? "\n" : ", ");
}

}  // namespace

std::vector<std::string> element_sets(const PixelMesh& mesh) { return set_names(phase_names(mesh)); }

namespace {

using Material = ElasticTest::Material;

const Material* material_of(const ElasticTest& test, const MeshPhase& phase) {
  if (phase.label >= test.materials.size() || !test.materials[phase.label]) return nullptr;
  return &*test.materials[phase.label];
}

void write_materials(TextStream& file, const PixelMesh& mesh, const std::vector<std::string>& sets,
                     const ElasticTest& test) {
  for (std::size_t k = 0; k < sets.size(); ++k)
    if (const Material* material = material_of(test, mesh.phases()[k]); material != nullptr)
      file << fmt::format(
          "*MATERIAL, NAME=M_{0}\n*ELASTIC\n{1:.10g}, {2:.10g}\n*DENSITY\n{3:.10g}\n"
          "*SOLID SECTION, ELSET={0}, MATERIAL=M_{0}\n1.\n",
          sets[k], material->young, material->poisson, material->density);
}

/// The bottom is held and the top moved; smooth platens hold one node alone sideways.
void write_step(TextStream& file, const PixelMesh& mesh, const ElasticTest& test) {
  const double moved = test.strain * mesh.mask().height();
  file << "** The top edge is moved by a strain of " << fmt::format("{:.6g}", test.strain)
       << " over the height; the sum of the reactions, over the width, is the stress.\n*BOUNDARY\n"
       << "BOTTOM, 2, 2\n";
  if (test.rough)
    file << "BOTTOM, 1, 1\nTOP, 1, 1\n";
  else
    file << mesh.nodes_on(Edge::bottom).front() << ", 1, 1\n";
  file << "*STEP\n*STATIC\n*BOUNDARY\nTOP, 2, 2, " << fmt::format("{:.10g}", moved)
       << "\n*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF\n*NODE FILE\nU\n*EL FILE\nS, E\n*END STEP\n";
}

}  // namespace

std::vector<std::string> sets_without_material(const PixelMesh& mesh, const ElasticTest& test) {
  const std::vector<std::string> sets = element_sets(mesh);
  std::vector<std::string> without;
  for (std::size_t k = 0; k < sets.size(); ++k)
    if (material_of(test, mesh.phases()[k]) == nullptr) without.push_back(sets[k]);
  return without;
}

bool can_be_loaded(const PixelMesh& mesh) {
  return !mesh.nodes_on(Edge::bottom).empty() && !mesh.nodes_on(Edge::top).empty();
}

void write_abaqus(const std::string& path, const PixelMesh& mesh, PlaneElement plane,
                  const std::optional<ElasticTest>& test) {
  const std::vector<std::string> sets = element_sets(mesh);
  const char* type = plane == PlaneElement::stress ? "CPS4" : "CPE4";
  write_text(path, [&](TextStream& file) {
    write_heading(file, mesh, test ? sets_without_material(mesh, *test) : sets);
    write_node_block(file, mesh);
    for (std::size_t k = 0; k < sets.size(); ++k) {
      file << "*ELEMENT, TYPE=" << type << ", ELSET=" << sets[k] << "\n";
      write_elements(file, mesh, mesh.phases()[k], ", ");
    }
    for (const Edge edge : edges) write_node_set(file, edge, mesh.nodes_on(edge));
    if (!test) return;
    write_materials(file, mesh, sets, *test);
    if (can_be_loaded(mesh)) write_step(file, mesh, *test);
  });
}

namespace {

using std::int64_t;

constexpr int line_of_two_nodes = 1;
constexpr int quadrangle_of_four_nodes = 3;

/// Lines along an edge; their curve and its physical group have the same tag.
struct Curve {
  Edge edge;
  int tag;
  std::vector<std::array<int64_t, 2>> sides;
};

std::vector<Curve> curves_of(const PixelMesh& mesh) {
  std::vector<Curve> curves;
  for (const Edge edge : edges)
    if (auto sides = mesh.sides(edge); !sides.empty())
      curves.push_back({edge, static_cast<int>(edge) + 1, std::move(sides)});
  return curves;
}

void write_header(TextStream& file, const PixelMesh& mesh) {
  file << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n" << words_on(mesh, "") << "$EndComments\n";
}

void write_physical_names(TextStream& file, const PixelMesh& mesh, const std::vector<Curve>& curves) {
  const std::vector<std::string> names = physical_surfaces(mesh);
  file << "$PhysicalNames\n" << static_cast<int64_t>(curves.size() + names.size()) << "\n";
  for (const Curve& curve : curves) file << fmt::format("1 {} \"{}\"\n", curve.tag, name_of(curve.edge));
  for (std::size_t k = 0; k < names.size(); ++k)
    file << fmt::format("2 {} \"{}\"\n", mesh.phases()[k].label, names[k]);
  file << "$EndPhysicalNames\n";
}

/// Every curve and surface is said to be as large as the specimen: the boxes only help to look for things.
void write_entities(TextStream& file, const PixelMesh& mesh, const std::vector<Curve>& curves) {
  const std::string box =
      fmt::format("0 0 0 {} {} 0", length_text(mesh.mask().width()), length_text(mesh.mask().height()));
  file << fmt::format("$Entities\n0 {} {} 0\n", curves.size(), mesh.phases().size());
  for (const Curve& curve : curves) file << fmt::format("{0} {1} 1 {0} 0\n", curve.tag, box);
  for (const MeshPhase& phase : mesh.phases()) file << fmt::format("{0} {1} 1 {0} 0\n", phase.label, box);
  file << "$EndEntities\n";
}

/// One block, filed under the first surface: a node of two phases belongs to neither.
void write_node_section(TextStream& file, const PixelMesh& mesh) {
  file << fmt::format("$Nodes\n1 {0} 1 {0}\n2 {1} 0 {0}\n", mesh.nodes(), mesh.phases().front().label);
  mesh.for_each_node([&](MeshNode node) { file << mesh.number(node) << "\n"; });
  each_node(mesh,
            [&](int64_t, const std::string& x, const std::string& y) { file << x << " " << y << " 0\n"; });
  file << "$EndNodes\n";
}

/// Lines are numbered behind the elements.
void write_lines(TextStream& file, const std::vector<Curve>& curves, int64_t number) {
  for (const Curve& curve : curves) {
    file << fmt::format("1 {} {} {}\n", curve.tag, line_of_two_nodes, curve.sides.size());
    for (const auto& [begin, end] : curve.sides) file << ++number << " " << begin << " " << end << "\n";
  }
}

void write_quadrangles(TextStream& file, const PixelMesh& mesh) {
  for (const MeshPhase& phase : mesh.phases()) {
    file << fmt::format("2 {} {} {}\n", phase.label, quadrangle_of_four_nodes, phase.elements);
    write_elements(file, mesh, phase, " ");
  }
}

void write_elements(TextStream& file, const PixelMesh& mesh, const std::vector<Curve>& curves) {
  int64_t lines = 0;
  for (const Curve& curve : curves) lines += static_cast<int64_t>(curve.sides.size());
  file << fmt::format("$Elements\n{} {} 1 {}\n", curves.size() + mesh.phases().size(),
                      mesh.elements() + lines, mesh.elements() + lines);
  write_lines(file, curves, mesh.elements());
  write_quadrangles(file, mesh);
  file << "$EndElements\n";
}

}  // namespace

std::vector<std::string> physical_surfaces(const PixelMesh& mesh) { return group_names(phase_names(mesh)); }

void write_gmsh(const std::string& path, const PixelMesh& mesh) {
  const std::vector<Curve> curves = curves_of(mesh);
  write_text(path, [&](TextStream& file) {
    write_header(file, mesh);
    write_physical_names(file, mesh, curves);
    write_entities(file, mesh, curves);
    write_node_section(file, mesh);
    write_elements(file, mesh, curves);
  });
}

namespace {

/// Codes of the characters of every name, each with a zero behind it, as VTK spells texts.
std::string spelled(const std::vector<std::string>& names) {
  std::string codes;
  for (const std::string& name : names) {
    for (const char c : name) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    codes += "0\n";
  }
  return codes;
}

std::string header(const specimen::LabelledMask& mask) {
  const std::string extent = fmt::format("0 {} 0 {} 0 0", mask.labels.cols, mask.labels.rows);
  return fmt::format(
      R"(<?xml version="1.0"?>
<!-- Specimen of mesopix. Lengths are in metres. The origin is the bottom left corner, x points right, y points up. -->
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{0}" Origin="0 0 0" Spacing="{1} {1} {1}">
<FieldData>
<Array type="String" Name="phase_names" NumberOfTuples="{2}" format="ascii">
{3}</Array>
</FieldData>
<Piece Extent="{0}">
<CellData Scalars="phase">
<DataArray type="UInt8" Name="phase" format="appended" offset="0"/>
</CellData>
</Piece>
</ImageData>
<AppendedData encoding="raw">
_)",
      extent, length_text(mask.pixel_size), mask.phases.size(), spelled(mask.phases));
}

/// Number of bytes that follow, the lowest byte first.
std::string size_prefix(std::uint64_t size) {
  std::string bytes;
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(size >> shift & 0xFF);
  return bytes;
}

std::string_view row_of(const specimen::Raster<std::uint8_t>& labels, int row) {
  return {reinterpret_cast<const char*>(&labels(row, 0)), static_cast<std::size_t>(labels.cols)};
}

}  // namespace

void write_vtk_image(const std::string& path, const specimen::LabelledMask& mask) {
  write_text(path, [&](TextStream& file) {
    file << header(mask) << size_prefix(mask.labels.size());
    for (int row = mask.labels.rows - 1; row >= 0; --row) file << row_of(mask.labels, row);
    file << "\n</AppendedData>\n</VTKFile>\n";
  });
}

}  // namespace exchange
