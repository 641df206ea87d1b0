"""Stationary films against the reference rows of tests/reference/table3.json."""
import json

from program import INPUT, SOURCE, ProgramTest

REFERENCE = json.loads((SOURCE / "tests/reference/table3.json").read_text(encoding="utf-8"))
BARBIERI = INPUT / "barbieri2013.yaml"
WANG = INPUT / "wang2004.yaml"
CIRCULAR = INPUT / "circular_m20_l10.yaml"
# Newton stops at a root mean square of 1e-8, of which the relative error of the load is a part.
BALANCE = 1e-6
# Films of 1, 2 and 4 processes differ by 5e-12 where all take the same path of Newton steps, and by what Newton's
# tolerance of 1e-8 leaves where the sequence of grids, which depends on the number of processes, makes them differ.
SAME = 1e-6


def summary_in(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def grid_options(row):
    """Of a row of the reference, whose films are of the paper's discretisation."""
    options = ["-grid_nx", row["nx"], "-grid_ny", row["ny"], "-film_discretisation", "central"]
    if "domain" in row:
        for name, value in zip(("x_min", "x_max", "y_half"), row["domain"]):
            options += [f"-grid_{name}", value]
    return options


class FilmTest(ProgramTest):
    def assert_row(self, case, row, processes=1, load=None):
        """A stationary film agrees with one row of the reference, and carries its load."""
        self.run_well("steady", case, "-output_dir", "row", *grid_options(row), processes=processes)
        summary = summary_in(self.folder / "row")
        for name in ("h_central", "h_min", "H_central", "H_min", "H0"):
            if name in row:
                self.assertAlmostEqual(summary[name] / row[name], 1, delta=row["rel_tol"], msg=f"{name} of {row}")
        if load is None:
            self.run_well("info", case, "-output_dir", "info", *grid_options(row))
            load = summary_in(self.folder / "info")["load"]
        self.assertAlmostEqual(summary["force"] / load, 1, delta=BALANCE)
        return summary
