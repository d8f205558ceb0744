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
    if (__builtin_cpu_supports("x86-64-v3")) all.push_back(&kernel_avx2);
    if (__builtin_cpu_supports("x86-64-v4")) all.push_back(&kernel_avx512);
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
