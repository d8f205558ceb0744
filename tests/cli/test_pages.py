"""The pages (*.md) do what they say: every `sh` and `python` block runs, links and file names lead somewhere, and no page
is too long to read. Each page has a class of its own, so that `python3 test_pages.py FitPage` runs one."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import LIMIT_S, PROGRAM, ROOT

LARGEST = {"README.md": 10_240}
LARGEST_OTHER = 12_288
LONGEST_LINE = 400
NEEDED = ("scenarios", "reference", "scripts")  # what a page's commands find in their folder, beside build/trunk
BY_PEOPLE = ("scripts/quickstart", "scripts/test", "git clone")  # people and CI run these, no test does
LANGUAGES = {"sh", "python", "matlab", "text", ""}

FENCED = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.M | re.S)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
FILE_NAME = re.compile(r"(?:\.github|libtrunk|fit|scenarios|reference|tests|scripts)/[\w./-]+")


def pages():
    """Paths of all pages, relative to the project: those git knows, else all outside of build folders."""
    try:
        listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"],
                                capture_output=True, text=True, check=True).stdout.split("\0")
        found = [path for path in listed if path and (ROOT / path).is_file()]
    except (OSError, subprocess.CalledProcessError):
        found = []
    if not found:
        found = [str(path.relative_to(ROOT)) for path in ROOT.rglob("*.md")]
        found = [path for path in found if not re.search(r"(^|/)(build[^/]*|node_modules|\.git)/", path)]
    return sorted(found)


def anchors(text):
    """Names of the headings as GitHub makes them: lower case, no punctuation, hyphens for spaces."""
    headings = re.findall(r"^#+ +(.*?) *$", FENCED.sub("", text), re.M)
    return [re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings]


def shell_script(block):
    """The block with the lines left out that people run. Exit 4 of a fit is a result, not a mistake."""
    lines = [line for line in block.splitlines() if not line.startswith(BY_PEOPLE)]
    return "set -e\n" + "\n".join(
        f"{line} || [ $? -eq 4 ]" if line.startswith("build/trunk fit") else line for line in lines)


class Page:
    """Tests of one page; `make_test_class` gives each page a class with its path."""

    path = ""

    @classmethod
    def setUpClass(cls):
        cls.text = (ROOT / cls.path).read_text(encoding="utf-8")
        cls.prose = FENCED.sub("", cls.text)

    def test_blocks_run_in_order(self):
        with tempfile.TemporaryDirectory(prefix="trunk_page_") as folder:
            work = Path(folder)
            for name in NEEDED:
                shutil.copytree(ROOT / name, work / name, ignore=shutil.ignore_patterns("node_modules"))
            (work / "build").mkdir()
            (work / "build" / "trunk").symlink_to(PROGRAM)
            for language, block in FENCED.findall(self.text):
                with self.subTest(block=block.splitlines()[0]):
                    self.run_block(language, block, work)

    def run_block(self, language, block, work):
        self.assertIn(language, LANGUAGES, "a block of this language is never run")
        if language == "matlab":
            self.read_as_matlab(block, work)
        elif language == "python":
            self.run_command(["/usr/bin/python3", "-c", block], work)
        elif language == "sh":
            self.run_command(["bash", "-c", shell_script(block)], work)

    def run_command(self, command, work):
        done = subprocess.run(command, cwd=work, capture_output=True, text=True, timeout=LIMIT_S,
                              stdin=subprocess.DEVNULL, env={**os.environ, "MPLBACKEND": "Agg"})
        self.assertEqual(done.returncode, 0, f"{command[-1]}\n{done.stdout}{done.stderr}")

    def read_as_matlab(self, block, work):
        """MATLAB is not in Debian: what its calls name is there, and can be read."""
        import h5py
        calls = re.findall(r'h5read(att)?\("([^"]+)", "([^"]+)"(?:, "([^"]+)")?\)', block)
        self.assertGreater(len(calls), 0)
        self.assertEqual(len(calls), block.count("h5read"))
        for is_attribute, file, path, name in calls:
            with h5py.File(work / file) as opened:
                value = opened[path].attrs[name] if is_attribute else opened[path][()]
                self.assertGreater(len(value), 0, path)

    def test_links_lead_somewhere(self):
        for link in LINK.findall(self.prose):
            if re.match(r"[a-z]+:", link):
                continue  # of the network
            with self.subTest(link=link):
                file, _, anchor = link.partition("#")
                target = (ROOT / self.path).parent / file if file else ROOT / self.path
                self.assertTrue(target.is_file(), f"{target} is not there")
                self.assertTrue(target.resolve().is_relative_to(ROOT), f"{target} is not in the project")
                if anchor:
                    self.assertIn(anchor, anchors(target.read_text(encoding="utf-8")))

    def test_files_it_names_exist(self):
        for code in CODE.findall(self.prose):
            for name in filter(FILE_NAME.fullmatch, code.split()):
                with self.subTest(file=name):
                    self.assertTrue((ROOT / name).exists(), f"{name} is not there")

    def test_length(self):
        most = LARGEST.get(self.path, LARGEST_OTHER)
        self.assertLessEqual(len(self.text.encode()), most, "bytes")
        for line in self.prose.splitlines():
            self.assertLessEqual(len(line), LONGEST_LINE, line)

    def test_is_markdown_alone(self):
        self.assertEqual(self.text.count("\n```") % 2, 0, "a block does not end")
        self.assertIsNone(re.search(r"</?[a-z]+[ >]", CODE.sub("", self.prose)), "there is HTML in it")


def make_test_class(path):
    """A test case of its own for a page; libtrunk/io/README.md becomes LibtrunkIoPage."""
    parts = [part for part in re.split(r"[/.\W]+", path) if part not in ("", "README", "md")]
    name = "".join(part.capitalize() for part in parts or ["front"]) + "Page"
    return type(name, (Page, unittest.TestCase), {"path": path, "__module__": __name__})


for page in pages():
    test_class = make_test_class(page)
    assert test_class.__name__ not in globals(), f"two pages are called {test_class.__name__}"
    globals()[test_class.__name__] = test_class
del page, test_class


class AllPages(unittest.TestCase):
    def test_front_page_leads_to_every_page(self):
        front = (ROOT / "README.md").read_text(encoding="utf-8")
        linked = {str((ROOT / link.partition("#")[0]).resolve().relative_to(ROOT))
                  for link in LINK.findall(front) if "://" not in link and not link.startswith("#")}
        for path in pages():
            if path != "README.md":
                self.assertIn(path, linked)

    def test_there_are_blocks(self):
        """A change of the pattern of blocks must not pass for a page without blocks."""
        blocks = [language for path in pages() for language, _ in FENCED.findall((ROOT / path).read_text(encoding="utf-8"))]
        self.assertGreaterEqual(blocks.count("sh"), 15)
        self.assertGreaterEqual(blocks.count("python"), 3)
        self.assertGreaterEqual(blocks.count("matlab"), 1)


if __name__ == "__main__":
    unittest.main()
