#include "dynamics/kernel.hpp"

namespace trunk {

extern const Kernel kernel_baseline;
#ifdef TRUNK_X86_KERNELS
extern const Kernel kernel_avx2, kernel_avx512;
#endif

std::span<const Kernel* const> kernels() {
  static const std::vector<const Kernel*> runnable = [] {
    std::vector<const Kernel*> all{&kernel_baseline};
#ifdef TRUNK_X86_KERNELS
    // What kernels.cmake lets the compiler use. clang 14 does not know the names of whole levels (x86-64-v3).
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2");
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512vl");
    if (avx2) all.push_back(&kernel_avx2);
    if (avx512) all.push_back(&kernel_avx512);
#endif
    return all;
  }();
  return runnable;
}

const Kernel& kernel() {
  static const Kernel& best = *kernels().back();
  return best;
}

}  // namespace trunk
