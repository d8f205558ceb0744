// The peer: Bullet's soft body on a closed surface of as many nodes and faces as the trunk's, pose matching
// and volume conservation on, stepped as long. Compiled twice, for Bullet's float and double libraries.
//
// Reads lines from its input, each the conservation factor of one breath to simulate, and answers each with a
// line "MILLISECONDS VOLUME_ERROR": the time of the loop alone, and the largest relative error of the
// enclosed volume.

#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

namespace {

constexpr int nodes = 113, steps = 4500;
constexpr auto dt_s = static_cast<btScalar>(1e-3);
constexpr double pull_N = 350.0;  // on each pulled node: they come down by about 9 mm, as the dome does

/// Evenly spread over an ellipsoid of a trunk's size (golden-angle spiral), m; their hull has 2 nodes - 4
/// faces.
std::vector<btVector3> trunk_sized_nodes() {
  std::vector<btVector3> points;
  for (int i = 0; i < nodes; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / nodes, r = std::sqrt(1.0 - z * z);
    const double angle = i * M_PI * (3.0 - std::sqrt(5.0));
    points.emplace_back(btScalar(0.15 * r * std::cos(angle)), btScalar(0.1 * r * std::sin(angle)),
                        btScalar(0.2 * z));
  }
  return points;
}

/// The paper's breath: 2 s up, 0.5 s down to 0.4, 2 s down to 0.
double activation(double time_s) {
  if (time_s < 2.0) return time_s / 2.0;
  if (time_s < 2.5) return 1.0 - 0.6 * (time_s - 2.0) / 0.5;
  return 0.4 * (1.0 - (time_s - 2.5) / 2.0);
}

double enclosed_volume(const btSoftBody& body) {
  double six_volumes = 0.0;
  for (int i = 0; i < body.m_faces.size(); ++i) {
    const auto& n = body.m_faces[i].m_n;
    six_volumes += double(btDot(n[0]->m_x, btCross(n[1]->m_x, n[2]->m_x)));
  }
  return std::abs(six_volumes) / 6.0;
}

std::unique_ptr<btSoftBody> soft_trunk(btSoftBodyWorldInfo& world, double conservation) {
  auto points = trunk_sized_nodes();
  std::unique_ptr<btSoftBody> body(
      btSoftBodyHelpers::CreateFromConvexHull(world, points.data(), nodes, false));
  body->m_cfg.kVC = btScalar(conservation);
  body->m_cfg.kMT = btScalar(0.1);
  body->m_cfg.kDP = btScalar(0.01);
  body->m_cfg.piterations = 1;
  body->m_cfg.collisions = 0;
  body->m_materials[0]->m_kLST = btScalar(0.5);
  body->setTotalMass(btScalar(20.0), false);
  for (int i = 0; i < nodes; ++i)
    if (body->m_nodes[i].m_x.z() < btScalar(-0.12)) body->setMass(i, 0);  // sits on its base
  body->setPose(true, true);
  return body;
}

struct Result {
  double ms, volume_error, descent_mm;
};

Result breath(double conservation) {
  btSoftBodyWorldInfo world;
  world.m_gravity.setValue(0, 0, 0);
  const auto body = soft_trunk(world, conservation);
  std::vector<int> pulled;  // as the diaphragm's dome is
  for (int i = 0; i < nodes; ++i)
    if (body->m_nodes[i].m_x.z() > btScalar(0.14)) pulled.push_back(i);
  const auto height = [&] {
    double sum = 0.0;
    for (int i : pulled) sum += double(body->m_nodes[i].m_x.z());
    return sum / double(pulled.size());
  };
  const double rest = enclosed_volume(*body), start_height = height();
  double worst = 0.0, lowest = start_height, measuring_ms = 0.0;
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto ms = [](auto from, auto to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
  };
  const auto start = now();
  for (int n = 0; n < steps; ++n) {
    const btVector3 pull(0, 0, btScalar(-pull_N * activation(n * double(dt_s))));
    for (int i : pulled) body->addForce(pull, i);
    body->predictMotion(dt_s);
    body->solveConstraints();
    body->integrateMotion();
    if (n % 50 != 49) continue;
    const auto measuring = now();
    worst = std::max(worst, std::abs(enclosed_volume(*body) / rest - 1.0));
    lowest = std::min(lowest, height());
    measuring_ms += ms(measuring, now());
  }
  return {ms(start, now()) - measuring_ms, worst, 1e3 * (start_height - lowest)};
}

}  // namespace

int main() {
  for (double conservation; std::cin >> conservation;) {
    const Result r = breath(conservation);
    std::cout << "{\"ms\": " << r.ms
              << ", \"volume_error\": " << (std::isfinite(r.volume_error) ? r.volume_error : 1e300)
              << ", \"descent_mm\": " << (std::isfinite(r.descent_mm) ? r.descent_mm : -1.0) << "}"
              << std::endl;
  }
}
