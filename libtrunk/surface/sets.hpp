#pragma once

#include <numeric>
#include <vector>

/// Private to the surface layer.
namespace trunk {

/// Disjoint sets that can be joined (union-find with path halving).
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    for (auto* p = &parent_[static_cast<std::size_t>(i)]; *p != i; p = &parent_[static_cast<std::size_t>(i)])
      i = *p = parent_[static_cast<std::size_t>(*p)];
    return i;
  }
  void join(int a, int b) { parent_[static_cast<std::size_t>(find(a))] = find(b); }

 private:
  std::vector<int> parent_;
};

}  // namespace trunk
