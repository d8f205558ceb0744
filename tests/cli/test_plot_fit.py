"""scripts/plot_fit.py draws the joint region that the fit computed, and reads files of trunk.fit/1."""

import importlib.util
import subprocess
import unittest

from support import FAST_FIT, HEALTHY, ROOT, TrunkTest, trace

try:
    import h5py
    import matplotlib.figure
    import numpy as np
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py python3-matplotlib")

SCRIPT = ROOT / "scripts" / "plot_fit.py"


def plot_fit():
    specification = importlib.util.spec_from_file_location("plot_fit", SCRIPT)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


class PlotFit(TrunkTest):
    def setUp(self):
        super().setUp()
        self.file("t.csv", trace(count=12))
        self.json = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, codes=(0, 4))

    def test_the_region_is_that_of_the_fit(self):
        axes = matplotlib.figure.Figure().subplots()
        with h5py.File(self.folder / "f.h5") as fit:
            plot_fit().plot_surface(fit, axes)
            grid = [fit["surface"][name][()] for name in ("first", "second")]
        lines = [c for c in axes.collections if list(c.get_linewidth()) == [2]]  # the level line; areas have none
        points = np.concatenate([path.vertices for c in lines for path in c.get_paths()])
        for axis, name in enumerate(("k_elasticity", "k_muscle/k_elasticity")):
            known = self.json["surface"]["joint95"][name]
            for drawn, end in ((points[:, axis].min(), "lower"), (points[:, axis].max(), "upper")):
                apart = np.diff(np.interp([drawn, known[end]], grid[axis], range(len(grid[axis]))))  # steps of the grid
                self.assertLess(abs(apart[0]), 0.05, (name, end))

    def test_draws_a_file_of_either_version(self):
        for version in (2, 1):
            with self.subTest(version):
                if version == 1:
                    with h5py.File(self.folder / "f.h5", "r+") as file:
                        file.attrs.modify("schema_version", np.int32(1))
                        del file["results"]
                        for profile in file["profiles"].values():
                            del profile["threshold95"]
                done = subprocess.run(["/usr/bin/python3", SCRIPT, "f.h5", "-o", "f.png"], cwd=self.folder,
                                      capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual((self.folder / "f.png").read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
