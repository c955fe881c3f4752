#include "apps/export/abaqus.hpp"

#include <fmt/format.h>

#include "apps/export/set_names.hpp"
#include "apps/export/text_stream.hpp"

namespace exchange {
namespace {

void write_heading(TextStream& file, const PixelMesh& mesh, const std::vector<std::string>& sets) {
  file << fmt::format(
      "*HEADING\n"
      "Specimen of mesopix, {} x {} pixels of {} m\n"
      "** Lengths are in metres. The origin is the bottom left corner, x points right, y points up.\n"
      "** Pixel (row, column), counted from 0 at the top left, is element row * {} + column + 1.\n"
      "** Void pixels have no element, and nodes amid void are left out.\n"
      "** Before an analysis, give every element set a material and a section, for instance:\n",
      mesh.cols(), mesh.rows(), length_text(mesh.mask().pixel_size), mesh.cols());
  for (const std::string& set : sets)
    file << fmt::format("**   *MATERIAL, NAME=M_{0}\n**   *SOLID SECTION, ELSET={0}, MATERIAL=M_{0}\n", set);
}

void write_node_block(TextStream& file, const PixelMesh& mesh) {
  const std::vector<std::string> x = mesh.x_texts();
  const std::vector<std::string> y = mesh.y_texts();
  file << "*NODE\n";
  mesh.for_each_node([&](MeshNode node) {
    file << mesh.number(node) << ", " << x[static_cast<std::size_t>(node.col)] << ", "
         << y[static_cast<std::size_t>(node.line)] << "\n";
  });
}

void write_elements(TextStream& file, const PixelMesh& mesh, const MeshPhase& phase) {
  mesh.for_each_element(phase, [&](int row, int col) {
    file << mesh.element(row, col);
    for (const std::int64_t node : mesh.corners(row, col)) file << ", " << node;
    file << "\n";
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

std::vector<std::string> element_sets(const PixelMesh& mesh) {
  std::vector<std::string> phases;
  for (const MeshPhase& phase : mesh.phases()) phases.push_back(phase.name);
  return set_names(phases);
}

void write_abaqus(const std::string& path, const PixelMesh& mesh, PlaneElement plane) {
  const std::vector<std::string> sets = element_sets(mesh);
  const char* type = plane == PlaneElement::stress ? "CPS4" : "CPE4";
  write_text(path, [&](TextStream& file) {
    write_heading(file, mesh, sets);
    write_node_block(file, mesh);
    for (std::size_t k = 0; k < sets.size(); ++k) {
      file << "*ELEMENT, TYPE=" << type << ", ELSET=" << sets[k] << "\n";
      write_elements(file, mesh, mesh.phases()[k]);
    }
    for (const Edge edge : edges) write_node_set(file, edge, mesh.nodes_on(edge));
  });
}

}  // namespace exchange
