"""The pages of the public headers are made without a warning. Environment: GEARFILM_BUILD, a configured build folder."""
import os
import pathlib
import shutil
import subprocess
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[1]
BUILD = os.environ.get("GEARFILM_BUILD", str(SOURCE / "build/release"))


@unittest.skipUnless(shutil.which("doxygen"), "Doxygen is not installed")
class Pages(unittest.TestCase):
    def test_no_warnings(self):
        done = subprocess.run([SOURCE / "scripts/pages.sh", BUILD], capture_output=True, text=True, check=False,
                              timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        pages = SOURCE / "build/pages/html"
        self.assertTrue((pages / "mesh__march_8hpp.html").exists())
        self.assertIn("F* = 2 pi/(3 kappa)", (pages / "scales_8hpp.html").read_text(encoding="utf-8"))
        self.assertFalse(list(pages.glob("*multigrid__level*")), "private headers have no pages")


if __name__ == "__main__":
    unittest.main()
