/// The points of a run at one time as a file that ParaView and VTK open: VTKHDF 1.0, an UnstructuredGrid of
/// vertices, one for each point, by rising id.
///
/// Layout, as h5py shows it; N points; every dataset has the attributes unit and meaning:
///   /VTKHDF                  attributes: Version [1, 0], Type "UnstructuredGrid"
///     NumberOfPoints, NumberOfCells, NumberOfConnectivityIds   int64, shape (1), N
///     Points                 float32, shape (N, 3), [m]; where the points are, y upwards, z = 0. With small
///     strain
///                            that is the centre of the pixel and the displacement of the nodes there
///     Connectivity           int64, shape (N): 0 ... N - 1      Offsets   int64, shape (N + 1): 0 ... N
///     Types                  uint8, shape (N): 1 = vertex
///   /VTKHDF/PointData
///     displacement           float32, shape (N, 3), [m]; since the start, finer than the rounding of Points
///     velocity               float32, shape (N, 3), [m/s]; with small strain that of half a step later
///     stress                 float32, shape (N, 9), [Pa]; xx xy xz yx yy yz zx zy zz, what the point
///     carries; zz is
///                            0 in plane stress
///     damage                 float32, shape (N); 0 = intact, 1 = failed
///     phase                  uint8, shape (N); label in the mask
///     id                     int32, shape (N); row * columns + column of the pixel, extra points (ITZ)
///     behind
///   /VTKHDF/FieldData        shape (1): TimeValue [s], strain, and as int64 step and history_row
///     TimeValue and strain are those of the points. A row of result.h5 says them of the beginning of a step:
///     with small strain they are the same, with moving points the frame is at the end of that step.
#pragma once

#include <string>

#include "libmpm/solver/frame.hpp"

namespace mpm {

/// Write a frame: to a temporary name, flushed, closed and renamed. The same frame gives the same bytes.
/// @param scene  whose run it is; it names the phases.   @throws FileError.
void write_frame(const std::string& path, const Frame& frame, const Scene& scene);

/// The numbers of the points have 32 bits, as in the file.
/// @throws FileError naming the file and what is wrong.
[[nodiscard]] Frame read_frame(const std::string& path);

/// When the frame was taken, without its points: to choose among many.   @throws FileError as read_frame
/// does.
[[nodiscard]] Frame read_frame_heading(const std::string& path);

}  // namespace mpm
