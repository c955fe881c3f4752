#include "libmpm/solver/moving/moving_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {

template <class Real>
bool MovingSolver<Real>::is_done() const {
  if (!failure_.empty()) return true;
  if (scene_.loading.direction == Direction::none) return reported_time_ >= scene_.loading.duration;
  return std::abs(reported_displacement_) >= scene_.loading.stop_strain * scene_.height();
}

template <class Real>
Ledger MovingSolver<Real>::advance(std::int64_t steps) {
  clock_.stopped = false;
  share_rows();
  Barrier barrier(static_cast<int>(bands_.size()));
  team_.share(team_.threads(), [&](int band) { run_band(static_cast<std::size_t>(band), steps, barrier); });
  return balance();
}

template <class Real>
void MovingSolver<Real>::run_band(std::size_t index, std::int64_t steps, Barrier& barrier) {
  const FlushToZero flush;
  Band& band = bands_[index];
  for (std::int64_t i = 0; i < steps; ++i) {
    if (index == 0) begin_step();
    barrier.arrive_and_wait();
    band.fastest = 0;
    if (scene_.motion.scheme == Scheme::usf)
      step_usf(band, barrier);
    else if (plan_.moving.mapped_back)
      step_musl(band, barrier);
    else
      step_usl(band, barrier);
    barrier.arrive_and_wait();
    if (index == 0) end_step();
    barrier.arrive_and_wait();
    if (clock_.stopped) return;
  }
}

template <class Real>
void MovingSolver<Real>::begin_step() {
  choose_time_step();
  const double height = cell_height(clock_.displacement);
  if (scene_.loading.direction != Direction::none) {
    const double sign = scene_.loading.direction == Direction::tension ? 1.0 : -1.0;
    supports_.top.before = clock_.velocity;
    clock_.velocity = sign * scene_.loading.velocity * ramp(plan_, clock_.time + 0.5 * clock_.dt);
    supports_.top.velocity = clock_.velocity;
  }
  step_.hy = static_cast<Real>(height);
  step_.dt = static_cast<Real>(clock_.dt);
  // What a step stretches is less than the rounding of 1 in 32 bits.
  const double stretch = clock_.dt * clock_.velocity / geometry_.cells_y;
  step_.hy_after = static_cast<Real>(height + stretch);
  step_.shrinkage = static_cast<Real>(-stretch / (height + stretch));
}

/// From the fastest wave in what still carries load and the fastest point. A step may shrink at once and
/// grows by a twentieth at most.
template <class Real>
void MovingSolver<Real>::choose_time_step() {
  double wave = 0;
  for (std::size_t label = 0; label < live_.size(); ++label)
    if (live_[label] > 0) wave = std::max(wave, speeds_[label]);
  Real fastest = start_fastest_;
  for (const Band& band : bands_) fastest = std::max(fastest, band.fastest);
  start_fastest_ = 0;
  if (!(wave > 0)) wave = *std::max_element(speeds_.begin(), speeds_.end());
  const double size = std::min(plan_.cell_size, cell_height(clock_.displacement));
  const double dt = scene_.cfl * damped_share(scene_.local_damping) * size /
                    (wave + std::sqrt(static_cast<double>(fastest)));
  clock_.dt = clock_.dt > 0 ? std::min(dt, 1.05 * clock_.dt) : dt;
  if (first_dt_ <= 0) first_dt_ = clock_.dt;
}

template <class Real>
void MovingSolver<Real>::end_step() {
  resort();
  Impulses sum;
  for (Impulses& row : row_impulses_) {
    sum.bottom += row.bottom;
    sum.top += row.top;
    sum.work += row.work;
    row = {};
  }
  force_bottom_ = sum.bottom / clock_.dt;
  force_top_ = sum.top / clock_.dt;
  sums_ = start_;
  for (Band& band : bands_) {
    sums_.tension_failures += band.tension_failures;
    sums_.shear_failures += band.shear_failures;
    for (std::size_t label = 0; label < live_.size(); ++label)
      live_[label] -= std::exchange(band.failed[label], 0);
  }
  start_.platen_work += sum.work;
  sums_.platen_work = start_.platen_work;
  reported_displacement_ = clock_.displacement;
  reported_time_ = clock_.time;
  clock_.displacement += clock_.dt * clock_.velocity;
  clock_.time += clock_.dt;
  ++clock_.step;
  if (!(clock_.dt > 1e-6 * first_dt_))
    stop("the time step has collapsed; the fastest point is " + worst_point() + "; try a smaller solver.cfl");
  clock_.stopped = is_done();
}

/// Three sweeps over the rows of tiles of a band, each as soon as the nodes that it reads are there: so close
/// behind each other that a row is still in the cache when the next sweep comes to it. The lowest rows of
/// nodes are those of the band below too; what waits for them waits for all threads.
///   tiles_1(row) -> nodes_1(row) -> tiles_2(row) -> nodes_2(row) -> tiles_3(row)
/// The node row k is there when the rows of tiles k - reach + 1 to k are; a row of tiles k reads the rows of
/// nodes k to k + reach - 1.
template <class Real>
template <class Tiles1, class Nodes1, class Tiles2, class Nodes2, class Tiles3>
void MovingSolver<Real>::sweep_in_waves(Band& band, Barrier& barrier, Tiles1&& tiles_1, Nodes1&& nodes_1,
                                        Tiles2&& tiles_2, Nodes2&& nodes_2, Tiles3&& tiles_3) {
  const auto for_rows = [](int begin, int end, auto&& sweep) {
    for (int row = begin; row < end; ++row) sweep(row);
  };
  const int lag = geometry_.reach - 1;
  const int begin = band.begin;
  const int end = band.end;
  // From here on nodes_1 needs no other band, and from there nodes_2.
  const int own_1 = begin > 0 ? begin + lag : 0;
  const int own_2 = begin > 0 ? begin + 2 * lag : 0;
  for (int row = begin; row < end; ++row) {
    tiles_1(row);
    if (row >= own_1) nodes_1(row);
    if (row - lag >= own_1) tiles_2(row - lag);
    if (row - lag >= own_2) nodes_2(row - lag);
    if (row - 2 * lag >= own_2) tiles_3(row - 2 * lag);
  }
  const int done_2 = std::max(own_1, end - lag);
  const int done_3 = std::max(own_2, end - 2 * lag);
  const auto shared_nodes = [&](auto&& sweep) {
    for_rows(begin, own_1, sweep);
    if (end == geometry_.tiles_y) for_rows(std::max(end, own_1), geometry_.nodes_y, sweep);
  };
  barrier.arrive_and_wait();
  shared_nodes(nodes_1);
  barrier.arrive_and_wait();
  for_rows(begin, own_1, tiles_2);
  for_rows(done_2, end, tiles_2);
  for_rows(own_1, std::min(own_2, end), nodes_2);
  for_rows(std::max(own_2, done_2), end, nodes_2);
  barrier.arrive_and_wait();
  shared_nodes(nodes_2);
  barrier.arrive_and_wait();
  for_rows(begin, std::min(own_2, end), tiles_3);
  for_rows(done_3, end, tiles_3);
}

template <class Real>
void MovingSolver<Real>::step_musl(Band& band, Barrier& barrier) {
  sweep_in_waves(
      band, barrier, [&](int row) { scatter(sweeps_.scatter, row); },
      [&](int row) {
        sum_momentum(row);
        integrate_momentum(row);
        if (slopes_from_straining_) choose_straining_velocity(row);
      },
      [&](int row) { gather(sweeps_.gather_and_map_back, band, row); },
      [&](int row) { sum_new_momentum(row); }, [&](int row) { follow(sweeps_.strain_and_move, band, row); });
}

template <class Real>
void MovingSolver<Real>::step_usl(Band& band, Barrier& barrier) {
  sweep_in_waves(
      band, barrier, [&](int row) { scatter(sweeps_.scatter, row); },
      [&](int row) {
        sum_momentum(row);
        integrate_momentum(row);
        choose_straining_velocity(row);
      },
      [&](int row) { gather(sweeps_.gather, band, row); }, [](int) {},
      [&](int row) { follow(sweeps_.strain_and_move, band, row); });
}

template <class Real>
void MovingSolver<Real>::step_usf(Band& band, Barrier& barrier) {
  sweep_in_waves(
      band, barrier, [&](int row) { scatter(sweeps_.scatter_momentum, row); },
      [&](int row) {
        sum_momentum(row);
        choose_brought_velocity(row);
      },
      [&](int row) {
        follow(sweeps_.strain, band, row);
        scatter(sweeps_.scatter_force, row);
      },
      [&](int row) {
        integrate_momentum(row);
        if (slopes_from_straining_) choose_straining_velocity(row);
      },
      [&](int row) {
        gather(sweeps_.gather, band, row);
        follow(sweeps_.move, band, row);
      });
}

template <class Real>
void MovingSolver<Real>::stop(std::string what) {
  if (failure_.empty()) failure_ = std::move(what);
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
