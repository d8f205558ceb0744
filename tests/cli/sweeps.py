"""What tests of sweeps share: designs, and what a finished folder holds."""

import csv
import io

from support import NO_LUNG, TrunkTest, catches, start

GRID = '"time.dt_ms" = [3]\n"time.duration_s" = [0.3]\n'
OF_GRID = ("--set", "time.dt_ms=3", "--set", "time.duration_s=0.3")  # of a run alone
SLOW_GRID = '"time.dt_ms" = [0.01]\n"time.duration_s" = [0.3]\n'  # 30,000 steps: no machine does them in a millisecond


class SweepTest(TrunkTest):
    def design(self, grid, name="s.toml", scenarios=(NO_LUNG,), top=""):
        return self.file(name, f'schema = "trunk.sweep/1"\ntitle = "test"\nscenarios = {list(map(str, scenarios))}\n'
                               f"{top}\n[grid]\n{grid}")

    def muscles(self, count, extra=GRID, top=""):
        return self.design(f'"parameters.k_muscle_N_per_m" = {{ from = 10, to = 60, count = {count} }}\n{extra}', top=top)

    def rows(self, folder="d"):
        return list(csv.DictReader(io.StringIO((self.folder / folder / "table.csv").read_text())))

    def finished(self, folder="d"):
        return {p.name: (p.stat().st_ino, p.stat().st_mtime_ns) for p in (self.folder / folder / "runs").glob("*.h5")}

    def assert_all_there(self, count, folder="d"):
        status = self.succeeds("status", folder)
        self.assertEqual((status["runs"], status["done"], status["has_table"]), (count, count, True))
        rows = self.rows(folder)
        self.assertEqual([int(r["run"]) for r in rows], list(range(count)))
        self.assertEqual({r["status"] for r in rows}, {"completed"})
        self.assertEqual(set(self.finished(folder)), {f"{i:05}.h5" for i in range(count)})
        self.assert_no_part()

    def stopped(self, sign, after, *command):
        process = start(*command, cwd=self.folder)
        ready = lambda: len(self.finished()) >= after and catches(process)
        return self.interrupt(process, ready, sign)
