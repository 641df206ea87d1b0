"""The folder of a run: summary, parameters, tables and films, with their units."""
import dataclasses
import importlib
import json
import pathlib

import h5py
import numpy

FORMAT = 1                      # results_format of src/output/format_version.hpp


class ResultsError(Exception):
    """What keeps results from being read; the text is for the user."""


@dataclasses.dataclass(frozen=True)
class Parameter:
    """A parameter as the program used it."""
    value: object               # float where it is a number, else text
    unit: str


@dataclasses.dataclass
class Film:
    """Film and pressure of one contact at one time; fields are [x, y]."""
    contact: int
    xi: float                   # of the contact, from the pitch point [mm]
    time: float                 # [s]; nan at rest
    x: numpy.ndarray            # in the direction of rolling [mm]
    y: numpy.ndarray            # along the face [mm]
    thickness: numpy.ndarray    # [um]
    pressure: numpy.ndarray     # [GPa]

    def dataset(self):
        """The film as an xarray.Dataset with named dimensions."""
        xarray = _optional("xarray")
        fields = {"thickness": (("x", "y"), self.thickness, {"units": "um"}),
                  "pressure": (("x", "y"), self.pressure, {"units": "GPa"})}
        axes = {"x": ("x", self.x, {"units": "mm"}), "y": ("y", self.y, {"units": "mm"})}
        return xarray.Dataset(fields, axes, {"contact": self.contact, "xi_mm": self.xi, "t": self.time})


def _optional(package):
    """A package that only some results need."""
    try:
        return importlib.import_module(package)
    except ImportError:
        raise ResultsError(f"this needs the Python package {package}, which is not installed: pip install {package}, "
                           f"or apt-get install python3-{package}") from None


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def _is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def _parameter(text):
    word, _, unit = text.partition(" ")
    # A list of numbers is text: no unit is a number.
    if _is_number(word) and not any(map(_is_number, unit.split())):
        return Parameter(float(word), unit)
    return Parameter(text, "")


def _place_of(contact):
    """Place of a contact on the line of action, from its group [mm]."""
    return 1e3 * float(contact.attrs.get("xi", 0.0))


class RunFolder:
    """Read when asked for: a folder of a run that still goes on shows what is written so far."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self._results = self.folder / "results.h5"
        if not self._results.exists() and not (self.folder / "summary.json").exists():
            raise ResultsError(f"{self.folder} holds no results of gearfilm; give the -output_dir of a run")

    def __repr__(self):
        return f"RunFolder({str(self.folder)!r}: {self.command})"

    def _open(self):
        try:
            results = h5py.File(self._results)
        except OSError as error:
            raise ResultsError(f"{self._results} cannot be read: {error}") from None
        version = results.attrs.get("format_version")
        if version != FORMAT:
            results.close()
            raise ResultsError(f"{self._results} has format version {version}, this package reads {FORMAT}; "
                               "use the package of the gearfilm that wrote it")
        return results

    @property
    def summary(self):
        """The main results, SI, as a dictionary; empty while there is none."""
        path = self.folder / "summary.json"
        if not path.exists():
            return {}
        try:
            return json.loads(path.read_text(encoding="utf-8"))
        except ValueError:
            raise ResultsError(f"{path} is no JSON; run the command again") from None

    @property
    def attributes(self):
        """Program, version, libraries, command."""
        if not self._results.exists():
            return dict(self.summary.get("provenance", {}))
        with self._open() as results:
            return {name: _text(value) for name, value in results.attrs.items()}

    @property
    def command(self):
        """The command that made the results; "info" and the like leave no more than a summary."""
        return self.attributes.get("command", "unknown")

    @property
    def parameters(self):
        """Every parameter by name."""
        if not self._results.exists():
            return {}
        with self._open() as results:
            return {name: _parameter(_text(value)) for name, value in results["parameters"].attrs.items()}

    def tables(self):
        """The names of all tables."""
        if not self._results.exists():
            return []
        found = []

        def visit(name, item):
            if isinstance(item, h5py.Dataset) and item.dtype.names:
                found.append(name)

        with self._open() as results:
            results.visititems(visit)
        return sorted(found)

    def table(self, name):
        """A table as a structured array; SI."""
        with self._open() as results:
            if name not in results:
                raise ResultsError(f"{self._results} has no table '{name}'; it has {', '.join(self.tables()) or 'none'}")
            return results[name][...]

    def units(self, name):
        """The unit of every column of a table."""
        with self._open() as results:
            lines = _text(results[name].attrs["units"]).splitlines()
        return dict(line.partition(" ")[::2] for line in lines)

    def frame(self, name):
        """A table as a pandas.DataFrame, with its units in `attrs`."""
        pandas = _optional("pandas")
        frame = pandas.DataFrame(self.table(name))
        frame.attrs["units"] = self.units(name)
        return frame

    @property
    def history(self):
        """The tables of a march, by their names without "history/": steps, contacts, poincare and others."""
        return {name.removeprefix("history/"): self.table(name) for name in self.tables() if name.startswith("history/")}

    def forces(self):
        """Position on the line of action from the pitch point [mm] and force [N] of every contact, by its number."""
        rows = self.table("history/contacts")
        return {int(number): (1e3 * rows["xi"][rows["contact"] == number], rows["force"][rows["contact"] == number])
                for number in numpy.unique(rows["contact"])}

    @property
    def thickness_scale(self):
        """a^2/R_x of the reference contact [m]: of H_0 to h_0."""
        steps = self.table("history/steps")
        largest = numpy.argmax(abs(steps["H0"]))
        return steps["h0"][largest] / steps["H0"][largest]

    def transmission_error(self):
        """Time [s] and transmission error [um] along the line of action: by how much the gears have approached."""
        steps = self.table("history/steps")
        return steps["t"], 1e6 * steps["transmission_error"]

    def films(self):
        """All stored films: one of a steady run, or the contacts of all snapshots."""
        with self._open() as results:
            return [self._film(results, *place) for place in self._stored(results)]

    def stores_films(self):
        """Whether there is any film; nothing of them is read."""
        if not self._results.exists():
            return False
        with self._open() as results:
            return any(True for _ in self._stored(results))

    def damage_figures(self):
        """Kinds and options of the figures of stresses, fatigue and ratings that there is something for."""
        if not self._results.exists():
            return []
        with self._open() as results:
            found = [("damage", {})] if "contact0/section" in results or "dang_van" in results.get("flank/pinion", ()) else []
            if "section" in results:
                found.append(("damage", {"section": True}))
            names = results["history/contacts"].dtype.names if "history/contacts" in results else ()
            if {"sigma_H", "von_mises_max_pinion"} & set(names):
                found.append(("damage", {"path": True}))
                if "flank/pinion" in results and results["flank/pinion/y"].size > 1:
                    found.append(("face", {}))
        return found

    def moves_train(self):
        """Whether there are loads of a drive train in motion."""
        return "history/train" in self.tables()

    def film(self, xi=0.0):
        """The stored film nearest to a place on the line of action [mm]; the others are not read."""
        with self._open() as results:
            nearest = min(self._stored(results), key=lambda place: abs(_place_of(place[1]) - xi), default=None)
            if nearest is None:
                raise ResultsError(f"{self._results} stores no films; run with -output_snapshot_interval")
            return self._film(results, *nearest)

    def fields(self):
        """Films and pressures of all stored films that share a grid, as one xarray.Dataset over (film, x, y) with the
        number of the contact, its place xi and the time as coordinates of `film`."""
        films = self.films()
        if not films:
            raise ResultsError(f"{self._results} stores no films; run with -output_snapshot_interval")
        xarray, first = _optional("xarray"), films[0]
        if any(not (numpy.array_equal(film.x, first.x) and numpy.array_equal(film.y, first.y)) for film in films):
            raise ResultsError(f"{self._results} has films on several grids; take them from films()")

        def stacked(name, unit):
            return ("film", "x", "y"), numpy.stack([getattr(film, name) for film in films]), {"units": unit}

        def each(name, unit):
            return "film", [getattr(film, name) for film in films], {"units": unit}

        return xarray.Dataset({"thickness": stacked("thickness", "um"), "pressure": stacked("pressure", "GPa")},
                              {"x": ("x", first.x, {"units": "mm"}), "y": ("y", first.y, {"units": "mm"}),
                               "xi": each("xi", "mm"), "time": each("time", "s"), "contact": each("contact", "-")})

    def draw(self, kind=None, **options):
        """A matplotlib Figure: the usual one of the command, or another of gearfilm.drawing.KINDS."""
        drawing = importlib.import_module(".drawing", __package__)
        usual = drawing.usual_kinds(self.command)
        if kind is None and not usual:
            raise ResultsError(f"{self.folder}: the results of gearfilm {self.command} have no figure")
        return drawing.draw(self.folder, kind or usual[0], **options)

    @staticmethod
    def _stored(results):
        """Name and group of the contact, time and group of the mesh of every stored film."""
        if "snapshots" not in results:
            yield from ((name, group, float("nan"), None) for name, group in results.items() if name.startswith("contact"))
            return
        for moment in results["snapshots"].values():
            time, mesh = float(moment.attrs["t"]), _text(moment.attrs["mesh"])
            yield from ((name, group, time, mesh) for name, group in moment.items())

    @staticmethod
    def _film(results, name, group, time, mesh):
        place = group if mesh is None else results[mesh]
        thickness, pressure = (group[field] for field in ("H", "P"))
        scale = {"m": 1e6, "Pa": 1e-9}
        return Film(int(name.removeprefix("contact")), _place_of(group), time,
                    1e3 * place["x"][...], 1e3 * place["y"][...],
                    scale[_text(thickness.attrs["unit"])] * thickness[...],
                    scale[_text(pressure.attrs["unit"])] * pressure[...])
