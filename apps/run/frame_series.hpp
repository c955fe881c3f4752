/// What ParaView opens to see the frames of a run one after the other.
#pragma once

#include <cstdint>
#include <string>

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
