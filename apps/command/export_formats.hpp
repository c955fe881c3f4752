/// What can be exported: the formats of specimens and of runs, by their names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/export/mesh_files.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// A specimen and how it is wanted.
struct SpecimenExport {
  const specimen::Specimen& specimen;
  std::string path;  ///< of the file to write
  exchange::PlaneElement plane = exchange::PlaneElement::stress;
  std::optional<exchange::ElasticTest> test = {};  ///< of a mesh; none = nothing but the mesh
  std::string of = {};                             ///< whose materials these are
};

/// A format of one file.
struct ExportFormat {
  const char* name;     ///< "inp"
  const char* ending;   ///< of the default name behind that of the specimen: "_labels.png"
  const char* program;  ///< that reads it
  bool is_mesh;         ///< of elements with a plane, materials and a test
  std::string (*write)(const SpecimenExport&);  ///< writes; returns a sentence about what is in it
};

[[nodiscard]] const std::vector<ExportFormat>& export_formats();

/// A result with the size of its pixels [m].
struct RunExport {
  const mpm::Result& result;
  double pixel_size = 0;
};

/// Write damage.tif (0 intact, else the mode of failure) and failure_strain.tif into a folder.
/// @return the names of the files.   @throws specimen::Error (Fault::write).
std::vector<std::string> write_run_maps(const std::filesystem::path& folder, const RunExport& run);

}  // namespace app
