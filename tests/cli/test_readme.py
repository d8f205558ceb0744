"""The blocks of README.md do what they say: every `sh` block runs, every `python` block runs on what it made."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import PROGRAM, ROOT

BLOCK = re.compile(r"^```(sh|python|matlab)\n(.*?)^```$", re.M | re.S)
INSTALLS = ("scripts/quickstart", "scripts/test", "git clone")  # run by people and by CI, not by a test


def blocks():
    return BLOCK.findall((ROOT / "README.md").read_text())


class Readme(unittest.TestCase):
    def test_every_block_runs_in_order(self):
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            for name in ("scenarios", "reference", "scripts"):
                shutil.copytree(ROOT / name, work / name)
            (work / "build").mkdir()
            (work / "build" / "trunk").symlink_to(PROGRAM)
            self.assertGreaterEqual(len(blocks()), 4)
            for language, text in blocks():
                with self.subTest(block=text.splitlines()[0]):
                    self.run_block(language, text, work)

    def run_block(self, language, text, work):
        if language == "matlab":
            return self.read_as_matlab(text, work)
        if language == "python":
            command = ["/usr/bin/python3", "-c", text]
        else:
            lines = [line for line in text.splitlines() if not line.startswith(INSTALLS)]
            # Exit 4 says that a parameter is not identifiable: a result, not a mistake.
            command = ["bash", "-c", "set -e\n" + "\n".join(
                f"{line} || [ $? -eq 4 ]" if line.startswith("build/trunk fit") else line for line in lines)]
        done = subprocess.run(command, cwd=work, capture_output=True, text=True, timeout=120,
                              env={**os.environ, "MPLBACKEND": "Agg"})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def read_as_matlab(self, text, work):
        """MATLAB is not in Debian: what its calls name is there, and read."""
        import h5py
        calls = re.findall(r'h5read(att)?\("([^"]+)", "([^"]+)"(?:, "([^"]+)")?\)', text)
        self.assertEqual(len(calls), text.count("h5read"))
        for is_attribute, file, path, name in calls:
            with h5py.File(work / file) as opened:
                value = opened[path].attrs[name] if is_attribute else opened[path][()]
                self.assertGreater(len(value), 0, path)

    def test_files_it_names_exist(self):
        text = (ROOT / "README.md").read_text()
        for path in re.findall(r"`((?:scripts|scenarios|reference|libtrunk|fit|tests)/[\w./-]+)`", text):
            with self.subTest(path=path):
                self.assertTrue((ROOT / path).exists(), path)


if __name__ == "__main__":
    unittest.main()
