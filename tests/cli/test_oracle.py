"""The kernel against reference/oracle.py, which solves the same equations by other means, over breaths."""

import re
import subprocess
import sys
import unittest

import h5py
import numpy as np

from support import HEALTHY, NIGHTLY, NO_LUNG, ROOT, SCENARIOS, TrunkTest, at_night

LIMIT_S = 300  # all of it takes about 35 s on an idle core
# At night whole breaths; by day the halves of them that hold the most.
TEXT = "parameters/scenario_toml"
STEP = ("--set", "time.dt_ms=3", "--set", "time.start=rest")
BREATH_STEPS = 1500 if NIGHTLY else 750  # a whole breath, or the inspiration and the turn
TURN_STEPS = 800 if NIGHTLY else 400  # past the peak, or most of the inspiration
SHORT_STEPS = 400 if NIGHTLY else 250


def lasting(steps):
    return (*STEP, "--set", f"time.duration_s={0.003 * steps:.3f}")


BREATH, TURN, SHORT = lasting(BREATH_STEPS), lasting(TURN_STEPS), lasting(SHORT_STEPS)
RUBBING = ("--set", "tissue.rib_friction=0.3", "--set", "tissue.membrane_stiffness_N_per_m=30",
           "--set", "tissue.held_stiffness_factor=2")

# Both halves of the rib cage turn about a front-to-back axis at the top of the lung; the left one also shifts.
BUCKET_HANDLE = """
[[rigid]]
region = "rib_cage_right"
motion = "driven"
surface_for = "zone_of_apposition_right"
axis = [0.0, 1.0, 0.0]
axis_point_mm = [0.0, 0.0, 560.0]
events_deg = [[0.0, 0.0], [2.0, -3.0], [4.5, 0.0]]
[[rigid]]
region = "rib_cage_left"
motion = "driven"
surface_for = "zone_of_apposition_left"
axis = [0.1, 1.0, 0.0]
axis_point_mm = [0.0, 0.0, 560.0]
events_deg = [[0.0, 0.0], [2.0, 2.0], [4.5, 0.0]]
direction = [0.0, 1.0, 0.5]
events_mm = [[0.1, 0.0], [2.0, 3.0], [4.5, 0.0]]
"""
# The lung pulls at the domes, so that only a trunk without one has a free central tendon.
FREE_TENDON = """
[[rigid]]
region = "central_tendon"
motion = "free"
"""
PARALYSIS = """
[paralysis]
side = "right"
stiffness_factor = 0.5
"""
LOADS = """
[[force]]
region = "0-20,central_tendon,60"
direction = [1.0, 0.5, -2.0]
events_N = [[0.0, 0.0], [0.5, 0.4], [1.0, 0.1]]
[[displacement]]
region = "80,83"
direction = [0.0, 0.0, 1.0]
axes = [1.0, 0.0, 1.0]
events_mm = [[0.0, 0.0], [0.7, -6.0], [1.5, 0.0]]
[[acceleration]]
region = "zone_of_apposition_left,abdominal_wall"
direction = [0.0, 1.0, 0.3]
events_m_s2 = [[0.0, 0.0], [0.3, 0.9]]
[[pressure]]
region = "abdominal_wall,costal_insertion"
events_cmH2O = [[0.0, 0.0], [0.6, 3.0], [1.5, -2.0]]
[[pressure]]
region = "central_tendon,zone_of_apposition"
direction = [0.0, 0.6, -0.8]
events_cmH2O = [[0.0, 0.0], [0.6, 1.0], [1.5, 2.0]]
"""
LUNG = """
[lung]
elastance_cmH2O_per_L = 5.0
resistance_cmH2O_s_per_L = 8.0
[airway]
pressure_cmH2O = [[0.0, 0.0], [0.5, 5.0], [1.0, 3.0], [2.0, 0.0]]
tube_resistance_cmH2O_s_per_L = 1.5
"""
FIELDS = """
gravity_m_s2 = [0.5, -0.3, -1.0]
abdominal_volume_fraction = [[0.0, 1.0], [0.4, 1.01], [1.5, 0.99]]
"""


class Oracle(TrunkTest):
    def scenario(self, tables, base="healthy", fields=""):
        return self.file("scenario.toml", f'schema = "trunk.scenario/1"\nextends = "{SCENARIOS / base}.toml"\n'
                         + fields + tables)

    def ask(self, *arguments):
        return subprocess.run([sys.executable, ROOT / "reference" / "oracle.py", *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=LIMIT_S)

    def assert_agrees(self, scenario, *settings, steps):
        self.succeeds("simulate", scenario, "-o", "run.h5", "--force", *settings)
        answer = self.ask("run.h5")
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
        self.assertIn(f" {steps} steps", answer.stdout)
        apart_m = float(re.search(r"largest distance +(\S+) m", answer.stdout)[1])
        apart_ml = float(re.search(r"largest dV apart +(\S+) ml", answer.stdout)[1])
        self.assertLess(apart_m, 1e-9)
        self.assertLess(apart_ml, 1e-4)  # 1e-9 m over the 0.05 m2 of the diaphragm, and then some

    def assert_sees(self, scenario, *settings, change, factor):
        """A run with another value of the key `change` than its scenario says is found out."""
        self.succeeds("simulate", scenario, "-o", "run.h5", *settings)
        with h5py.File(self.folder / "run.h5") as run:
            text = run[TEXT][()]
        key = change.rpartition(".")[2].encode()
        value = float(re.search(rb"(?m)^%s = (\S+)" % key, text)[1])
        self.succeeds("simulate", scenario, "-o", "other.h5", *settings, "--set", f"{change}={value * factor:.17g}")
        with h5py.File(self.folder / "other.h5", "r+") as other:
            del other[TEXT]
            other[TEXT] = np.bytes_(text)
        answer = self.ask("other.h5")
        self.assertEqual(answer.returncode, 1, answer.stdout + answer.stderr)
        self.assertIn("DIFFERS", answer.stdout)

    def test_variational_reaction_and_ribs(self):
        self.assert_agrees(HEALTHY, *BREATH, steps=BREATH_STEPS)

    def test_published_reaction_without_ribs(self):
        self.assert_agrees(SCENARIOS / "published_healthy.toml", *TURN, steps=TURN_STEPS)

    def test_paralysis(self):
        self.assert_agrees(SCENARIOS / "hemiparalysis_right.toml", *TURN, steps=TURN_STEPS)

    def test_driven_rib_cage(self):
        self.assert_agrees(self.scenario(BUCKET_HANDLE), *TURN, steps=TURN_STEPS)

    def test_free_central_tendon(self):
        """On the paralysed trunk, where it tilts."""
        self.assert_agrees(self.scenario(FREE_TENDON + PARALYSIS, "healthy_no_lung"), *TURN, steps=TURN_STEPS)

    def test_friction_and_membrane(self):
        """Particles slide, stick, and slide again."""
        self.assert_agrees(HEALTHY, *BREATH, *RUBBING, steps=BREATH_STEPS)

    def test_loads_of_every_kind(self):
        self.assert_agrees(self.scenario(LOADS, fields=FIELDS), *SHORT, steps=SHORT_STEPS)

    def test_all_at_once_and_again_from_a_trunk_file(self):
        """The second time from what an export says of every particle, changed."""
        tables = BUCKET_HANDLE + FREE_TENDON + LOADS.replace("80,83", "70,71")
        self.assert_agrees(self.scenario(tables, "healthy_no_lung", FIELDS), *SHORT, *RUBBING, steps=SHORT_STEPS)
        self.succeeds("export", "run.h5", "--pml", "trunk")
        trunk = self.folder / "trunk" / "trunk.pml"
        text = trunk.read_text(encoding="utf-8")
        for name, factor in (("mass", 1.2), ("stiffness", 0.9), ("damping", 1.1), ("strength", 1.3)):
            text, found = re.subn(rf' {name}="([^"]+)"', lambda m: f' {name}="{factor * float(m[1]):.17g}"', text)
            self.assertGreater(found, 0)
        trunk.write_text(text, encoding="utf-8")
        self.assert_agrees("trunk/scenario.toml", steps=SHORT_STEPS)

    @at_night
    def test_lung_and_airway(self):
        """At ribs that rub."""
        lasts, steps = (BREATH, BREATH_STEPS) if NIGHTLY else (SHORT, SHORT_STEPS)
        self.assert_agrees(self.scenario(LUNG), *lasts, *RUBBING, "--set", "tissue.damping=area", steps=steps)

    def test_lung_beside_moving_ribs(self):
        self.assert_agrees(self.scenario(BUCKET_HANDLE + LUNG + LOADS, "hemiparalysis_right", fields=FIELDS), *SHORT,
                           steps=SHORT_STEPS)

    @at_night
    def test_sees_a_millionth_of_the_resistance(self):
        self.assert_sees(self.scenario(LUNG), *SHORT, change="lung.resistance_cmH2O_s_per_L", factor=1 + 1e-6)

    @at_night
    def test_finer_mesh(self):
        self.assert_agrees(self.scenario(BUCKET_HANDLE + FREE_TENDON, "healthy_no_lung"), *RUBBING, "--set", "geometry.resolution=2",
                           "--set", "time.dt_ms=0.5", "--set", "time.duration_s=0.2", steps=400)

    def test_sheet_with_slivers_and_again_from_a_trunk_file(self):
        """The subject's mesh has thin triangles, whose weights meet their bound."""
        sheet = ("--set", "tissue.elasticity=sheet", "--set", "paralysis.side=right", "--set", "time.dt_ms=2",
                 "--set", "time.start=rest", "--set", f"time.duration_s={0.002 * SHORT_STEPS:.3f}")
        self.assert_agrees(SCENARIOS / "craighero.toml", *sheet, steps=SHORT_STEPS)
        self.succeeds("export", "run.h5", "--pml", "trunk")
        self.assert_agrees("trunk/scenario.toml", steps=SHORT_STEPS)

    @at_night
    def test_breathing_that_repeats(self):
        """The oracle finds the breath that repeats by itself: it breathes from rest until two breaths are the same."""
        breath = ("--set", "time.duration_s=1.2", "--set", "activation.onset_s=-0.1", "--set", "activation.rise_s=0.5",
                  "--set", "activation.slow_fall_s=0.7", *STEP)
        self.succeeds("simulate", HEALTHY, "-o", "rest.h5", *SHORT)
        self.succeeds("simulate", HEALTHY, "-o", "run.h5", *breath, "--set", "time.start=periodic")
        answer = self.ask("run.h5", "--rest", "rest.h5", "--tolerance", "1e-6")
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
        with h5py.File(self.folder / "run.h5") as run:
            level = run["measures/end_expiratory_above_relaxation_ml"][()]
        self.assertGreater(level, 20)
        answer = self.ask("run.h5")
        self.assertEqual(answer.returncode, 2)
        self.assertIn("--rest", answer.stderr)

    def test_sees_a_millionth_of_the_muscle(self):
        self.assert_sees(HEALTHY, *SHORT, change="parameters.k_muscle_N_per_m", factor=1 + 1e-6)
        self.assertEqual(self.ask("run.h5").returncode, 0)
        self.assertEqual(self.ask("other.h5", "--tolerance", "1e-7").returncode, 0)

    def test_sees_a_hundredth_of_the_friction(self):
        self.assert_sees(HEALTHY, *SHORT, *RUBBING, change="tissue.rib_friction", factor=1.01)

    def test_sees_other_rigid_parts(self):
        """A run whose parts are not those of its scenario is no run of it."""
        self.succeeds("simulate", NO_LUNG, "-o", "run.h5", *SHORT)
        self.succeeds("simulate", self.scenario(FREE_TENDON, "healthy_no_lung"), "-o", "other.h5", *SHORT)
        with h5py.File(self.folder / "run.h5") as run, h5py.File(self.folder / "other.h5", "r+") as other:
            del other[TEXT]
            other[TEXT] = np.bytes_(run[TEXT][()])
        answer = self.ask("other.h5")
        self.assertEqual(answer.returncode, 2)
        self.assertIn("rigid parts", answer.stderr)

    def test_what_is_not_a_run(self):
        answer = self.ask(HEALTHY)
        self.assertEqual(answer.returncode, 2)
        self.assertRegex(answer.stderr, r"\Aoracle: [^\n]*not a run[^\n]*\n\Z")


if __name__ == "__main__":
    unittest.main()
