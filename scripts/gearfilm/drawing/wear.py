"""Figure of worn flanks: the depth that they have lost, along the middle of the face and over the whole of it."""
import numpy
from matplotlib import pyplot

from .canvas import BLUE, GREEN, Foreign, add_grid, add_legend, open_results, read_table

GEARS = (("pinion", BLUE), ("wheel", GREEN))


def depths_of(results, gear):
    """Roll angles [deg], places across the face [mm] and depths [um], [along, across]."""
    rows = read_table(results, f"wear/{gear}", {"roll_angle", "y", "depth"})
    angles, places = numpy.unique(rows["roll_angle"]), numpy.unique(rows["y"])
    return numpy.degrees(angles), 1e3 * places, 1e6 * rows["depth"].reshape(len(angles), len(places))


def draw(flanks):
    figure, axes = pyplot.subplots(2, 2, figsize=(8, 5.4), constrained_layout=True)
    for panel, image, (gear, colour), (angles, places, depths) in zip(axes[0], axes[1], GEARS, flanks):
        panel.plot(angles, depths[:, numpy.argmin(abs(places))], color=colour, linewidth=1.4, label=gear)
        panel.set_ylim(bottom=0)
        panel.set_ylabel("depth in the middle [µm]")
        add_legend(panel, *panel.get_legend_handles_labels())
        add_grid(panel)
        shown = image.pcolormesh(angles, places, depths.T, shading="nearest", cmap="viridis")
        figure.colorbar(shown, ax=image, label="depth [µm]")
        image.set_xlabel("roll angle [deg]")
        image.set_ylabel("across the face [mm]")
    return figure


def draw_folder(folder):
    """Draws `gearfilm wear`."""
    lack = "it has no worn flanks; run gearfilm wear"
    with open_results(folder / "results.h5", "wear", lack) as results:
        if "wear" not in results:
            raise Foreign(lack)
        return draw([depths_of(results, gear) for gear, _ in GEARS])
