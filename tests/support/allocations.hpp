#pragma once

namespace trunk::test {

/// How often this program has called operator new so far: allocations.cpp replaces it by one that counts.
long allocations() noexcept;

}  // namespace trunk::test
