#include "apps/calibrate/bounded_minimum.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace app {
namespace {

constexpr double resolution = 1e-7;
constexpr int most_evaluations = 5000;

struct Destroy {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, Destroy>;

/// What the C library is handed: it must see no exception.
struct Call {
  const std::function<double(const std::vector<double>&)>& function;
  nlopt_opt optimizer;
  std::exception_ptr thrown;
};

extern "C" double mesopix_evaluate(unsigned count, const double* x, double* /*gradient*/, void* data) {
  Call& call = *static_cast<Call*>(data);
  try {
    return call.function(std::vector<double>(x, x + count));
  } catch (...) {
    call.thrown = std::current_exception();
    nlopt_force_stop(call.optimizer);
    return std::numeric_limits<double>::infinity();
  }
}

}  // namespace

std::vector<double> bounded_minimum(const Box& box,
                                    const std::function<double(const std::vector<double>&)>& function) {
  const Optimizer optimizer(nlopt_create(NLOPT_LN_BOBYQA, static_cast<unsigned>(box.start.size())));
  if (!optimizer) throw std::bad_alloc();
  Call call{function, optimizer.get(), nullptr};
  nlopt_set_min_objective(optimizer.get(), mesopix_evaluate, &call);
  nlopt_set_lower_bounds(optimizer.get(), box.low.data());
  nlopt_set_upper_bounds(optimizer.get(), box.high.data());
  nlopt_set_xtol_abs1(optimizer.get(), resolution);
  nlopt_set_maxeval(optimizer.get(), most_evaluations);
  std::vector<double> x = box.start;
  double least = 0;
  const nlopt_result result = nlopt_optimize(optimizer.get(), x.data(), &least);
  if (call.thrown) std::rethrow_exception(call.thrown);
  if (result < 0 && result != NLOPT_ROUNDOFF_LIMITED)  // then it is as good as numbers allow
    throw std::runtime_error(
        fmt::format("the search for a minimum failed: {}", nlopt_result_to_string(result)));
  return x;
}

std::string name_of_minimizer() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  nlopt_version(&major, &minor, &patch);
  return fmt::format("BOBYQA (NLopt {}.{}.{})", major, minor, patch);
}

}  // namespace app
