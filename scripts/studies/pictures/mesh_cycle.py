"""Animation of the mesh cycle: the gears turn, films and pressures of their contacts beside them."""
from studies.common.plotting import BLUE, DARK, GREEN, PURPLE, VERMILLION, add_grid, numpy, pyplot
from studies.common.sketching import LARGE, SMALL, arrow, bare_axes, label, new_figure
from studies.pictures.film_map import LEVELS, THICK, film_colours
from studies.pictures.gears_in_mesh import draw_gears_in_mesh

# After plotting, which says what is missing.
from matplotlib.cm import ScalarMappable
from matplotlib.collections import Collection
from matplotlib.colors import BoundaryNorm
from PIL import Image

HEIGHT = 5.2        # inches
DELAY = 50          # ms, of a frame
CYCLES = 2          # until a contact of the same name comes again
NAMES, TONES = "AB", (GREEN, PURPLE)
FILM_TOP, PRESSURE_TOP = 5.0, 3.6      # of sections [µm, GPa]
NEARLY_WHITE = 242
UNCHANGED = 255     # the colour of a frame that stands for the pixel of the frame before


class MeshCycle:
    """The panels, and what changes in them from frame to frame."""

    def __init__(self, pair):
        self.pair = pair
        self.frames = len(pair.moments)
        self.figure = new_figure(HEIGHT)
        self._add_gears()
        self._add_forces()
        self._add_maps()
        self._add_sections()

    def _add_gears(self):
        axes = bare_axes(self.figure, [0.005, 0.395, 0.46, 0.535])
        self.drawn = draw_gears_in_mesh(axes, self.pair.gears, (0.3, 0), (10.2, 7.7))
        self.spots = [axes.plot([], [], marker="o", markersize=10, color=tone, markeredgecolor="white", zorder=6)[0]
                      for tone in TONES]
        label(axes, (0.5, 1), "gears in mesh", (0, 9), xycoords="axes fraction", fontsize=LARGE)
        for text, tone, height in (("wheel", VERMILLION, 0.96),
                                   (f"pinion, {self.pair.speed_rpm:.0f} rpm", BLUE, 0.04)):
            label(axes, (0, height), text, (6, 0), xycoords="axes fraction", ha="left")
            arrow(axes, (0.39, height), (0.5, height), xycoords="axes fraction", color=tone, linewidth=2)
        label(axes, self.pair.gears.at(self.pair.gears.exit + 3), "line of action", (-16, 7), ha="center")

    def _add_forces(self):
        axes = self.figure.add_axes([0.075, 0.105, 0.385, 0.225])
        for _, position, force in self.pair.force.values():
            axes.plot(position, force, color=DARK, linewidth=1.2)
        self.dots = [axes.plot([], [], marker="o", markersize=9, color=tone, markeredgecolor="white", zorder=6)[0]
                     for tone in TONES]
        axes.set_xlim(self.pair.gears.entry - 0.4, self.pair.gears.exit + 0.4)
        axes.set_ylim(0, None)
        axes.set_xlabel("position on the line of action [mm]", fontsize=SMALL)
        axes.set_title("force on a tooth [kN]", fontsize=SMALL, loc="left", pad=4)
        self._finish(axes)

    def _add_maps(self):
        self.maps, self.map_titles = [], []
        x, y = self.pair.moments[0][0].x, self.pair.moments[0][0].y
        for n, name in enumerate(NAMES):
            axes = self.figure.add_axes([0.555, 0.74 - 0.19 * n, 0.355, 0.135])
            axes.set_xlim(y[0], y[-1])
            axes.set_ylim(x[0], x[-1])
            axes.set_ylabel("x [mm]", fontsize=SMALL)
            axes.tick_params(labelsize=SMALL, labelbottom=n == 1)
            axes.set_yticks([-1, -0.5, 0, 0.5], ["-1", "", "0", ""])
            axes.plot(0.012, 1.13, marker="o", markersize=8, color=TONES[n], transform=axes.transAxes, clip_on=False)
            self.map_titles.append(label(axes, (0, 1.13), "", (14, 0), xycoords="axes fraction", ha="left"))
            self.maps.append([axes, None])
        self.maps[-1][0].set_xlabel("y, along the tooth [mm]", fontsize=SMALL, labelpad=1)
        bar = self.figure.add_axes([0.925, 0.55, 0.015, 0.325])
        shades = self.figure.colorbar(ScalarMappable(BoundaryNorm(LEVELS, 256, extend="both"), film_colours()),
                                      bar, ticks=LEVELS[::2])
        shades.ax.tick_params(labelsize=SMALL)
        self.figure.text(0.75, 0.957, "oil film of each contact [µm]", fontsize=LARGE, color=DARK, ha="center",
                         va="center")

    def _add_sections(self):
        self.curves = {}
        reach = self.pair.moments[0][0].x[[0, -1]]
        for n, (name, title, top) in enumerate((("pressure", "pressure [GPa]", PRESSURE_TOP),
                                                ("thickness", "film [µm]", FILM_TOP))):
            axes = self.figure.add_axes([0.555 + 0.235 * n, 0.105, 0.175, 0.285])
            self.curves[name] = [axes.plot([], [], color=tone, linewidth=width, linestyle=style)[0]
                                 for tone, width, style in zip(TONES, (2, 1.7), ("-", (0, (5, 1))))]
            axes.set_xlim(*reach)
            axes.set_ylim(0, top)
            axes.set_xticks([-1, -0.5, 0, 0.5], ["-1", "", "0", ""])
            axes.set_xlabel("x, direction of rolling [mm]", fontsize=SMALL)
            axes.set_title(title, fontsize=SMALL, loc="left", pad=4)
            self._finish(axes)

    @staticmethod
    def _finish(axes):
        axes.tick_params(labelsize=SMALL)
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
        add_grid(axes)

    def show(self, number):
        """One frame; the contact that leads in the first cycle is A, the one that enters then is B."""
        cycle, moment = divmod(number, self.frames)
        films = self.pair.moments[moment]
        self.drawn.turn(films[0].xi)
        for n in range(len(NAMES)):
            follows = (n + cycle) % 2
            self._show_contact(n, films[follows] if follows < len(films) else None, follows)

    def _show_contact(self, n, film, follows):
        for artist in (self.spots[n], self.dots[n], *(curves[n] for curves in self.curves.values())):
            artist.set_visible(film is not None)
        axes, filled = self.maps[n]
        axes.set_facecolor(THICK if film else "white")
        if filled is not None:
            for part in [filled] if isinstance(filled, Collection) else filled.collections:
                part.remove()
        self.maps[n][1] = None
        self.map_titles[n].set_text(f"contact {NAMES[n]}" + ("" if film else ": not in mesh"))
        if film is None:
            return
        self.maps[n][1] = axes.contourf(film.y, film.x, film.thickness, LEVELS, cmap=film_colours(), extend="both")
        self.spots[n].set_data(*self.pair.gears.at(film.xi)[:, None])
        _, position, force = self.pair.force[follows]
        self.dots[n].set_data([film.xi], [numpy.interp(film.xi, position, force)])
        middle = abs(film.y).argmin()
        for name, curves in self.curves.items():
            curves[n].set_data(film.x, getattr(film, name)[:, middle])

    def image(self, number):
        """One frame as a picture."""
        self.show(number)
        self.figure.canvas.draw()
        return Image.fromarray(numpy.asarray(self.figure.canvas.buffer_rgba())[..., :3])


def common_palette(images):
    """Of some frames together, so that no colour flickers; one place is left free, and white stays white."""
    width, height = images[0].size
    sheet = Image.new("RGB", (width, height * len(images)))
    for row, image in enumerate(images):
        sheet.paste(image, (0, height * row))
    palette = sheet.quantize(UNCHANGED - 1, kmeans=1)
    colours = numpy.array((palette.getpalette() + 768 * [0])[:768]).reshape(-1, 3)
    colours[(colours.min(axis=1) > NEARLY_WHITE) | (numpy.arange(256) == UNCHANGED - 1)] = 255
    palette.putpalette(colours.ravel().tolist())
    return palette


def differences(images):
    """Frames in the common palette, each of them with what has changed since the one before."""
    palette = common_palette(images[::len(images) // 8])
    frames, before = [], None
    for image in images:
        shown = numpy.asarray(image.quantize(palette=palette, dither=0))
        changed = shown if before is None else numpy.where(shown == before, UNCHANGED, shown).astype("uint8")
        frame = Image.fromarray(changed, "P")
        frame.putpalette(palette.getpalette())
        frames.append(frame)
        before = shown
    return frames


def write_mesh_cycle(pair, path):
    """A GIF that goes round without a jump."""
    cycle = MeshCycle(pair)
    images = [cycle.image(number) for number in range(CYCLES * cycle.frames)]
    pyplot.close(cycle.figure)
    first, *others = differences(images)
    first.save(path, save_all=True, append_images=others, duration=DELAY, loop=0, transparency=UNCHANGED, disposal=1,
               optimize=False)
