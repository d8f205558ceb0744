#pragma once

#include <limits>

#include "constraints/resist_flow.hpp"
#include "constraints/volume_root.hpp"

namespace trunk {

/// The result of the projection. The multiplier divided by dt^2 is the pressure p inside the held volume, Pa:
/// the correction dt^2 (p dV/dx) / (m + dt c) is what a force p dV/dx would have added to the step.
template <Scalar S>
struct Projection {
  S multiplier{0.0};
  S pleural{0.0};  // the multiplier of the pleural resistance
  Mask<S> found;   // false if no displacement restores the volume
};

namespace detail {

/// Calculates the direction of the volume correction: dV/dP over the effective mass, along free axes (for
/// equal masses the paper's eq. 2). The gradient is that at the start of the step, as for the forces (our
/// choice; the paper takes it at the predicted positions). Forces and pressure then balance in particles at
/// rest, for any time step.
/// (state, area) => direction, plane
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

/// Returns the volume at next + lambda direction. (next, direction) => coefficients
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

/// Returns true where only round-off is left between the bounds of the multiplier. A particle then touches
/// without any force, and both sides of its support give the same positions.
template <Scalar S>
Mask<S> bracket_is_point(const S& low, const S& high) noexcept {
  const auto size = [](const S& a) { return select(a < S(0.0), -a, a); };
  const S round_off = S(4.0 * std::numeric_limits<double>::epsilon()) * (size(low) + size(high));
  return (high - low) < round_off;
}

/// Puts free bodies back into their shape and restores the volume that this takes. A free body turns, but the
/// correction moved its particles along straight lines; the difference is of second order in a small turn.
/// Returns the corrected multiplier. (body, direction) => next
template <Scalar S>
S restore_rigid_bodies(const Model& model, const S& target, const S& slope, S multiplier,
                       Workspace<S>& w) noexcept {
  constexpr int corrections = 3;  // each leaves about 1e-5 of the error before it
  for (int n = 0; place_corrected_bodies(model, multiplier, w) && n < corrections; ++n) {
    const S volume = enclosed_volume<S>(model.abdomen.triangles, w.next);
    const S change = (target - volume) / slope;
    for_all(w.held_pushed, [&](std::size_t i) { w.next[i] += change * w.direction[i]; });
    multiplier = multiplier + change;
  }
  return multiplier;
}

/// Projects a model without a held volume: contact only. (plane, contact) => next, contact
template <Scalar S>
Projection<S> project_supports(const Model& model, State<S>& state, Workspace<S>& w) noexcept {
  const S none(0.0);
  const Mask<S> everywhere = S(0.0) < S(1.0);
  if (model.friction > 0.0) apply_friction(model, state, w);
  update_touching(model, none, none, everywhere, w, state);
  rest_on_supports(model, state, everywhere, w);
  if (model.friction > 0.0) record_press(model, none, none, w, state);
  return {none, none, everywhere};
}

}  // namespace detail

/// Calculates the areas of the held volume's rings. If its surface is elastic, they came with the forces
/// already.
/// (state) => area
template <Scalar S>
void calc_held_areas(const Model& model, const State<S>& state, Workspace<S>& w) noexcept {
  if (!w.elastic_volume) calc_ring_areas<S>(model.abdomen.rings, state.position, w.reactions.area);
}

/// Solves for positions that enclose the target volume exactly (paper, eq. 2) and cross no support, both
/// together: x = predicted + lambda d, put back on the plane where that is outside, with V(x) = target and
/// the direction d of `calc_direction`. V(x(lambda)) increases with lambda and consists of pieces, each a
/// cubic. The search for the right piece starts from that of the last step and takes the root of each piece;
/// if the root is outside the bracket, it halves the bracket. A lane that has arrived does not change while
/// others search on, so it has the bits that it has alone.
///
/// With a lung, x(lambda) also holds the resistance to the flow (see resist_flow), which depends on the
/// contacts too. Only contacts that hold at a lambda may move the bracket.
/// (next, plane, area) => next, contact
template <Scalar S>
Projection<S> project_volume_and_supports(const Model& model, const S& target, State<S>& state,
                                          Workspace<S>& w) noexcept {
  constexpr int max_searches = 64;
  if (model.abdomen.rings.size() == 0) return detail::project_supports(model, state, w);
  S low(-1e300), high(1e300), multiplier(0.0), slope(1.0);
  Mask<S> searching = w.running;
  detail::calc_direction(model, state, w);
  if (model.friction > 0.0) detail::apply_friction(model, state, w);
  detail::PleuralMultiplier<S> pleural;
  detail::FlowSums<S> free_flow;
  if (w.pleura.present) free_flow = detail::free_flow(state, w);
  for (int search = 0; search < max_searches && any(searching); ++search) {
    detail::rest_on_supports(model, state, searching, w);
    if (w.pleura.present) detail::resist_flow(model, state, searching, free_flow, w, pleural);
    const VolumeCubic<S> cubic = detail::volume_along_direction(w);
    Mask<S> reached = S(1.0) < S(0.0);
    if (search > 0) {
      Mask<S> hold = S(0.0) < S(1.0);
      if (w.pleura.present) hold = detail::contacts_hold(model, multiplier, pleural(multiplier), w, state);
      const S excess = cubic(multiplier) - target;
      low = select(Mask<S>(hold & (excess < S(0.0))), multiplier, low);
      high = select(Mask<S>(hold & (S(0.0) < excess)), multiplier, high);
      // The contacts are those at `multiplier`, so a volume that is right to round-off is the solution.
      const S round_off = S(4.0 * std::numeric_limits<double>::epsilon()) * target;
      reached = hold & (excess < round_off) & (-round_off < excess);
    }
    const S root = solve_volume(cubic, target);
    slope = select(searching, cubic.slope(root), slope);
    const Mask<S> exhausted = detail::bracket_is_point(low, high);
    const Mask<S> accepted = ((low < root) & (root < high)) | exhausted;
    const S next = select(accepted, root, S(0.5) * low + S(0.5) * high);
    multiplier = differentiable_root(select(Mask<S>(searching & !reached), next, multiplier), cubic, target);
    const Mask<S> kept = detail::update_touching(model, multiplier, pleural(multiplier), searching, w, state);
    searching = Mask<S>(searching & !(reached | (accepted & (kept | exhausted))));
  }
  const auto& corrected = w.pleura.present ? w.pleura.solved : w.held_pushed;
  for_all(corrected, [&](std::size_t i) { w.next[i] += multiplier * w.direction[i]; });
  if (model.friction > 0.0) detail::record_press(model, multiplier, pleural(multiplier), w, state);
  multiplier = detail::restore_rigid_bodies(model, target, slope, multiplier, w);
  return {multiplier, pleural(multiplier), Mask<S>(finite(multiplier) & !searching)};
}

}  // namespace trunk
