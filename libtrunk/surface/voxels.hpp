#pragma once

#include <array>
#include <cstdlib>
#include <vector>

#include "surface/measured_surface.hpp"

namespace trunk {

/// A box of cubes, with a number for each: what a surface encloses, and what belongs together.
class Voxels {
 public:
  using Cell = std::array<int, 3>;

  /// Makes a box around the points of a surface, with empty cells on all sides. The cubes are 3 mm wide, or
  /// wider if the box would have more than 150 of them along an axis (our choice).
  explicit Voxels(const MeasuredSurface& surface);

  double edge() const noexcept { return edge_; }  ///< m
  const Cell& size() const noexcept { return size_; }
  std::size_t count() const noexcept { return values_.size(); }

  std::size_t index(int i, int j, int k) const noexcept {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(i);
  }
  /// Returns the index of the cell that holds a point of the box.
  std::size_t index(const Vec3d& p) const noexcept;
  Vec3d centre(std::size_t index) const noexcept;

  char operator[](std::size_t index) const noexcept { return values_[index]; }
  char& operator[](std::size_t index) noexcept { return values_[index]; }

  /// Returns the cells that are marked, and those within `steps` cells of them. A step goes through faces,
  /// and every second one also through edges and corners, so that the marked cells grow about roundly.
  Voxels grown(int steps) const;
  /// Returns the marked cells that are farther than `steps` cells from all that are not.
  Voxels shrunk(int steps) const;
  /// Returns this with every mark taken away, and every other cell marked.
  Voxels opposite() const;

  /// Calls `visit(index)` for the cells beside one: those behind its faces, or also those at its corners.
  template <class Visit>
  void around(std::size_t at, bool corners, Visit&& visit) const;

  /// Returns the number of the connected set of each marked cell, from 0, and -1 for others. Cells that share
  /// a corner are connected. => sizes, the number of cells of each set
  std::vector<int> sets(std::vector<std::size_t>& sizes) const;

 private:
  Vec3d low_;
  double edge_;
  Cell size_;
  std::vector<char> values_;
};

template <class Visit>
void Voxels::around(std::size_t at, bool corners, Visit&& visit) const {
  const auto width = static_cast<std::size_t>(size_[0]), depth = static_cast<std::size_t>(size_[1]);
  const int i = static_cast<int>(at % width), j = static_cast<int>(at / width % depth),
            k = static_cast<int>(at / (width * depth));
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int faces = std::abs(x) + std::abs(y) + std::abs(z);
        if (faces == 0 || (!corners && faces > 1)) continue;
        if (i + x < 0 || i + x >= size_[0] || j + y < 0 || j + y >= size_[1] || k + z < 0 ||
            k + z >= size_[2])
          continue;
        visit(index(i + x, j + y, k + z));
      }
}

/// Returns the cells that a surface touches or encloses. Holes that are narrower than a cell let nothing in.
Voxels solid_within(const MeasuredSurface& surface);

}  // namespace trunk
