"""The published cases of reference/cases: fits whose answer is known."""

import json
import unittest

from support import NO_LUNG, ROOT, TrunkTest

CASES = ROOT / "reference" / "cases"


class Cases(TrunkTest):
    def test_all(self):
        for case in json.loads((CASES / "cases.json").read_text())["cases"]:
            with self.subTest(case["name"]):
                expected = case["expected"]
                fit = self.succeeds("fit", NO_LUNG, "--trace", CASES / case["trace"], "-o", "f.h5", "--force",
                                    "--set", "time.dt_ms=2", "--surface", "0", *case["options"], codes=(expected["exit"],))
                self.assertEqual(fit["grade"], expected["grade"])
                truth = {**case["truth"], "ratio": case["truth"]["k_muscle"] / case["truth"]["k_elasticity"]}
                found = {**fit["parameters"], "ratio": fit["ratio"]}
                for name, tolerance in expected["within"].items():
                    self.assertAlmostEqual(found[name]["value"] / truth[name], 1, delta=tolerance, msg=name)
                for name, value in truth.items():
                    self.assertTrue(found[name]["lower95"] < value < found[name]["upper95"], f"{name}: {found[name]}")
                objective, tolerance = expected["objective"]
                self.assertAlmostEqual(fit["objective"] / objective, 1, delta=tolerance)


if __name__ == "__main__":
    unittest.main()
