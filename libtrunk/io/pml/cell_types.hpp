#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace trunk::pml {

struct CellType {
  std::string_view name;
  std::size_t least_atoms, most_atoms;
};

inline constexpr std::size_t any_number = static_cast<std::size_t>(-1);
/// The geometric types of PML, with the number of atoms that each allows.
inline constexpr std::array<CellType, 9> cell_types{{{"LINE", 2, 2},
                                                     {"TRIANGLE", 3, 3},
                                                     {"QUAD", 4, 4},
                                                     {"TETRAHEDRON", 4, 4},
                                                     {"PYRAMID", 5, 5},
                                                     {"WEDGE", 6, 6},
                                                     {"HEXAHEDRON", 8, 8},
                                                     {"POLY_LINE", 1, any_number},
                                                     {"POLY_VERTEX", 1, any_number}}};

/// Returns the type of that name, or nullptr if there is none.
constexpr const CellType* find_cell_type(std::string_view name) noexcept {
  const auto at = std::find_if(cell_types.begin(), cell_types.end(),
                               [&](const CellType& type) { return type.name == name; });
  return at == cell_types.end() ? nullptr : &*at;
}

}  // namespace trunk::pml
