/// The frames of a run in its folder, written while the run goes on, and the lists of them for ParaView.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "libmpm/scene/error.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "libmpm/solver/frame.hpp"

namespace output {

/// "p_000012.hdf": by the number of the frame, 0 = the start.
[[nodiscard]] std::string frame_name(std::int64_t number);
/// Whether frame_name() gives this name for some number.
[[nodiscard]] bool is_frame_name(const std::string& name);

/// A frame as the lists name it.
struct FrameEntry {
  std::string path;         ///< from the folder of the list
  double time = 0;          ///< [s]
  std::int64_t points = 0;  ///< in it
};

/// ParaView's list of files with their times, file-series-version 1.0 (JSON).
class FrameSeries {
 public:
  void add(const FrameEntry& frame);
  [[nodiscard]] std::string text() const;

 private:
  std::string files_;
};

/// The same frames for whatever reads XDMF 3.0: a temporal collection of Polyvertex grids, whose numbers stay
/// in the files of the frames. A frame without points is left out: readers take it for an error.
class FrameXdmf {
 public:
  void add(const FrameEntry& frame);
  [[nodiscard]] std::string text() const;

 private:
  std::string grids_;
};

}  // namespace output

namespace app {

/// In the folder of a run, for ParaView and for pictures of the stress:
///   frames/p_000000.hdf, p_000001.hdf ...   one a frame, by number (mpm::write_frame); 0 = the start
///   frames.hdf.series                       their list: what ParaView opens
///   frames.xdmf                             the same, for programs that read XDMF
/// Both lists are written anew with every frame, so that they are complete however the run ends. A frame that
/// the disk does not take is left out of them, and its number with it: there may be space for the next.
class FrameFolder {
 public:
  /// Removes the frames and lists of an earlier run. The folder must be there; the scene must outlive this.
  /// @param taken  frames of an earlier part of this run, which stay, and after which it goes on.
  /// @param digest  of the run, which every frame carries; empty = none.
  /// @throws mpm::FileError when a frame cannot be removed, or one that was taken is not there any more.
  FrameFolder(std::filesystem::path run, const mpm::Scene& scene,
              const std::vector<mpm::FrameTaken>& taken = {}, std::string digest = {});

  /// Never throws because the disk fails.   @return whether the frame and both lists were written.
  bool add(const mpm::Frame& frame);

  [[nodiscard]] std::int64_t count() const { return written_; }  ///< of those that were written
  /// What failed first, and how many frames are missing; none where all were written.
  [[nodiscard]] std::optional<mpm::FileError> failure() const;
  /// The list that ParaView opens.
  [[nodiscard]] std::filesystem::path series() const;

 private:
  [[nodiscard]] std::set<std::string> take_over(const std::vector<mpm::FrameTaken>& taken);
  void write(const mpm::Frame& frame, std::int64_t number);
  void add_to_lists(std::int64_t number, double time, std::int64_t points);
  void write_lists() const;

  std::filesystem::path run_;
  const mpm::Scene& scene_;
  std::string digest_;
  std::int64_t added_ = 0, written_ = 0;
  std::optional<mpm::FileError> failure_;
  output::FrameSeries list_;
  output::FrameXdmf xdmf_;
};

/// The frames in the folder of a run, by number; none where there are none.
[[nodiscard]] std::vector<std::filesystem::path> frames_of(const std::filesystem::path& run);

}  // namespace app
