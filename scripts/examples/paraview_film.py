#!/usr/bin/env pvpython
"""ParaView's view of a run: the pressures of the contacts in mesh side by side, as surfaces coloured by film, in time.

    pvpython scripts/examples/paraview_film.py FOLDER

writes FOLDER/film.pvsm, a state for ParaView's File, Load State, and FOLDER/film_view.png, its picture at the time of
the largest pressure.

Reads FOLDER/results.xmf of `gearfilm steady`, or of `transient` and `periodic` with snapshots; pvpython is ParaView's
own Python. A machine without a screen needs "xvfb-run -a" before it. Exit status 1, with one line, where there is
nothing to show.
"""
import argparse
import pathlib
import sys

try:
    from paraview import servermanager, simple
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
except ImportError as missing:
    sys.exit(f"paraview_film: {missing}; run it with pvpython, which comes with ParaView")

HEIGHT = 0.6        # of the domain's length, that the largest pressure is drawn with
THICKEST = 2.0      # times the film under the largest pressure, up to which films are told apart
GAP = 0.1           # of the domain's width, between two contacts


def blocks_of(data):
    """Name and grid of every contact; the name of a film alone is empty."""
    if not data.IsA("vtkMultiBlockDataSet"):
        return {"": data}
    return {data.GetMetaData(n).Get(vtkCompositeDataSet.NAME()): data.GetBlock(n)
            for n in range(data.GetNumberOfBlocks())}


def values(block, name):
    array = block.GetPointData().GetArray(name) if block is not None else None
    return None if array is None or not array.GetNumberOfTuples() else vtk_to_numpy(array)


def survey(reader):
    """Over all times: the largest pressure, when it is, the film under it, the names of the contacts."""
    largest, when, film, names = 0.0, 0.0, 0.0, set()
    for time in list(reader.TimestepValues) or [0.0]:
        reader.UpdatePipeline(time)
        for name, block in blocks_of(servermanager.Fetch(reader)).items():
            pressure, thickness = values(block, "P"), values(block, "H")
            if pressure is None:
                continue
            names.add(name)
            if pressure.max() > largest:
                largest, when, film = float(pressure.max()), time, float(thickness[pressure.argmax()])
    return largest, when, film, sorted(names)


def show(reader, view, name, beside, film, largest):
    """One contact, moved aside by so many metres along the face; returns what is seen and its colours."""
    source = simple.ExtractBlock(Input=reader, Selectors=[f"/Root/{name}"]) if name else reader
    x_min, x_max = reader.GetDataInformation().GetBounds()[:2]
    surface = simple.WarpByScalar(Input=source, Scalars=["POINTS", "P"], ScaleFactor=HEIGHT * (x_max - x_min) / largest)
    place = simple.Transform(Input=surface)
    place.Transform.Translate = [0.0, beside, 0.0]
    shown = simple.Show(place, view)
    simple.ColorBy(shown, ("POINTS", "H"))
    simple.RenameSource(name or "contact", place)
    colours = simple.GetColorTransferFunction("H")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(0.0, THICKEST * film)
    return shown, colours


def make(folder):
    path = folder / "results.xmf"
    if not path.exists():
        sys.exit(f"paraview_film: {path} does not exist; run with -output_snapshot_interval, or gearfilm steady")
    reader = simple.XDMFReader(registrationName="films", FileNames=[str(path.resolve())])
    largest, when, film, names = survey(reader)
    if not names:
        sys.exit(f"paraview_film: {path} has no film under pressure")
    view = simple.CreateView("RenderView")
    view.ViewSize = [1200, 800]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    y_min, y_max = reader.GetDataInformation().GetBounds()[2:4]
    for n, name in enumerate(names):
        shown, colours = show(reader, view, name, n * (1 + GAP) * (y_max - y_min), film, largest)
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "h [m]", ""
    bar.WindowLocation = "Upper Right Corner"
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    shown.SetScalarBarVisibility(view, True)
    if len(reader.TimestepValues) > 1:
        label = simple.Show(simple.AnnotateTimeFilter(Input=reader, Format="t = {time:.3e} s"), view)
        label.Color = [0.0, 0.0, 0.0]
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        simple.GetAnimationScene().AnimationTime = when
    view.ViewTime = when
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraPosition = [-0.9, -0.35, 0.8]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Dolly(1.5)
    simple.SaveScreenshot(str(folder / "film_view.png"), view)
    simple.SaveState(str(folder / "film.pvsm"))
    for name in ("film.pvsm", "film_view.png"):
        print(f"paraview: {folder / name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder with results.xmf")
    make(parser.parse_args().folder)


if __name__ == "__main__":
    main()
