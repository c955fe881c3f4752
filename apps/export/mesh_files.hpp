/// Meshes for Abaqus and CalculiX, for Gmsh and what reads its files (meshio, FEniCSx, MOOSE, ...), and
/// images for ParaView and other programs of VTK.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/export/pixel_mesh.hpp"
#include "specimen/body/mask.hpp"

namespace exchange {

/// Which plane elements: CPS4 or CPE4.
enum class PlaneElement { stress, strain };

/// What makes a mesh an elastic test between platens.
struct ElasticTest {
  struct Material {
    double young = 0;    ///< [Pa]
    double poisson = 0;  ///< [-]
    double density = 0;  ///< [kg/m^3]
  };
  std::vector<std::optional<Material>> materials;  ///< by label
  double strain = 1e-4;                            ///< by which the top edge is moved, tension positive [-]
  bool rough = false;                              ///< platens hold the edges sideways
};

/// Write the mesh as an input file [m]: nodes, an element set a phase under set_names(), node sets BOTTOM,
/// RIGHT, TOP and LEFT (none where an edge is void throughout). With a test also a material and a section a
/// phase, where it has one, and a static step, where both platens find an edge; what is missing for an
/// analysis, a comment says.
/// @throws specimen::Error (Fault::write).
void write_abaqus(const std::string& path, const PixelMesh& mesh, PlaneElement plane,
                  const std::optional<ElasticTest>& test = {});

/// Names of the element sets that get no material from a test.
[[nodiscard]] std::vector<std::string> sets_without_material(const PixelMesh& mesh, const ElasticTest& test);

/// Whether a step can be written: both platens find an edge.
[[nodiscard]] bool can_be_loaded(const PixelMesh& mesh);

/// Names of the element sets, in the order of the phases of the mesh.
[[nodiscard]] std::vector<std::string> element_sets(const PixelMesh& mesh);

/// Write the mesh in format 4.1, as text [m]: a physical surface a phase under group_names() with the label
/// of the phase as its tag, and physical curves BOTTOM, RIGHT, TOP and LEFT with tags 1 ... 4 (none where an
/// edge is void throughout) of lines of two nodes.
/// @throws specimen::Error (Fault::write).
void write_gmsh(const std::string& path, const PixelMesh& mesh);

/// Names of the physical surfaces, in the order of the phases of the mesh.
[[nodiscard]] std::vector<std::string> physical_surfaces(const PixelMesh& mesh);

/// Write the mask as VTK ImageData (.vti) [m]: a cell a pixel, void included, with the label in the cell data
/// `phase`, and the names of the phases by label in the field data `phase_names`. VTK counts rows from below.
/// @throws specimen::Error (Fault::write).
void write_vtk_image(const std::string& path, const specimen::LabelledMask& mask);

}  // namespace exchange
