/// Frames as files for ParaView and VTK: VTKHDF 1.0, an UnstructuredGrid with one vertex per point, by
/// increasing id.
///
/// Layout, for N points; every dataset has the attributes unit and meaning:
///   /VTKHDF                  attributes: Version [1, 0], Type "UnstructuredGrid"
///     NumberOfPoints, NumberOfCells, NumberOfConnectivityIds   int64, shape (1), N
///     Points                 float32, shape (N, 3), [m]; positions, y upwards, z = 0. With small strain the
///                            centre of the pixel plus the displacement there
///     Connectivity           int64, shape (N): 0 ... N - 1      Offsets   int64, shape (N + 1): 0 ... N
///     Types                  uint8, shape (N): 1 = vertex
///   /VTKHDF/PointData
///     displacement           float32, shape (N, 3), [m]; since the start, more precise than Points
///     velocity               float32, shape (N, 3), [m/s]; with small strain, half a step later
///     stress                 float32, shape (N, 9), [Pa]; xx xy xz yx yy yz zx zy zz, as the point carries
///     it;
///                            zz is 0 in plane stress
///     damage                 float32, shape (N); 0 = intact, 1 = failed
///     phase                  uint8, shape (N); label in the mask
///     id                     int32, shape (N); row * columns + column of the pixel; extra points (ITZ)
///     follow
///   /VTKHDF/FieldData        shape (1): TimeValue [s], strain, and as int64 step and history_row
///     TimeValue and strain belong to the points. A row of result.h5 has those at the beginning of a step:
///     with small strain they are the same; with moving points the frame is at the end of that step.
///   attribute run of the file, where there is one: text from the caller
#pragma once

#include <string>

#include "libmpm/solver/frame.hpp"

namespace mpm {

/// Write a frame to a temporary name, flush, close and rename it. The same frame gives the same bytes.
/// @param scene  the scene of the run; it names the phases.   @throws FileError.
/// @param run  by which the caller knows the run; empty = nothing.
void write_frame(const std::string& path, const Frame& frame, const Scene& scene,
                 const std::string& run = {});

/// Read a frame. Values of points have the 32-bit precision of the file.
/// @throws FileError naming the file and the fault.
[[nodiscard]] Frame read_frame(const std::string& path);

/// Read step, time, strain, row and run of a frame without its points, to choose among many frames.
/// @throws FileError as read_frame().
[[nodiscard]] Frame read_frame_heading(const std::string& path);

}  // namespace mpm
