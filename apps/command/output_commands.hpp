/// mesopix inspect: what is in a file.
/// What can be exported: the formats of specimens and of runs, by their names.
/// mesopix export: specimens and runs in the formats of other programs.
/// mesopix plot: pictures of a run for papers and slides.
/// mesopix report: several runs on one page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/export/mesh_files.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

class InspectCommand : public Command {
 public:
  explicit InspectCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::string file_;
  bool json_ = false;
};

/// A specimen and how it is wanted.
struct SpecimenExport {
  const specimen::Specimen& specimen;
  std::string path;  ///< of the file to write
  exchange::PlaneElement plane = exchange::PlaneElement::stress;
};

/// A format of one file.
struct ExportFormat {
  const char* name;         ///< "inp"
  const char* ending;       ///< of the default name behind that of the specimen: "_labels.png"
  const char* program;      ///< that reads it
  bool has_plane_elements;  ///< stress and strain differ
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

class ExportCommand : public Command {
 public:
  explicit ExportCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  void tell(const std::vector<std::string>& files, Console& console) const;
  Exit export_run(const std::string& result_file, Console& console) const;

  std::string input_;
  std::string format_;
  std::string output_;
  std::string plane_;
  bool json_ = false;
  bool quiet_ = false;
};

class PlotCommand : public Command {
 public:
  explicit PlotCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  /// An option of some of the kinds of pictures.
  struct Special {
    CLI::Option* option;
    std::vector<std::string> fits;
  };
  void add(const char* name, std::string& text, Form form, const char* help, std::vector<std::string> fits);
  void check_fit() const;

  std::vector<Special> special_;
  std::string run_;
  std::string what_ = "damage";
  std::string at_ = "100%peak";
  std::string look_ = "grey";
  std::string component_ = "yy";
  std::string range_ = "auto";
  std::string output_;
  bool json_ = false;
  bool quiet_ = false;
};

class ReportCommand : public Command {
 public:
  explicit ReportCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  std::vector<std::string> runs_;
  std::string output_ = "comparison.html";
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
