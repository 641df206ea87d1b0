"""The fields of a march as ParaView sees them: its readers' own library, block names, times, values."""
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

import h5py
import numpy
from PIL import Image

from films import BARBIERI
from program import SECONDS, SOURCE
from vibration import MARCH, VibrationTest

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
except ImportError:
    vtkXdmfReader = None


def pvpython(*words):
    return subprocess.run(["xvfb-run", "-a", "pvpython", *map(str, words)], capture_output=True, text=True,
                          timeout=SECONDS, check=False)


class Series(VibrationTest):
    def setUp(self):
        super().setUp()
        self.run_well("transient", BARBIERI, *MARCH, "-grid_y_half", 1.4, "-mesh_periods", 1.5,
                      "-output_snapshot_interval", 0.15, "-output_dir", "march")
        self.output = self.folder / "march"

    def snapshots(self):
        """Per snapshot the time and, by block, the fields of its contacts as h5 has them."""
        with h5py.File(self.output / "results.h5") as results:
            moments = list(results["snapshots"].values())
            most = max(len(moment) for moment in moments)
            return [(moment.attrs["t"], {f"pair{int(name.removeprefix('contact')) % most}": (group["P"][...],
                                                                                             group["H"][...])
                                         for name, group in moment.items()}) for moment in moments]

    def test_blocks_have_the_same_names_at_all_times(self):
        root = xml.etree.ElementTree.parse(self.output / "results.xmf").getroot()
        blocks = root.findall("./Domain/Grid")
        self.assertEqual([block.get("Name") for block in blocks], ["pair0", "pair1"])
        snapshots = self.snapshots()
        self.assertGreater(len(snapshots), 8)
        names = set()
        for block in blocks:
            moments = block.findall("Grid")
            self.assertEqual(len(moments), len(snapshots))
            for moment, (time, present) in zip(moments, snapshots):
                names.add(moment.get("Name"))
                self.assertAlmostEqual(float(moment.find("Time").get("Value")), time - snapshots[0][0], places=12)
                here = moment.find("Topology").get("Dimensions") != "2 2"
                self.assertEqual(here, block.get("Name") in present)
        self.assertEqual(len(names), 2 * len(snapshots))    # readers rename those that are not unique

    @unittest.skipIf(vtkXdmfReader is None, "no VTK with an XDMF reader for Python (python3-paraview)")
    def test_vtk_reads_film_and_pressure_of_one_block_at_every_time(self):
        reader = vtkXdmfReader()
        reader.SetFileName(str(self.output / "results.xmf"))
        reader.UpdateInformation()
        times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
        snapshots = self.snapshots()
        self.assertEqual(len(times), len(snapshots))
        for time, (stored, blocks) in zip(times, snapshots):
            self.assertAlmostEqual(time, stored - snapshots[0][0], places=12)
            reader.UpdateTimeStep(time)
            contacts = reader.GetOutputDataObject(0)
            self.assertEqual(contacts.GetNumberOfBlocks(), 2)
            for number in range(2):
                name = contacts.GetMetaData(number).Get(vtkCompositeDataSet.NAME())
                self.assertEqual(name, f"pair{number}")
                data = contacts.GetBlock(number).GetPointData()
                fields = [vtk_to_numpy(data.GetArray(field)) for field in ("P", "H")]
                expected = blocks.get(name, (numpy.zeros(4), numpy.zeros(4)))
                for seen, field in zip(fields, expected):
                    numpy.testing.assert_array_equal(seen, field.ravel())

    @unittest.skipUnless(shutil.which("pvpython") and shutil.which("xvfb-run"), "no ParaView, or nothing to draw on")
    def test_paraview_draws_and_loads_the_state(self):
        sphere = self.folder / "sphere.py"
        sphere.write_text("from paraview import simple\nsimple.Show(simple.Sphere())\n"
                          f"simple.SaveScreenshot({str(self.folder / 'sphere.png')!r})\n", encoding="utf-8")
        if pvpython(sphere).returncode or not (self.folder / "sphere.png").exists():
            self.skipTest("ParaView cannot draw on this machine")
        done = pvpython(SOURCE / "scripts/examples/paraview_film.py", self.output)
        self.assertEqual(done.returncode, 0, done)
        self.assertTrue((self.output / "film_view.png").read_bytes().startswith(b"\x89PNG"))
        again = self.folder / "again.py"
        again.write_text("from paraview import simple\n"
                         f"simple.LoadState({str(self.output / 'film.pvsm')!r})\n"
                         f"simple.SaveScreenshot({str(self.folder / 'again.png')!r}, simple.GetActiveView())\n",
                         encoding="utf-8")
        done = pvpython(again)
        self.assertEqual(done.returncode, 0, done)
        first, second = (numpy.asarray(Image.open(path).convert("RGB").resize((300, 200)))
                         for path in (self.output / "film_view.png", self.folder / "again.png"))
        for picture in (first, second):
            self.assertGreater((picture.min(axis=2) < 200).mean(), 0.05)     # more than a white page


if __name__ == "__main__":
    unittest.main()
