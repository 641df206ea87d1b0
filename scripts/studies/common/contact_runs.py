"""Runs on bare contacts, each made once, and the oils of contacts drawn at random."""
import json
import sys

from studies.common.contacts import case_text
from studies.common.oils import pressure_viscosity
from studies.common.pairs import logarithmic
from studies.common.runs import LAUNCHER, RunError, attempt

VISCOSITIES = (0.009, 0.075)   # Pa s
TIME_LIMIT = 120               # s of the processor, which other programs hardly change
LIMITED = ("sh", "-c", f'ulimit -t {TIME_LIMIT}; exec "$@"', "sh", *LAUNCHER)


class Solver:
    """Runs in a folder, each made once."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / "runs.json"
        self.known = json.loads(self.path.read_text(encoding="utf-8")) if self.path.exists() else {}

    def run(self, command, contact, *options):
        """Summary, None where not solved."""
        text = case_text(**contact)
        key = " ".join([command, *map(str, options), text])
        if key not in self.known:
            case = self.folder / "case.yaml"
            case.write_text(text, encoding="utf-8")
            run = attempt(command, case, self.folder, *options, launcher=LIMITED)
            if run.status == 1:
                raise RunError(run.message)
            if run.status != 0:
                print(f"not solved: {' '.join(map(str, options))}: {run.message}", file=sys.stderr)
            self.known[key] = run.summary if run.status == 0 else None
            self.path.write_text(json.dumps(self.known), encoding="utf-8")
        return self.known[key]


def oil(draw):
    viscosity = logarithmic(draw, *VISCOSITIES)
    return {"viscosity": viscosity, "pressure_viscosity": pressure_viscosity(viscosity)}
