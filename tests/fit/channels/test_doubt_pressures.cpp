#include "channels/doubt_pressures.hpp"

#include <cmath>
#include <numbers>

#include "math/units.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

constexpr double cmH2O_per_kPa = 1000 / Pa_per_cmH2O;

MeasuredChannel channel(ChannelKind kind, const std::string& name, double level_cmH2O, double swing_cmH2O) {
  MeasuredChannel made;
  made.kind = kind, made.column = name, made.unit = "cmH2O", made.end_expiratory = Pa_per_cmH2O * level_cmH2O;
  for (int i = 0; i <= 200; ++i)
    made.value.push_back(Pa_per_cmH2O * swing_cmH2O * std::sin(std::numbers::pi * i / 200.0));
  return made;
}

// A breath of 500 ml in which pleural pressure falls by 6 cmH2O and gastric pressure rises by 3.
MeasuredBreath breath() {
  MeasuredBreath made;
  for (int i = 0; i <= 200; ++i) made.time_s.push_back(0.02 * i);
  made.tidal_volume_m3 = 500e-6;
  made.channels = {channel(ChannelKind::pleural, "Pes", -5, -6), channel(ChannelKind::gastric, "Pga", 8, 3),
                   channel(ChannelKind::transdiaphragmatic, "Pdi", 13, 9)};
  return made;
}

void multiply(MeasuredChannel& channel, double factor) {
  for (double& v : channel.value) v *= factor;
  channel.end_expiratory *= factor;
}

std::string all_of(const MeasuredBreath& breath) {
  std::string all;
  for (const std::string& doubt : doubt_pressures(breath)) all += doubt + "\n";
  return all;
}

}  // namespace

TEST_CASE("Pressures that fit each other and the breath are not doubted", "[faults]") {
  MeasuredBreath made = breath();
  CHECK(all_of(made).empty());
  made.channels[2].end_expiratory = 0;  // set to zero at the end of expiration, as some laboratories do
  CHECK(all_of(made).empty());
  made.channels.pop_back();
  CHECK(all_of(made).empty());
}

TEST_CASE("A pressure in another unit than the other two is named", "[faults]") {
  for (std::size_t k = 0; k < 3; ++k) {
    MeasuredBreath made = breath();
    const std::string name = made.channels[k].column;
    multiply(made.channels[k], 1 / cmH2O_per_kPa);
    CHECK_THAT(all_of(made), Contains("'" + name + "' is in kPa and not in cmH2O"));
    made = breath();
    multiply(made.channels[k], cmH2O_per_kPa), made.channels[k].unit = "kPa";
    CHECK_THAT(all_of(made), Contains("'" + name + "' is in cmH2O and not in kPa"));
    made = breath();
    multiply(made.channels[k], Pa_per_cmH2O / Pa_per_mmHg);
    CHECK_THAT(all_of(made), Contains("'" + name + "' is in mmHg and not in cmH2O"));
  }
}

TEST_CASE("A swing that no lung needs for its breath is doubted", "[faults]") {
  MeasuredBreath alone = breath();
  alone.channels.resize(1);
  multiply(alone.channels[0], 1 / cmH2O_per_kPa);
  CHECK_THAT(all_of(alone),
             Contains("'Pes' swings by 1.18 cmH2O for each litre of breath, where lungs take 3 to 100"));
  alone = breath(), alone.channels.resize(1), alone.channels[0].unit = "kPa";
  multiply(alone.channels[0], cmH2O_per_kPa);
  CHECK_THAT(all_of(alone), Contains("swings by 61.2 cmH2O, which only a great effort does: is it in kPa?") &&
                                Contains("122 cmH2O for each litre"));
  alone = breath(), alone.channels.resize(1), alone.tidal_volume_m3 = 35e-6;  // an infant
  CHECK(all_of(alone).empty());
}

TEST_CASE("A level that no body has and a diaphragm that does nothing are doubted", "[faults]") {
  MeasuredBreath alone = breath();
  alone.channels = {alone.channels[1]};
  multiply(alone.channels[0], cmH2O_per_kPa);
  CHECK_THAT(all_of(alone), Contains("gastric pressure 'Pga' is 81.6 cmH2O at the end of expiration"));
  alone = breath(), alone.channels = {alone.channels[2]};
  multiply(alone.channels[0], 1 / cmH2O_per_kPa);
  CHECK_THAT(all_of(alone), Contains("'Pdi' swings by 1.77 cmH2O for each litre of breath") &&
                                Contains("paralysed, or is the pressure not in cmH2O?"));
}
