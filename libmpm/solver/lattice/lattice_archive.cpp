// The state of a run at small strain, into an archive and out of it.
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/lattice/lattice_solver.hpp"

namespace mpm {
namespace {

/// What sets points apart from intact ones: few have failed for most of a run.
template <class Real>
struct ChangedPoints {
  std::vector<std::uint64_t> at;  ///< rising
  std::vector<Real> stiffness, shear;
  std::vector<float> tension, crush, cracked;
};

template <class Archive, class Changed>
void pass_changed(Archive& archive, Changed& changed) {
  archive.list(changed.at);
  archive.list(changed.stiffness);
  archive.list(changed.shear);
  archive.list(changed.tension);
  archive.list(changed.crush);
  archive.list(changed.cracked);
}

template <class T>
bool differs(const AlignedVector<T>& a, const AlignedVector<T>& b, std::size_t at) {
  return !a.empty() && std::memcmp(&a[at], &b[at], sizeof(T)) != 0;
}

template <class Real>
ChangedPoints<Real> changes(const LatticePoints<Real>& points, const LatticePoints<Real>& intact) {
  ChangedPoints<Real> changed;
  const auto keep = [](const auto& field, auto& values, std::size_t at) {
    if (!field.empty()) values.push_back(field[at]);
  };
  for (std::size_t at = 0; at < points.stiffness.size(); ++at) {
    if (!differs(points.stiffness, intact.stiffness, at) && !differs(points.shear, intact.shear, at) &&
        !differs(points.tension, intact.tension, at) && !differs(points.crush, intact.crush, at) &&
        !differs(points.cracked, intact.cracked, at))
      continue;
    changed.at.push_back(at);
    keep(points.stiffness, changed.stiffness, at);
    keep(points.shear, changed.shear, at);
    keep(points.tension, changed.tension, at);
    keep(points.crush, changed.crush, at);
    keep(points.cracked, changed.cracked, at);
  }
  return changed;
}

/// @param points  intact ones.
template <class Real>
void change(LatticePoints<Real>& points, const ChangedPoints<Real>& changed, ArchiveReader& archive) {
  for (const std::uint64_t at : changed.at)
    if (at >= points.stiffness.size()) return archive.fail("a point outside the specimen");
  const auto put = [&](const auto& values, auto& field) {
    if (values.size() != (field.empty() ? 0 : changed.at.size()))
      return archive.fail("points of another kind");
    for (std::size_t i = 0; i < values.size(); ++i) field[changed.at[i]] = values[i];
  };
  put(changed.stiffness, points.stiffness);
  put(changed.shear, points.shear);
  put(changed.tension, points.tension);
  put(changed.crush, points.crush);
  put(changed.cracked, points.cracked);
}

/// What an extra point has gone through.
template <class Archive, class State>
void pass_state(Archive& archive, State& state) {
  archive.raw(&state.strength, 1);  // infinite for a point that does not crack
  archive.finite(state.kept);
  archive.finite(state.cracked);
  archive.flag(state.spent);
}

}  // namespace

/// All but the points. Left out is what the next step makes anew, sums of single steps among it, and the work
/// of the bottom platen, which stands still.
template <class Real>
template <class Archive, class Self>
void LatticeSolver<Real>::pass(Archive& archive, Self& self) {
  archive.whole(self.clock_.step, 1, self.plan_.steps + 1);
  for (auto* number :
       {&self.clock_.displacement, &self.clock_.next_velocity, &self.top_.force, &self.top_.work})
    archive.finite(*number);
  for (auto* field : {&self.grid_.ux, &self.grid_.uy, &self.grid_.vx, &self.grid_.vy}) archive.block(*field);
  archive.block(self.row_released_);
  archive.block(self.row_damped_);
  for (auto& point : self.extra_.points) pass_state(archive, point.state);
  pass_maps(archive, self.maps_);
}

template <class Real>
void LatticeSolver<Real>::save(ArchiveWriter& archive) const {
  pass(archive, *this);
  const ChangedPoints<Real> changed = changes(points_, make_points<Real>(scene_, plan_, factors_));
  pass_changed(archive, changed);
  Band sum;
  for (const Band& band : bands_) {
    sum.tension_failures += band.tension_failures;
    sum.shear_failures += band.shear_failures;
    sum.dead += band.dead;
  }
  for (const std::int64_t count : {sum.tension_failures, sum.shear_failures, sum.dead})
    archive.whole(count, 0, all_points_);
}

template <class Real>
void LatticeSolver<Real>::restore(ArchiveReader& archive) {
  pass(archive, *this);
  ChangedPoints<Real> changed;
  pass_changed(archive, changed);
  change(points_, changed, archive);
  // The counts of all bands together, whatever their number was.
  Band& band = bands_.front();
  for (std::int64_t* count : {&band.tension_failures, &band.shear_failures, &band.dead})
    archive.whole(*count, 0, all_points_);
}

template class LatticeSolver<float>;
template class LatticeSolver<double>;

}  // namespace mpm
