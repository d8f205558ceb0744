"""A trunk of one's own, and what goes wrong with it: no wrong number may come out in silence."""

import re
import unittest

from support import AT_REST, HEALTHY, SCENARIOS, TrunkTest

SHORT = ("--set", "time.duration_s=0.2")


class OwnTrunk(TrunkTest):
    def setUp(self):
        super().setUp()
        self.succeeds("simulate", HEALTHY, "-o", "run.h5", *SHORT)
        self.succeeds("export", "run.h5", "--pml", "mine")
        self.pml = (self.folder / "mine" / "trunk.pml").read_text()

    def refused_trunk(self, text, *says):
        self.assertNotEqual(text, self.pml)
        (self.folder / "other.pml").write_text(text)
        self.refused("simulate", HEALTHY, "--set", "geometry.pml=other.pml", "-o", "other.h5", says=says)
        self.assertFalse((self.folder / "other.h5").exists())

    def moved(self, move):
        """The trunk with every atom elsewhere."""
        def replaced(match):
            x, y, z = move(*(float(number) for number in match.groups()))
            return f'x="{x}" y="{y}" z="{z}"'
        return re.sub(r'x="([^"]+)" y="([^"]+)" z="([^"]+)"', replaced, self.pml)

    def test_other_axes_and_units_do_not_pass(self):
        self.refused_trunk(self.moved(lambda x, y, z: (-x, -y, z)), "right", r"other\.pml")  # DICOM's
        self.refused_trunk(self.moved(lambda x, y, z: (x, -z, y)), "up")  # lying
        self.refused_trunk(self.moved(lambda x, y, z: (x / 1000, y / 1000, z / 1000)), "unit", "ml")
        self.refused_trunk(self.pml.replace('unit="mm"', 'unit="m"'), "unit", "ml")

    def test_missing_regions_do_not_pass(self):
        for name in ("zone_of_apposition", "costal_insertion", "pelvis", "abdominal_wall", "fixed"):
            with self.subTest(name):
                self.refused_trunk(self.pml.replace(f'name="{name}"', 'name="something"'), name)

    def test_where_it_stands_does_not_matter(self):
        paralysed = SCENARIOS / "hemiparalysis_right.toml"
        volumes = []
        for shift in (0.0, 1e-12, 300.0):
            (self.folder / "moved.pml").write_text(self.moved(lambda x, y, z: (x + shift, y, z)))
            run = self.succeeds("simulate", paralysed, "--set", "geometry.pml=moved.pml", "-o", "moved.h5", "--force",
                                *AT_REST, "--set", "time.duration_s=1")
            volumes.append(run["delta_v_ml"])
        self.assertGreater(volumes[0], 10)
        for volume in volumes[1:]:
            self.assertAlmostEqual(volume, volumes[0], delta=1e-4)

    def test_a_setting_that_the_file_overrules_is_refused(self):
        for setting in ("geometry.half_width_mm=300", "geometry.resolution=2", "tissue.particle_mass_kg=2",
                        "tissue.tendon_stiffness_factor=5"):
            with self.subTest(setting):
                self.refused("simulate", "mine/scenario.toml", "--set", setting, "-o", "other.h5",
                             says=("no effect", r"trunk\.pml"))
        self.succeeds("simulate", "mine/scenario.toml", "--set", "tissue.ribs=false", "-o", "free.h5", *SHORT)


class TooMuch(TrunkTest):
    def test_a_lung_that_loses_its_volume_is_no_breath(self):
        self.file("up.toml", f'''extends = "{HEALTHY}"
[[rigid]]
region = "central_tendon"
motion = "driven"
direction = [0, 0, 1]
events_mm = [[0, 0], [1, 250]]
''')
        outcome = self.trunk("simulate", "up.toml", "-o", "up.h5", *AT_REST, "--set", "time.duration_s=1", "--json")
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assertEqual(outcome.json()["status"], "diverged")

    def test_loads_are_said_to_be_in_the_measures(self):
        self.file("heavy.toml", f'extends = "{HEALTHY}"\ngravity_m_s2 = [0, 0, -3]\n')
        for start, says in (("rest", "gravity or loads"), ("periodic", "gravity and loads .* in the volume above relaxation")):
            outcome = self.trunk("simulate", "heavy.toml", "-o", "heavy.h5", "--force", *SHORT, "--set", f"time.start={start}")
            self.assertEqual(outcome.code, 0, str(outcome))
            self.assertRegex(outcome.err, says)


if __name__ == "__main__":
    unittest.main()
