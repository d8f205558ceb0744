#pragma once

#include <limits>

#include "constraints/contact.hpp"
#include "constraints/volume_root.hpp"

namespace trunk {

/// What the projection reports. The multiplier divided by dt^2 is the pressure inside the held volume, Pa:
/// the correction dt^2 (p dV/dx) / (m + dt c) is what a force p dV/dx would have added to the step.
template <Scalar S>
struct Projection {
  S multiplier{0.0};
  Mask<S> found;  // false where no displacement restores the volume
};

namespace detail {

/// The volume correction: dV/dP over the effective mass (the paper's eq. 2 for equal masses) along free axes,
/// at the start of the step, where the forces are taken too (our choice; the paper takes it at the predicted
/// positions): particles at rest then balance forces and pressure whatever the time step. (state, area) =>
/// direction, plane
template <Scalar S>
void calc_direction(const Model& model, const State<S>& state, Workspace<S>& w) noexcept {
  for_all(w.held_pushed, [&](std::size_t i) {
    w.direction[i] = hadamard(w.push_weight[i], S(1.0 / 6.0) * w.reactions.area[i]);
  });
  calc_body_directions(model, state, w);
  for (std::size_t s = 0; s < model.supports.size(); ++s) {
    auto& plane = w.plane[s];
    plane.direction = w.direction[static_cast<std::size_t>(model.supports[s].particle)];
    plane.rate = dot(plane.normal, plane.direction);
  }
}

/// Volume at next + lambda direction. (next, direction) => coefficients
template <Scalar S>
VolumeCubic<S> volume_along_direction(const Workspace<S>& w) noexcept {
  Vec3<S> c0, c1, c2, c3;
  for_each_ring(w.held_fans, [&]<std::size_t Valence>(std::size_t, std::size_t centre,
                                                      std::span<const Neighbour, Valence> polygon) {
    const Vec3<S> x = w.next[centre], d = w.direction[centre];
    const AreaAlong<S> area = twice_area_along<S>(RingPositions<S, Valence>{polygon, w.next},
                                                  RingPositions<S, Valence>{polygon, w.direction});
    c0 += hadamard(area.at, x);
    c1 += hadamard(area.at, d) + hadamard(area.change, x);
    c2 += hadamard(area.along, x) + hadamard(area.change, d);
    c3 += hadamard(area.along, d);
  });
  const auto sixth = [](const Vec3<S>& a) { return S(1.0 / 6.0) * (a.x() + a.y() + a.z()); };
  return {S(w.held_still) + sixth(c0), sixth(c1), sixth(c2), sixth(c3)};
}

/// True where no multiplier fits between the bounds but round-off: a particle touches without any force, and
/// both sides of its support give the same positions.
template <Scalar S>
Mask<S> bracket_is_point(const S& low, const S& high) noexcept {
  const auto size = [](const S& a) { return select(a < S(0.0), -a, a); };
  const S round_off = S(4.0 * std::numeric_limits<double>::epsilon()) * (size(low) + size(high));
  return (high - low) < round_off;
}

/// Free bodies turn where the correction of their particles was straight: they are put back to their shape,
/// and the volume that this takes, of second order in a small turn, is restored. (body, direction) => next
template <Scalar S>
S restore_rigid_bodies(const Model& model, const S& target, const S& slope, S multiplier,
                       Workspace<S>& w) noexcept {
  constexpr int corrections = 3;  // each leaves about 1e-5 of the one before
  for (int n = 0; place_corrected_bodies(model, multiplier, w) && n < corrections; ++n) {
    const S volume = enclosed_volume<S>(model.abdomen.triangles, w.next);
    const S change = (target - volume) / slope;
    for_all(w.held_pushed, [&](std::size_t i) { w.next[i] += change * w.direction[i]; });
    multiplier = multiplier + change;
  }
  return multiplier;
}

/// Nothing holds this body's volume: contact alone. (plane, contact) => next, contact
template <Scalar S>
Projection<S> project_supports(const Model& model, State<S>& state, Workspace<S>& w) noexcept {
  const S none(0.0);
  const Mask<S> everywhere = S(0.0) < S(1.0);
  if (model.friction > 0.0) apply_friction(model, state, w);
  update_touching(model, none, everywhere, w, state);
  rest_on_supports(model, state, everywhere, w);
  if (model.friction > 0.0) record_press(model, none, w, state);
  return {none, everywhere};
}

}  // namespace detail

/// The areas of the held volume's rings where its surface is not elastic: else they came with the forces.
/// (state) => area
template <Scalar S>
void calc_held_areas(const Model& model, const State<S>& state, Workspace<S>& w) noexcept {
  if (!w.elastic_volume) calc_ring_areas<S>(model.abdomen.rings, state.position, w.reactions.area);
}

/// Solves for positions that enclose the target volume exactly (paper, eq. 2) and cross no support, together:
/// x = predicted + lambda d, put back on the plane where that is outside, with V(x) = target, and d the
/// direction of `calc_direction`. V(x(lambda)) increases with lambda piece by piece, a cubic each; the search
/// for the right piece starts from the last step's, takes the root of each piece, and halves the bracket
/// where that leaves it. A lane that has arrived stays as it is while others search on: it does what it would
/// do alone. (next, plane, area) => next, contact
template <Scalar S>
Projection<S> project_volume_and_supports(const Model& model, const S& target, State<S>& state,
                                          Workspace<S>& w) noexcept {
  constexpr int max_searches = 64;
  if (model.abdomen.rings.size() == 0) return detail::project_supports(model, state, w);
  S low(-1e300), high(1e300), multiplier(0.0), slope(1.0);
  Mask<S> searching = w.running;
  detail::calc_direction(model, state, w);
  if (model.friction > 0.0) detail::apply_friction(model, state, w);
  for (int search = 0; search < max_searches && any(searching); ++search) {
    detail::rest_on_supports(model, state, searching, w);
    const VolumeCubic<S> cubic = detail::volume_along_direction(w);
    Mask<S> reached = S(1.0) < S(0.0);
    if (search > 0) {
      const S excess = cubic(multiplier) - target;
      low = select(excess < S(0.0), multiplier, low);
      high = select(S(0.0) < excess, multiplier, high);
      // The contacts are those at `multiplier`: where the volume is right to round-off, this is the solution.
      const S round_off = S(4.0 * std::numeric_limits<double>::epsilon()) * target;
      reached = (excess < round_off) & (-round_off < excess);
    }
    const S root = solve_volume(cubic, target);
    slope = select(searching, cubic.slope(root), slope);
    const Mask<S> exhausted = detail::bracket_is_point(low, high);
    const Mask<S> accepted = ((low < root) & (root < high)) | exhausted;
    const S next = select(accepted, root, S(0.5) * low + S(0.5) * high);
    multiplier = differentiable_root(select(Mask<S>(searching & !reached), next, multiplier), cubic, target);
    const Mask<S> kept = detail::update_touching(model, multiplier, searching, w, state);
    searching = Mask<S>(searching & !(reached | (accepted & (kept | exhausted))));
  }
  for_all(w.held_pushed, [&](std::size_t i) { w.next[i] += multiplier * w.direction[i]; });
  if (model.friction > 0.0) detail::record_press(model, multiplier, w, state);
  multiplier = detail::restore_rigid_bodies(model, target, slope, multiplier, w);
  return {multiplier, Mask<S>(finite(multiplier) & !searching)};
}

}  // namespace trunk
