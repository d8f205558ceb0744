#include "math/lanes.hpp"

#include <cmath>
#include <cstring>

#include "support/allocations.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

using Four = Lanes<4>;

/// Everything that changes and everything that is reported, in one lane.
template <Scalar S>
void append_numbers(const State<S>& state, const StepReport<S>& report, int lane,
                    std::vector<double>& numbers) {
  const auto append = [&](const Vec3<S>& a) {
    for (const S& number : {a.x(), a.y(), a.z()}) numbers.push_back(in_lane(number, lane));
  };
  for (const Vec3<S>& x : state.position) append(x);
  for (const Vec3<S>& x : state.previous) append(x);
  for (const auto& contact : state.contact) {
    numbers.push_back(in_lane(contact.touching, lane));
    numbers.push_back(in_lane(contact.sticking, lane));
    numbers.push_back(in_lane(contact.press, lane));
  }
  for (const auto& body : state.body) {
    append(body.pose.centre);
    append(body.pose.rotation.v);
    append(body.velocity);
    append(body.angular_momentum);
  }
  numbers.push_back(in_lane(state.lung_gain, lane));
  numbers.push_back(in_lane(report.pressure_Pa, lane));
  numbers.push_back(in_lane(report.pleural_pressure_Pa, lane));
  numbers.push_back(in_lane(report.ok, lane));
}

struct History {
  Ending ending;
  std::vector<std::vector<double>> steps;  // until the simulation ended
};

template <Scalar S>
std::vector<History> histories(const Model& model, const std::vector<Trial<double>>& trials,
                               const TimeGrid& grid) {
  const Trial<S> trial = in_lanes<S>(trials);
  std::vector<History> result(static_cast<std::size_t>(lanes_of<S>));
  const auto endings =
      simulate_lanes(model, trial.parameters, trial.activation, grid,
                     [&](int, const S&, const State<S>& state, const StepReport<S>& report) {
                       for (int lane = 0; lane < lanes_of<S>; ++lane)
                         append_numbers(state, report, lane, result[at(lane)].steps.emplace_back());
                     });
  for (std::size_t lane = 0; lane < result.size(); ++lane) {
    result[lane].ending = endings[lane];
    if (!endings[lane].completed()) result[lane].steps.resize(at(endings[lane].steps));
  }
  return result;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Compares every lane with the same trial alone, to the bit.
void check_lanes(const Model& model, const std::vector<Trial<double>>& trials, const TimeGrid& grid) {
  const auto together = histories<Four>(model, trials, grid);
  for (std::size_t lane = 0; lane < together.size(); ++lane) {
    const History alone = histories<double>(model, {trials[lane]}, grid)[0];
    const History& among_others = together[lane];
    CAPTURE(lane, alone.ending.message, among_others.ending.message);
    CHECK(among_others.ending.status == alone.ending.status);
    CHECK(among_others.ending.steps == alone.ending.steps);
    CHECK(among_others.ending.time_s == alone.ending.time_s);
    REQUIRE(among_others.steps.size() == alone.steps.size());
    std::size_t equal = 0;
    while (equal < alone.steps.size() && same_bits(among_others.steps[equal], alone.steps[equal])) ++equal;
    CHECK(equal == alone.steps.size());
  }
}

/// Returns four trials that differ in everything that may differ.
std::vector<Trial<double>> four_trials(const Scenario& scenario) {
  std::vector<Trial<double>> trials(4, {scenario.parameters, scenario.activation});
  for (std::size_t i = 0; i < trials.size(); ++i)
    for (double* number : numbers(trials[i])) *number *= 1.0 + 0.07 * static_cast<double>(i);
  trials[1].activation.onset_s = 0.05;
  trials[2].activation.period_s = 0.3;
  return trials;
}

}  // namespace

TEST_CASE("Every lane has the bits of its trial alone", "[property][dynamics][long]") {
  for (const char* name : {"healthy", "published_healthy", "hemiparalysis_right"}) {
    Scenario scenario = without_lung(name);
    scenario.activation.rise_s = 0.15;  // so that much moves, and supports come and go, in few steps
    INFO(name);
    check_lanes(make_trunk(scenario).model, four_trials(scenario), {1e-3, 0.4});
  }
  for (const Scenario& scenario :
       {laden("healthy"), laden_with_lung("healthy"), on_sheet(laden_with_lung("healthy"))})
    for (const Damping damping : {Damping::implicit, Damping::centred})
      check_lanes(make_trunk(scenario).model, four_trials(scenario), {1e-3, 0.2, damping});
}

TEST_CASE("Lanes that begin at different times have the bits of their trials alone",
          "[property][dynamics][long]") {
  for (const char* name : {"healthy", "hemiparalysis_right", "bucket_handle"}) {
    Scenario scenario = without_lung(name);
    scenario.time = {2e-3, 0.4, Damping::implicit, Start::periodic};
    for (RigidPart& part : scenario.rigid)
      part.imposed.angle = PiecewiseLinear({{0.0, 0.0}, {0.2, 0.01}, {0.4, 0.0}});
    scenario.activation.rise_s = 0.15;
    scenario.parameters.elasticity = 16000.0;  // a short memory
    INFO(name);
    const Model model = make_trunk(scenario).model;
    auto trials = four_trials(scenario);
    trials[1].activation.onset_s = -0.05;
    trials[2].activation.period_s = name == std::string("bucket_handle") ? 0.0 : 0.3;
    trials[3].parameters.elasticity /= 3.0;
    check_lanes(model, trials, scenario.time);
    // Lanes fail before the others begin, and before they begin themselves.
    trials[3].parameters.muscle = std::nan("");
    trials[0].parameters.elasticity = 1e7;
    check_lanes(model, trials, scenario.time);
  }
}

TEST_CASE("Lanes that fail do not disturb their neighbours", "[property][dynamics]") {
  const Scenario scenario = without_lung("healthy");
  auto trials = four_trials(scenario);
  trials[1].parameters.elasticity = 1e6;       // diverges
  trials[2].parameters.muscle = std::nan("");  // fails at once
  trials[3].parameters.elasticity = 1e300;     // overflows
  const Model model = make_trunk(scenario).model;
  check_lanes(model, trials, {1e-3, 0.1});
  const auto together = histories<Four>(model, trials, {1e-3, 0.1});
  CHECK(together[0].ending.completed());
  for (std::size_t lane : {1UL, 2UL, 3UL}) CHECK_FALSE(together[lane].ending.completed());
}

TEST_CASE("The search for contacts of each lane ends by itself, with the same bits",
          "[property][constraints]") {
  // From far away to round-off about rest. There, any choice of contacts is right, and a search may end by
  // that.
  const double sizes[] = {1e-19, 1e-17, 1e-16, 1e-15, 1e-13, 1e-5, 3e-3, 15e-3};
  Random random(57);
  const Model model = make_template_trunk({}, {}, Reaction::variational).model;
  const Parameters<double> parameters{4000.0, 30.0, 20.0};
  const Parameters<Four> same{Four(4000.0), Four(30.0), Four(20.0)};
  for (int draw = 0; draw < 300; ++draw) {
    auto state = rest_state<Four>(model);
    auto w = make_workspace(model, same, 1e-3);
    std::vector<State<double>> states(4, rest_state<double>(model));
    std::vector<Workspace<double>> ws(4, make_workspace(model, parameters, 1e-3));
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double size = sizes[random.bits() % std::size(sizes)];
      for (std::size_t i = 0; i < model.particles(); ++i)
        ws[lane].next[i] = model.rest[i] + scaled(model.mobility[i], random.vector(size));
      for (auto& contact : states[lane].contact) contact.touching = random.unit() < 0.5;
    }
    for (std::size_t i = 0; i < model.particles(); ++i) {
      Four xyz[3];
      for (std::size_t lane = 0; lane < 4; ++lane) {
        const Vec3d& x = ws[lane].next[i];
        const double numbers[] = {x.x(), x.y(), x.z()};
        for (std::size_t axis = 0; axis < 3; ++axis)
          set_lane(xyz[axis], static_cast<int>(lane), numbers[axis]);
      }
      w.next[i] = {xyz[0], xyz[1], xyz[2]};
    }
    for (std::size_t s = 0; s < state.contact.size(); ++s) {
      LaneMask<4>::Register touching{};
      for (std::size_t lane = 0; lane < 4; ++lane) touching[lane] = states[lane].contact[s].touching ? -1 : 0;
      state.contact[s].touching = LaneMask<4>(touching);
    }
    calc_planes(model, state, w);
    calc_ring_areas<Four>(model.abdomen.rings, state.position, w.reactions.area);
    const auto together = project_volume_and_supports(model, Four(model.abdomen.rest), state, w);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      calc_planes(model, states[lane], ws[lane]);
      calc_ring_areas<double>(model.abdomen.rings, states[lane].position, ws[lane].reactions.area);
      const auto alone = project_volume_and_supports(model, model.abdomen.rest, states[lane], ws[lane]);
      CAPTURE(draw, lane);
      const int l = static_cast<int>(lane);
      REQUIRE(alone.found == in_lane(together.found, l));
      REQUIRE(alone.multiplier == in_lane(together.multiplier, l));
      for (std::size_t s = 0; s < state.contact.size(); ++s) {
        REQUIRE(states[lane].contact[s].touching == in_lane(state.contact[s].touching, l));
        REQUIRE(states[lane].contact[s].press == in_lane(state.contact[s].press, l));
      }
      double apart = 0.0;
      for (std::size_t i = 0; i < model.particles(); ++i)
        apart = std::max(apart, norm(Vec3d{in_lane(w.next[i].x(), l), in_lane(w.next[i].y(), l),
                                           in_lane(w.next[i].z(), l)} -
                                     ws[lane].next[i]));
      REQUIRE(apart == 0.0);
    }
  }
}

TEST_CASE("When all lanes have failed the simulation stops", "[unit][dynamics]") {
  const Scenario scenario = without_lung("healthy");
  std::vector<Trial<double>> trials(4, {scenario.parameters, scenario.activation});
  for (std::size_t i = 0; i < 4; ++i)
    trials[i].parameters.elasticity = std::pow(10.0, 6.0 + static_cast<double>(i));
  const Trial<Four> trial = in_lanes<Four>(trials);
  int last = 0;
  const auto endings =
      simulate_lanes(make_trunk(scenario).model, trial.parameters, trial.activation, {1e-3, 4.5},
                     [&](int n, const auto&, const auto&, const auto&) { last = n; });
  int latest = 0;
  for (const Ending& ending : endings) latest = std::max(latest, ending.steps);
  CHECK(last == latest - 1);
  CHECK(latest < 1000);
}

TEST_CASE("A step of lanes allocates nothing", "[property][dynamics]") {
  const Scenario scenario = on_sheet(laden("healthy"));
  const Model model = make_trunk(scenario).model;
  const Trial<Four> trial = in_lanes<Four>(four_trials(scenario));
  State<Four> state = rest_state<Four>(model);
  Workspace<Four> workspace = make_workspace(model, trial.parameters, 1e-3);
  bool ok = true;
  const long before = allocations();
  for (int n = 0; n < 300; ++n)
    ok = all(step(model, trial.parameters, trial.activation(state.time_s), state, workspace).ok) && ok;
  const long during = allocations() - before;
  CHECK(ok);
  CHECK(during == 0);
}

TEST_CASE("A batch of any size gives the curves of its trials", "[property][anatomy]") {
  const Scenario scenario = without_lung("hemiparalysis_right");
  const Trunk trunk = make_trunk(scenario);
  const TimeGrid grid{1e-3, 0.1};
  std::vector<Trial<double>> trials;
  CHECK(simulate_volumes(trunk, trials, grid).empty());
  for (int i = 0; i < 9; ++i) {
    trials.push_back({scenario.parameters, scenario.activation});
    trials.back().parameters.muscle *= 1.0 + i;
  }
  trials[6].parameters.elasticity = 1e8;
  for (const std::size_t count : {1u, 3u, 9u}) {
    const auto curves = simulate_volumes(trunk, std::span(trials).first(count), grid);
    REQUIRE(curves.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      CAPTURE(count, i);
      const VolumeCurve alone = simulate_volume(trunk, trials[i].parameters, trials[i].activation, grid);
      CHECK(curves[i].ending.message == alone.ending.message);
      CHECK(curves[i].ending.completed() == (i != 6));
      CHECK(same_bits(curves[i].delta_v, alone.delta_v));
    }
  }
}

TEST_CASE("Masks of lanes", "[unit][math]") {
  const Four a(Four::Register{1.0, 2.0, 3.0, std::nan("")}), b(2.5);
  const auto below = a < b;
  CHECK((in_lane(below, 0) && in_lane(below, 1) && !in_lane(below, 2) && !in_lane(below, 3)));
  CHECK((any(below) && !all(below) && all(below | !below) && !any(below & !below)));
  CHECK(all((below == below)));
  CHECK_FALSE(any(below == !below));
  const Four chosen = select(below, a, b), root = sqrt(b), down = floor(a);
  CHECK((in_lane(chosen, 1) == 2.0 && in_lane(chosen, 3) == 2.5));
  CHECK((in_lane(root, 3) == std::sqrt(2.5) && in_lane(down, 2) == 3.0));
  CHECK((in_lane(finite(a), 2) && !in_lane(finite(a), 3)));
  Four c = a;
  set_lane(c, 3, 4.0);
  CHECK((in_lane(c, 3) == 4.0 && in_lane(c, 0) == 1.0));
}
