#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "registration/insertion_line.hpp"
#include "registration/subject.hpp"
#include "registration/target_surface.hpp"
#include "support/catch.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

Vec3d mean_of(const TrunkMesh& mesh, const char* name) {
  Vec3d sum;
  for (int i : mesh.named(name)) sum += mesh.rest[at(i)];
  return (1.0 / static_cast<double>(mesh.named(name).size())) * sum;
}

/// Checks what holds for every registered trunk.
void require_a_trunk(const Registration& found, const TrunkMesh& before) {
  CHECK(found.quality.sound());
  CHECK(found.mesh.abdomen == before.abdomen);
  CHECK(found.mesh.lung == before.lung);
  CHECK(found.mesh.muscle_lines == before.muscle_lines);
  CHECK(found.mesh.regions == before.regions);
  CHECK(found.mesh.landmarks == before.landmarks);
  CHECK(enclosed_volume<double>(found.mesh.lung, found.mesh.rest) == Approx(found.final.lung));
  CHECK(enclosed_volume<double>(found.mesh.abdomen, found.mesh.rest) == Approx(found.final.abdomen));
  CHECK(found.final.lung > 0.0);
  CHECK(found.final.abdomen > 0.0);
  CHECK_NOTHROW(require_anatomy(found.mesh));
}

std::vector<Vec3d> ring(std::size_t count, double (*height)(double angle)) {
  std::vector<Vec3d> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    for (const double above : {0.0, 0.05, 0.1})
      points.push_back({0.15 * std::cos(angle), 0.1 * std::sin(angle), height(angle) + above});
  }
  return points;
}

}  // namespace

TEST_CASE("A similarity is found again from its points", "[unit][registration]") {
  const Similarity truth{1.2, rotation_about({0.0, 0.6, 0.8}, 0.5), {0.1, -0.2, 0.3}};
  Random random(3);
  std::vector<Vec3d> from, to;
  for (int i = 0; i < 20; ++i) {
    from.push_back(random.vector(0.2));
    to.push_back(truth(from.back()));
  }
  const Similarity found = fitted_similarity(from, to);
  CHECK(found.scale == Approx(1.2));
  CHECK(found.angle() == Approx(0.5));
  for (const Vec3d& p : from) {
    CHECK(norm(found(p) - truth(p)) < 1e-12);
    CHECK(norm(found.inverse(truth(p)) - p) < 1e-12);
  }
}

TEST_CASE("Actuators that turn the whole trunk meet no resistance; others find a balance",
          "[property][registration]") {
  const TrunkMesh mesh = make_template_mesh({});
  const std::vector<double> one(mesh.rest.size(), 4000.0), none(mesh.rest.size(), 0.0);
  ElasticBalance balance;
  for (const auto* triangles : {&mesh.abdomen, &mesh.lung})
    balance.add(
        make_shape_memory(Surface("trunk", *triangles, 113), mesh.rest, one, none, Reaction::variational));
  const Similarity rigid{1.0, rotation_about({0, 0, 1}, 0.3), {0.01, 0.02, 0.03}};
  std::vector<LinearActuator> actuators;
  for (int i = 0; i < 113; i += 4)
    actuators.push_back({{i, i, i}, {1.0, 0.0, 0.0}, rigid(mesh.rest[at(i)]), 500.0});
  const std::vector<Vec3d> turned = balance.relaxed(mesh.rest, actuators, 200);
  for (std::size_t i = 0; i < turned.size(); ++i) CHECK(norm(turned[i] - rigid(mesh.rest[i])) < 1e-4);

  // One particle is pulled away from the others, and shape memory resists.
  actuators.assign(1, {{0, 0, 0}, {1.0, 0.0, 0.0}, mesh.rest[0] + Vec3d{0.0, 0.0, -0.05}, 500.0});
  for (int i = 1; i < 113; ++i) actuators.push_back({{i, i, i}, {1.0, 0.0, 0.0}, mesh.rest[at(i)], 100.0});
  const std::vector<Vec3d> drawn = balance.relaxed(mesh.rest, actuators, 60);
  const double sunk = mesh.rest[0].z() - drawn[0].z();
  CHECK(sunk > 0.001);
  CHECK(sunk < 0.045);
  CHECK(largest(difference(balance.relaxed(drawn, actuators, 1), drawn)) < 1e-6);
}

TEST_CASE("An actuator that pulls along one direction lets its point slide across it",
          "[unit][registration]") {
  const LinearActuator slides{{0, 1, 2}, {0.5, 0.5, 0.0}, {1.0, 2.0, 3.0}, 1.0, {0.0, 0.0, 1.0}};
  const std::vector<Vec3d> position{{0, 0, 0}, {0, 0, 2}, {5, 5, 5}};
  CHECK(norm(slides.reach(position) - Vec3d{0.0, 0.0, 2.0}) < 1e-15);
  const TrunkMesh mesh = make_template_mesh({});
  ElasticBalance balance;
  const std::vector<double> one(113, 4000.0), none(113, 0.0);
  for (const auto* triangles : {&mesh.abdomen, &mesh.lung})
    balance.add(
        make_shape_memory(Surface("trunk", *triangles, 113), mesh.rest, one, none, Reaction::variational));
  // All particles are pulled up by 0.02, and three of them forward by 0.01; nothing pulls to the right.
  std::vector<LinearActuator> actuators;
  for (int i = 0; i < 113; ++i)
    actuators.push_back(
        {{i, i, i}, {1.0, 0.0, 0.0}, mesh.rest[at(i)] + Vec3d{0.5, 0.5, 0.02}, 500.0, {0, 0, 1}});
  for (int i : {0, 40, 100})
    actuators.push_back(
        {{i, i, i}, {1.0, 0.0, 0.0}, mesh.rest[at(i)] + Vec3d{0.5, 0.01, 0.0}, 500.0, {0, 1, 0}});
  actuators.push_back({{5, 5, 5}, {1.0, 0.0, 0.0}, mesh.rest[5], 1e-3, {1, 0, 0}});
  actuators.push_back({{9, 9, 9}, {1.0, 0.0, 0.0}, mesh.rest[9], 1e-3, {1, 0, 0}});
  const std::vector<Vec3d> moved = balance.relaxed(mesh.rest, actuators, 100);
  for (std::size_t i = 0; i < moved.size(); ++i)
    CHECK(norm(moved[i] - mesh.rest[i] - Vec3d{0.0, 0.01, 0.02}) < 1e-4);
}

TEST_CASE("A surface ends at its border, jagged or not", "[unit][registration]") {
  const MeasuredSurface square{
      "square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const TargetSurface target(square);
  const Vec3d up{0.0, 0.0, 1.0}, over{0.7, 0.3, 4.0}, beside{3.0, 0.5, 0.0};
  CHECK(target.ends_before(beside, up, target.closest(beside)));
  CHECK_FALSE(target.ends_before(over, up, target.closest(over)));
  // Over a spike that stands up from its border, seen from a surface that faces across.
  CHECK(target.ends_before(over, {1.0, 0.0, 0.0}, target.closest(over)));
  const Vec3d near{0.7, 0.3, 0.5};
  CHECK_FALSE(target.ends_before(near, {1.0, 0.0, 0.0}, target.closest(near)));
}

TEST_CASE("The border of an open surface is known", "[unit][registration]") {
  const MeasuredSurface square{
      "square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const TargetSurface target(square);
  CHECK(target.on_border(target.closest({2.0, 0.5, 0.0})));
  CHECK(target.on_border(target.closest({2.0, 2.0, 0.0})));
  CHECK_FALSE(target.on_border(target.closest({0.6, 0.2, 1.0})));
  CHECK_FALSE(target.on_border(target.closest({0.5, 0.5, 1.0})));  // on the diagonal, which two share
}

TEST_CASE("Triangles that fold or become slivers are found", "[unit][registration]") {
  const TrunkMesh mesh = make_template_mesh({});
  CHECK(mesh_quality(mesh, mesh.rest).sound());
  CHECK(mesh_quality(mesh, mesh.rest).smallest_angle > 15 * rad_per_degree);
  const std::size_t saddle = at(mesh.named("dome_saddle").front()),
                    beside = at(mesh.named("dome_top_left").front());
  std::vector<Vec3d> folded = mesh.rest, sliver = mesh.rest;
  folded[saddle] += 1.6 * (mesh.rest[beside] - mesh.rest[saddle]);
  CHECK(mesh_quality(mesh, folded).folded > 0);
  CHECK_FALSE(mesh_quality(mesh, folded).sound());
  sliver[saddle] += 0.9999 * (mesh.rest[beside] - mesh.rest[saddle]);
  CHECK(mesh_quality(mesh, sliver).smallest_angle < 0.5 * rad_per_degree);
  CHECK_FALSE(mesh_quality(mesh, sliver).sound());
}

TEST_CASE("The costal insertion is the lower border if that is smooth", "[unit][registration]") {
  const Vec3d centre{0.0, 0.0, 0.2}, right{0.15, 0.0, 0.0}, front{0.0, 0.1, 0.0}, left{-0.15, 0.0, 0.0};
  const auto line = [&](double (*height)(double)) {
    return InsertionLine(ring(720, height), centre, 0.15, 0.1, 0.15);
  };
  const InsertionLine flat = line([](double) { return 0.2; });
  CHECK(flat.covered() == 1.0);
  CHECK(flat.low_height() == Approx(0.2));
  const InsertionLine margin =
      line([](double a) { return 0.2 + 0.1 * std::pow(0.5 + 0.5 * std::sin(a), 5.0); });
  CHECK(margin.covered() == 1.0);
  CHECK(margin.beside(front)->point.z() == Approx(0.3).margin(2 * m_per_mm));
  CHECK(margin.height_beside(front) == Approx(0.3).margin(20 * m_per_mm));
  const auto cut_left = [](double a) { return std::cos(a) < -0.5 ? 0.28 : 0.2; };
  const InsertionLine cut = line(cut_left);
  CHECK(cut.covered() == Approx(2.0 / 3.0).margin(0.03));
  CHECK_FALSE(cut.beside(left));
  CHECK(cut.beside(right)->point.z() == Approx(0.2));
  CHECK(cut.height_beside(left) == Approx(0.2).margin(10 * m_per_mm));
  // The line goes straight across a narrow gap. It attracts upward and outward, not along itself.
  const InsertionLine notched =
      line([](double a) { return std::abs(a - 1.5 * std::numbers::pi) < 0.25 ? 0.35 : 0.2; });
  const Vec3d back{0.0, -0.1, 0.0};
  CHECK(notched.covered() < 0.95);
  REQUIRE(notched.beside(back));
  CHECK(norm(notched.beside(back)->point - Vec3d{0.0, -0.0985, 0.2}) < 4 * m_per_mm);
  CHECK(notched.beside(right)->upward.z() == Approx(1.0));
  CHECK(notched.beside(right)->outward.x() == Approx(1.0).margin(0.01));
  const InsertionLine high =
      line([](double a) { return std::sin(a) > 0.5 ? 0.4 : 0.2; });  // no margin of the ribs rises so far
  CHECK_FALSE(high.beside(front));
  CHECK(high.height_beside(front) == Approx(0.2).margin(10 * m_per_mm));
}

TEST_CASE("A known subject is found again, noisy and with a third of the surface missing",
          "[slow][regression][registration]") {
  enum class Missing { here_and_there, dome, sector };
  struct Case {
    double scale, turn_degrees;
    Missing missing;
    double point_rms;  // m, of particles from their true places
  };
  for (const Case& c :
       {Case{1.2, 30.0, Missing::here_and_there, 3 * m_per_mm}, Case{0.8, -30.0, Missing::dome, 3 * m_per_mm},
        Case{1.2, 0.0, Missing::sector, 6 * m_per_mm}}) {
    KnownSubject subject = known_subject({1, c.scale, c.turn_degrees, 6});
    add_noise(subject.diaphragm, 2 * m_per_mm);
    Random random(11);
    const Vec3d dome = subject.truth[at(subject.trunk.named("dome_top_left").front())],
                middle{0.12, -0.05, 0.4};
    const double missing = keep(subject.diaphragm, [&](const Vec3d& p) {
      if (c.missing == Missing::here_and_there) return random.unit() > 0.3;
      if (c.missing == Missing::dome) return norm(p - dome) > 0.115 * c.scale;
      return std::abs(std::atan2((p - middle).y() / 2.0, (p - middle).x() / 3.0)) > 0.3 * std::numbers::pi;
    });
    CAPTURE(c.scale, c.turn_degrees, missing);
    CHECK(missing > 0.2);
    const Registration found = registered(subject);
    require_a_trunk(found, subject.trunk);
    const PointErrors errors = errors_of(subject, found);
    CHECK(errors.surface.rms < 2 * m_per_mm);  // from the true surface
    CHECK(errors.surface.percentile95 < 4 * m_per_mm);
    CHECK(errors.point.rms < c.point_rms);
    CHECK(found.alignment.similarity.scale == Approx(c.scale).epsilon(0.05));
    CHECK(found.alignment.similarity.angle() ==
          Approx(std::abs(c.turn_degrees) * rad_per_degree).margin(4 * rad_per_degree));
    CHECK(found.fits.front().to_target->rms < 2 * m_per_mm);
    CHECK(found.fits.front().from_target->rms < 2 * m_per_mm);
  }
}

TEST_CASE("Volume, length and landmarks are the given ones, and a second run gives the same",
          "[slow][regression][registration]") {
  const KnownSubject subject = known_subject({1, 1.0, 0.0, 3});
  const Registration plain = registered(subject);
  const Vec3d dome = mean_of(plain.mesh, "dome_top_right"), place = dome + Vec3d{0.0, 0.01, 0.0};
  SubjectMeasurements targets;
  targets.diaphragm = subject.diaphragm;
  targets.lung_volume = 4000e-6;
  targets.apposition_length = 0.12;
  targets.landmarks["dome_top_right"] = place;
  const Registration found = registered(subject, targets), again = registered(subject, targets);
  require_a_trunk(found, subject.trunk);
  CHECK(found.final.lung == Approx(4000e-6).epsilon(1e-9));
  CHECK(plain.apposition_length > 0.14);
  CHECK(plain.extrapolated == std::vector<std::string>{"abdominal_wall", "lung_top", "lung_wall", "pelvis"});
  CHECK(plain.particles_without_data == 58);
  CHECK(plain.insertion_covered > 0.95);
  CHECK(found.apposition_length == Approx(0.12).margin(4 * m_per_mm));
  CHECK(norm(mean_of(found.mesh, "dome_top_right") - place) < 0.6 * norm(dome - place));
  CHECK(errors_of(subject, found).surface.rms < 4 * m_per_mm);
  for (std::size_t i = 0; i < found.mesh.rest.size(); ++i) {
    const Vec3d &a = found.mesh.rest[i], &b = again.mesh.rest[i];
    CHECK((a.x() == b.x() && a.y() == b.y() && a.z() == b.z()));
  }
  CHECK(mean_of(found.mesh, "dome_top_left").x() < mean_of(found.mesh, "dome_top_right").x());
}

TEST_CASE("A finer trunk is registered as well", "[slow][regression][registration]") {
  KnownSubject subject = known_subject({2, 1.1, 15.0, 2});
  add_noise(subject.diaphragm, 2 * m_per_mm);
  const Registration found = registered(subject);
  require_a_trunk(found, subject.trunk);
  CHECK(found.mesh.rest.size() == 455);
  CHECK(errors_of(subject, found).surface.rms < 2 * m_per_mm);
}

TEST_CASE("Regions without data move along and are reported", "[slow][regression][registration]") {
  KnownSubject subject = known_subject({1, 1.0, 0.0, 4});
  keep(subject.diaphragm, [](const Vec3d& p) { return p.z() > 0.46; });  // 0.36 of the trunk
  SubjectMeasurements targets;
  targets.diaphragm = subject.diaphragm;
  targets.lower_border = LowerBorder::cut;
  const Registration dome = registered(subject, targets);
  CHECK(dome.insertion_covered == 0.0);
  CHECK(dome.extrapolated ==
        std::vector<std::string>{"abdominal_wall", "costal_insertion", "lung_top", "lung_wall", "pelvis"});
  CHECK(dome.particles_without_data > 58 + 6);
  CHECK(dome.fits.front().with_data < 0.9);
  for (const RegionFit& fit : dome.fits)
    if (fit.to_target) CHECK(fit.to_target->rms <= fit.to_target_all->rms + 1e-12);
}

TEST_CASE("Closed lungs attract the domes and the lung's wall", "[slow][regression][registration]") {
  const KnownSubject subject = known_subject({1, 1.05, 10.0, 4});
  SubjectMeasurements targets;
  targets.lungs.push_back(refined(subject.truth, subject.trunk.lung, 4));
  const Registration found = register_trunk(subject.trunk, targets, [](int, int) {});
  require_a_trunk(found, subject.trunk);
  CHECK(found.fits.front().target == "lungs");
  CHECK(found.fits.front().to_target->rms < 3 * m_per_mm);
  CHECK(found.fits.front().from_target->rms < 3 * m_per_mm);
  const double truth = enclosed_volume<double>(subject.trunk.lung, subject.truth);
  CHECK(found.final.lung == Approx(truth).epsilon(0.03));
}

TEST_CASE("Only the inner sides of ribs attract", "[slow][regression][registration]") {
  const KnownSubject subject = known_subject({1, 1.0, 0.0, 2});
  SubjectMeasurements targets;
  targets.ribs = refined(subject.truth, rib_side_of(subject.trunk), 3);
  const Registration outer = register_trunk(subject.trunk, targets, [](int, int) {});
  CHECK_FALSE(outer.fits.front().from_target);
  for (Triangle& t : targets.ribs->triangles) std::swap(t[1], t[2]);
  const Registration inner = register_trunk(subject.trunk, targets, [](int, int) {});
  require_a_trunk(inner, subject.trunk);
  CHECK_FALSE(inner.fits.front().to_target);
  REQUIRE(inner.fits.front().from_target);
  CHECK(inner.fits.front().from_target->rms < 2 * m_per_mm);
}

TEST_CASE("Measurements that cannot be used are refused", "[unit][registration]") {
  KnownSubject subject = known_subject({1, 1.0, 0.0, 1});
  CHECK_THROWS_WITH(register_trunk(subject.trunk, {}, [](int, int) {}),
                    Contains("no surface to register to"));
  SubjectMeasurements targets;
  targets.diaphragm = subject.diaphragm;
  targets.landmarks["nose"] = {};
  CHECK_THROWS_WITH(registered(subject, targets), Contains("'nose'") && Contains("dome_top_right"));
  targets.landmarks.clear();
  targets.landmarks["fixed"] = {};
  CHECK_THROWS_WITH(registered(subject, targets), Contains("'fixed'"));
}
