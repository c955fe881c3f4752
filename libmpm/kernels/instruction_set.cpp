#include "libmpm/kernels/instruction_set.hpp"

#include <string>

#include "libmpm/scene/error.hpp"

namespace mpm {

std::vector<const kernels::Kernels*> available_kernels() {
  std::vector<const kernels::Kernels*> available;
#ifdef MPM_WIDE_KERNELS
  // x86-64-v4 and x86-64-v3, by the features that the compiler may use in them.
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                  __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  if (v4) available.push_back(&kernels::avx512);
  if (v3) available.push_back(&kernels::avx2);
#endif
  available.push_back(&kernels::baseline);
  return available;
}

const kernels::Kernels& chosen_kernels(std::string_view name) {
  const auto available = available_kernels();
  if (name.empty()) return *available.front();
  std::string names;
  for (const auto* kernels : available) {
    if (name == kernels->name) return *kernels;
    names += (names.empty() ? "" : ", ") + std::string(kernels->name);
  }
  throw Error("solver.instruction_set", std::string(name), "this processor supports " + names);
}

const equilibrium::Kernels& chosen_equilibrium_kernels(std::string_view name) {
  const kernels::Kernels& same = chosen_kernels(name);
#ifdef MPM_WIDE_KERNELS
  if (&same == &kernels::avx512) return equilibrium::avx512;
  if (&same == &kernels::avx2) return equilibrium::avx2;
#endif
  (void)same;
  return equilibrium::baseline;
}

const moving::Kernels& chosen_moving_kernels(std::string_view name) {
  const kernels::Kernels& same = chosen_kernels(name);
#ifdef MPM_WIDE_KERNELS
  if (&same == &kernels::avx512) return moving::avx512;
  if (&same == &kernels::avx2) return moving::avx2;
#endif
  (void)same;
  return moving::baseline;
}

}  // namespace mpm
