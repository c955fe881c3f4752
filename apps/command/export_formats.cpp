#include "apps/command/export_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "apps/export/imagej.hpp"
#include "apps/export/mesh_files.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"
#include "specimen/body/files.hpp"
#include "specimen/picture/picture.hpp"

namespace app {
namespace {

std::string mesh_sentence(const exchange::PixelMesh& mesh, const char* sets,
                          const std::vector<std::string>& names) {
  return fmt::format("{} elements and {} nodes; {} {}", mesh.elements(), mesh.nodes(), sets,
                     listed(names, "and"));
}

std::string write_inp(const SpecimenExport& wanted) {
  const exchange::PixelMesh mesh(wanted.specimen.mask);
  exchange::write_abaqus(wanted.path, mesh, wanted.plane, wanted.test);
  std::string sentence = mesh_sentence(mesh, "element sets", exchange::element_sets(mesh));
  if (!wanted.test) return sentence + "; give them materials and sections";
  sentence += ", with the elastic materials of " + wanted.of;
  if (const auto without = exchange::sets_without_material(mesh, *wanted.test); !without.empty())
    sentence += "; give " + listed(without, "and") + " a material and a section";
  if (!exchange::can_be_loaded(mesh)) return sentence + "; without a step, as an edge is void throughout";
  return sentence +
         fmt::format("; a static step moves the top edge by a strain of {:.6g}", wanted.test->strain);
}

std::string write_msh(const SpecimenExport& wanted) {
  const exchange::PixelMesh mesh(wanted.specimen.mask);
  exchange::write_gmsh(wanted.path, mesh);
  return mesh_sentence(mesh, "physical surfaces", exchange::physical_surfaces(mesh));
}

/// "0:void,1:aggregate", as --label-phases takes it.
std::string legend(const specimen::LabelledMask& mask) {
  const std::vector<std::int64_t> counts = specimen::count_labels(mask);
  std::string text;
  for (std::size_t label = 0; label < counts.size(); ++label)
    if (counts[label] > 0) text += fmt::format("{}{}:{}", text.empty() ? "" : ",", label, mask.phases[label]);
  return text;
}

std::string write_vti(const SpecimenExport& wanted) {
  exchange::write_vtk_image(wanted.path, wanted.specimen.mask);
  return "cell data phase: " + legend(wanted.specimen.mask);
}

std::string way_back(const SpecimenExport& wanted) {
  return fmt::format("a specimen again: mesopix convert {} --label-phases {} --itz-mode none",
                     shell_word(wanted.path), shell_word(legend(wanted.specimen.mask)));
}

std::string write_png(const SpecimenExport& wanted) {
  specimen::write_labels(wanted.path, wanted.specimen.mask);
  return way_back(wanted);
}

std::string write_tif(const SpecimenExport& wanted) {
  specimen::write_imagej_tiff(wanted.path, wanted.specimen.mask);
  return way_back(wanted);
}

void replace_with_text(const std::string& path, const std::string& bytes) {
  specimen::replace_file(path, std::as_bytes(std::span(bytes)));
}

std::string inclusions_sentence(const SpecimenExport& wanted) {
  return counted(std::ssize(wanted.specimen.inclusions), "inclusion");
}

std::string write_csv(const SpecimenExport& wanted) {
  replace_with_text(wanted.path, exchange::inclusion_table(wanted.specimen.inclusions));
  return inclusions_sentence(wanted);
}

std::string write_roi(const SpecimenExport& wanted) {
  const auto rois = exchange::inclusion_rois(wanted.specimen.inclusions, wanted.specimen.mask);
  if (rois.empty())
    throw Rejected(Exit::data, "specimen", "has no inclusions", "there is nothing to outline");
  replace_with_text(wanted.path, exchange::zipped(wanted.path, rois));
  return inclusions_sentence(wanted);
}

template <class T>
specimen::Raster<T> raster_of(const mpm::PixelField<T>& values) {
  specimen::Raster<T> raster(static_cast<int>(values.rows()), static_cast<int>(values.cols()));
  std::copy_n(values.data(), raster.size(), raster.data.begin());
  return raster;
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats{
      {"inp", ".inp", "Abaqus, CalculiX", true, write_inp},
      {"msh", ".msh", "Gmsh, meshio", false, write_msh},
      {"vti", ".vti", "ParaView, VTK", false, write_vti},
      {"png", "_labels.png", "picture of labels", false, write_png},
      {"tif", "_labels.tif", "ImageJ, Fiji", false, write_tif},
      {"csv", "_inclusions.csv", "table of inclusions", false, write_csv},
      {"roi", "_rois.zip", "outlines for ImageJ, Fiji", false, write_roi},
  };
  return formats;
}

std::vector<std::string> write_run_maps(const std::filesystem::path& folder, const RunExport& run) {
  const std::string damage = (folder / "damage.tif").string();
  const std::string strain = (folder / "failure_strain.tif").string();
  specimen::write_imagej_tiff(damage, raster_of(run.result.failure_mode), run.pixel_size);
  specimen::write_imagej_tiff(strain, raster_of(run.result.failure_strain), run.pixel_size);
  return {damage, strain};
}

}  // namespace app
