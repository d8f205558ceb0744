"""Pages of `trunk report` in a real browser, from file://: every kind, as README's commands make them.

Pictures of the pages go to the folder TRUNK_SCREENSHOTS, where it is set."""

import os
import unittest
from pathlib import Path

import browser
from support import COARSE, FAST_FIT, HEALTHY, ROOT, SCENARIOS, TrunkTest, scenario_with, trace

try:
    import h5py
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

TRUNK = "document.querySelector('canvas.trunk')"
TIME = "return document.querySelector('.player input').valueAsNumber"


class PageTest(TrunkTest):
    @classmethod
    def setUpClass(cls):
        cls.browser = browser.Browser(900, 700)
        cls.addClassCleanup(cls.browser.close)

    def opened(self, *files, name):
        """`files` and options."""
        self.succeeds("report", *files, "-o", f"{name}.html")
        self.browser.open(self.folder / f"{name}.html")
        return self.browser

    def finish(self, name):
        """Nothing went wrong and nothing was asked for; a picture is kept where that is wished for."""
        self.assertEqual(self.browser.console(), [])
        asked = [u for u in self.browser.requests() if not u.startswith(("file://", "data:", "blob:", "chrome"))]
        self.assertEqual(asked, [])
        if folder := os.environ.get("TRUNK_SCREENSHOTS"):
            Path(folder).mkdir(parents=True, exist_ok=True)
            self.browser.screenshot(Path(folder) / f"{name}.png", whole=True)

    def picture(self, canvas=TRUNK):
        """A number that another picture would not have."""
        return self.browser.run(f"""
            let sum = 0;
            for (const c of {canvas}.toDataURL()) sum = (31 * sum + c.charCodeAt(0)) | 0;
            return sum;""")

    def colours(self, canvas=TRUNK):
        """How many different colours the canvas shows, of every 40th pixel."""
        return self.browser.run(f"""
            const copy = document.createElement('canvas'), from = {canvas};
            [copy.width, copy.height] = [from.width, from.height];
            const context = copy.getContext('2d');
            context.drawImage(from, 0, 0);
            const {{data}} = context.getImageData(0, 0, copy.width, copy.height);
            const seen = new Set();
            for (let i = 0; i < data.length; i += 160) seen.add(data.slice(i, i + 4).join());
            return seen.size;""")

    def cell(self, row, column=1):
        return self.browser.run("""
            const row = [...document.querySelectorAll('tbody tr')].find((r) => r.cells[0].textContent === arguments[0]);
            return row?.cells[arguments[1]].textContent;""", row, column)

    def wait_for_paint(self):
        self.browser.driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")


class Page(PageTest):
    def test_beside_a_measured_surface(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        self.succeeds("export", "r.h5", "--pml", "mine")
        page = self.opened("r.h5", "--surface", "mine/trunk.pml", "--component", "lung", "--region", "lung", "--at", "end",
                           name="beside")
        self.wait_for_paint()
        self.assertEqual(page.run("return document.querySelector('select[aria-label=\"colour by\"]').value"), "side")
        self.assertAlmostEqual(page.run(TIME), 0.3, delta=0.02)
        self.assertIn("at 0.30 s", page.run("return document.querySelector('.legend').textContent"))
        self.assertGreater(self.colours(), 30)
        self.assertGreater(float(self.cell("model to surface", 2)), 0)
        before = self.picture()
        page.run("document.querySelector('[data-part=target]').click()")
        self.wait_for_paint()
        self.assertNotEqual(self.picture(), before, "the measured surface was not to be seen")
        self.finish("beside")

    def test_run(self):
        json = self.succeeds("simulate", HEALTHY, "-o", "r.h5")
        page = self.opened("r.h5", name="run")
        self.wait_for_paint()
        self.assertGreater(self.colours(), 30, "the trunk is blank")
        for number in range(page.run("return document.querySelectorAll('.uplot canvas').length")):
            self.assertGreater(self.colours(f"document.querySelectorAll('.uplot canvas')[{number}]"), 3, "a curve is blank")
        self.assertEqual(float(self.cell("ΔV, tidal volume")), float(f"{json['delta_v_ml']:.4g}"))
        self.assertEqual(float(self.cell("peak abdominal pressure")), float(f"{json['abdominal_pressure_peak_cmH2O']:.4g}"))
        # It opens at the largest volume.
        self.assertEqual(page.run("return document.querySelector('[data-readout=dV_model]').textContent"),
                         f"{json['delta_v_ml']:.0f} ml")
        self.check_keys(page)
        self.check_scrubbing(page)
        self.check_parts(page)
        self.finish("run")

    def check_keys(self, page):
        page.run("document.activeElement.blur()")
        page.keys("\ue011")  # Home
        self.assertEqual(page.run(TIME), 0)
        page.keys("\ue014", "\ue014", "\ue012")  # right, right, left
        self.assertAlmostEqual(page.run(TIME), 0.01, delta=1e-9)
        before = self.picture()
        page.keys(" ")
        page.until(f"{TIME} > 0.5")
        page.keys(" ")
        stopped = page.run(TIME)
        self.wait_for_paint()
        self.assertEqual(page.run(TIME), stopped, "it does not pause")
        self.assertNotEqual(self.picture(), before, "it plays, and nothing moves")
        page.keys("\ue010")  # End
        self.assertAlmostEqual(page.run(TIME), 4.5, delta=1e-9)
        page.run(f"{TRUNK}.focus()")
        turned = self.picture()
        page.keys("\ue012")
        self.assertAlmostEqual(page.run(TIME), 4.5, delta=1e-9, msg="an arrow on the trunk turns it")
        self.assertNotEqual(self.picture(), turned)

    def check_scrubbing(self, page):
        """At a time set by the slider the readout is the file's value."""
        with h5py.File(self.folder / "r.h5") as file:
            time, volume = file["curves/time"][()], file["curves/dV_model"][()]
        for at in (1.0, 3.2):
            before = self.picture()
            page.run("""const slider = document.querySelector('.player input');
                        slider.value = arguments[0]; slider.dispatchEvent(new Event('input', {bubbles: true}));""", at)
            self.assertNotEqual(self.picture(), before)
            expected = volume[abs(time - at).argmin()]
            shown = page.run("return document.querySelector('[data-readout=dV_model]').textContent")
            self.assertEqual(shown, f"{expected:.0f} ml")

    def check_parts(self, page):
        for part in ("ghost", "lungs", "muscle", "tendon", "abdomen", "pelvis", "fibres", "contact"):
            before = self.picture()
            page.run(f"document.querySelector('[data-part={part}]').click()")
            self.assertNotEqual(self.picture(), before, f"{part} cannot be hidden")
        self.assertLessEqual(self.colours(), 2, "all parts are hidden, and something is there")
        page.run("document.querySelectorAll('[data-part]').forEach((box) => box.click())")

    def test_two_runs(self):
        self.succeeds("simulate", HEALTHY, "-o", "healthy.h5")
        self.succeeds("simulate", SCENARIOS / "hemiparalysis_right.toml", "-o", "paralysed.h5")
        page = self.opened("healthy.h5", "paralysed.h5", name="two")
        self.wait_for_paint()
        pictures = [self.picture(f"document.querySelectorAll('canvas.trunk')[{i}]") for i in (0, 1)]
        self.assertNotEqual(*pictures)
        with h5py.File(self.folder / "healthy.h5") as a, h5py.File(self.folder / "paralysed.h5") as b:
            volumes = [f["measures/delta_v_ml"][()] for f in (a, b)]
        self.assertEqual([float(self.cell("ΔV, tidal volume", i)) for i in (1, 2)], [float(f"{v:.4g}") for v in volumes])
        self.finish("two")

    def test_fit(self):
        json = self.succeeds("fit", HEALTHY, "--trace", ROOT / "reference" / "constructed_trace.csv", "-o", "f.h5")
        page = self.opened("f.h5", name="fit")
        self.assertEqual(page.run("return document.querySelector('.verdict').textContent"), json["verdict"])
        for name, estimate in json["parameters"].items():
            self.assertEqual(float(self.cell(name)), float(f"{estimate['value']:.5g}"), name)
        self.assertEqual(page.run("return document.querySelectorAll('.drawing.large image').length"), 1)
        self.assertGreater(page.run("return document.querySelectorAll('.drawing.large .region:not(.under)').length"), 20)
        recoil = json["results"]["recoil_time_s"]
        shown = " to ".join(f"{recoil[end]:.3g}" for end in ("lower95", "upper95"))
        self.assertEqual(self.cell("recoil time"), f"{recoil['value']:.3g} ({shown}) s")
        self.assertRegex(self.cell("recoil time", 2), r"\Aassumes \((\d, )*\d\)\Z")
        for assumption in recoil["assumption"].split("; "):
            self.assertIn(assumption, page.run("return document.querySelector('ol').textContent"))
        self.finish("fit")

    def test_a_gate_withholds(self):
        self.file("small.csv", trace(tidal_ml=40))  # 0.8 % of this trunk's end-expiratory volume
        self.succeeds("fit", HEALTHY, "--trace", "small.csv", "-o", "f.h5", *FAST_FIT, codes=(4,))
        page = self.opened("f.h5", name="gate")
        self.assertEqual((self.cell("recoil time"), self.cell("recoil time", 2)), ("withheld", "not determined (1)"))
        text = page.run("return document.body.innerText")
        self.assertIn("gates: subject size", text)
        self.assertEqual(page.run("return document.querySelectorAll('.drawing.large image').length"), 0)
        with h5py.File(self.folder / "f.h5") as file:
            best = dict(zip(file["parameters/name"].asstr()[()], file["parameters/best"][()]))
        self.assertNotIn(f"{best['k_elasticity']:.5g}", text)
        self.finish("gate")

    def test_sweep_of_60_runs(self):
        self.succeeds("sweep", SCENARIOS / "sweep_paralysis.toml", "-o", "d")
        page = self.opened("d/sweep.h5", name="sweep_60")
        with h5py.File(self.folder / "d" / "sweep.h5") as file:
            volumes = sorted(float(f"{v:.5g}") for v in file["table/delta_v_ml"][()])
        self.assertEqual(len(volumes), 60)
        number = page.run("""return [...document.querySelectorAll('.sortable th')].findIndex(
            (h) => h.firstChild.title === 'sort by ΔV, tidal volume')""")
        shown = page.run("""return [...document.querySelectorAll('.sortable tbody tr')].map(
            (r) => Number(r.cells[arguments[0]].textContent))""", number)
        self.assertEqual(sorted(shown), volumes)
        self.assertEqual(page.run("return document.querySelectorAll('.cell path').length"), 60)
        self.finish("sweep_60")

    def test_sweep_sorts(self):
        design = self.file("s.toml", f'schema = "trunk.sweep/1"\nscenarios = ["{HEALTHY}", "{SCENARIOS}/hemiparalysis_right.toml"]\n'
                                     '[grid]\n"parameters.k_muscle_N_per_m" = [20, 30.5, 9]\n"time.dt_ms" = [3]\n'
                                     '"time.duration_s" = [0.3]\n')
        self.succeeds("sweep", design, "-o", "d")
        page = self.opened("d/sweep.h5", name="sweep")
        self.assertEqual(page.run("return document.querySelectorAll('.cell').length"), 3)
        self.assertEqual(page.run("return document.querySelectorAll('.cell path').length"), 6)
        column = "return [...document.querySelectorAll('.sortable tbody tr')].map((r) => Number(r.cells[2].textContent))"
        page.run("document.querySelectorAll('.sortable th button')[2].click()")
        self.assertEqual(page.run(column), [9, 9, 20, 20, 30.5, 30.5])
        page.run("document.querySelectorAll('.sortable th button')[2].click()")
        self.assertEqual(page.run(column), [30.5, 30.5, 20, 20, 9, 9])
        self.finish("sweep")

    def test_hostile_texts_do_not_run(self):
        harm = '</script><script>window.harmed = 1</script><img src=x onerror="window.harmed = 1">'
        self.file("s.toml", scenario_with().replace("title = ", f"title = '''{harm}''' # ", 1))
        self.succeeds("simulate", "s.toml", "-o", "r.h5", *COARSE)
        page = self.opened("r.h5", name="hostile")
        self.assertIsNone(page.run("return window.harmed ?? null"))
        self.assertEqual(page.run("return document.querySelector('h1').textContent"), harm)
        self.assertEqual(page.run("return document.querySelectorAll('img').length"), 0)
        self.finish("hostile")

    def test_nothing_to_draw_is_said(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE, "--every", "0")
        page = self.opened("r.h5", name="summary")
        self.assertIn("holds no trajectory", page.run("return document.body.innerText"))
        self.assertEqual(page.run("return document.querySelectorAll('canvas.trunk').length"), 0)
        self.finish("summary")


class Dark(TrunkTest):
    def test_theme_follows_the_system_and_the_reader(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        dark = browser.Browser(600, 500, dark=True)
        self.addCleanup(dark.close)
        self.succeeds("report", "r.h5", "-o", "r.html")
        dark.open(self.folder / "r.html")
        paper = "return getComputedStyle(document.documentElement).backgroundColor.match(/[0-9]+/g).map(Number)"
        self.assertLess(max(dark.run(paper)), 60)
        dark.run("document.querySelector('.theme').click()")
        self.assertGreater(min(dark.run(paper)), 200)


if __name__ == "__main__":
    unittest.main()
