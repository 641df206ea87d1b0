"""How data flow through the program, with the folders of src that hold each part."""
from studies.common.boxes import PLACE, Box, chart, draw_box, link, link_around, link_down
from studies.common.plotting import BLUE, GREY
from studies.common.sketching import NORMAL, label

from matplotlib.patches import FancyBboxPatch  # after plotting, which says what is missing

HEIGHT = 772
LIBRARIES_AT = 748
CALLERS = (14, 34)  # from, width

CASE = Box(160, 730, 160, 68, "input", "case file", "YAML,\nor options")
INPUT = Box(480, 730, 400, 68, "input", "CaseInput", "all parameters, checked, with defaults", "input")
MESH = Box(225, 614, 290, 84, "model", "mesh model", "teeth, contacts, oil,\nspeed, inertia, scales",
           "gear, lubricant, contact, mesh")
NUMERICS = Box(545, 614, 270, 84, "model", "numerics", "grid, transforms, tolerances,\nlength of time steps",
               "parallel, numerics, grid")
FILMS = Box(235, 465, 270, 84, "solve", "films of all contacts", "Reynolds, cavitation,\nelastic deformation",
            "film, elasticity")
BODIES = Box(550, 465, 220, 84, "solve", "body equations", "motion of the gears,\nteeth that bend",
             "solver, elasticity")
STEPS = Box(265, 333, 330, 84, "solve", "time steps",
            "TS (BDF2) → SNES (Newton)\n→ KSP (FGMRES) → PC (PCMG, a film)", "dynamics, solver, film")
HEAT = Box(570, 333, 180, 84, "solve", "heat and friction", "of a film, after\neach step", "traction")
MARCH = Box(265, 236, 330, 68, "solve", "march", "time integration; contacts enter and leave", "dynamics")
ORBITS = Box(265, 142, 330, 68, "solve", "periodic states, branches", "multipliers, modes, spectra", "orbits")
RESULTS = Box(265, 42, 330, 68, "result", "results", "JSON, HDF5, XDMF", "results, output")
PYTHON = Box(570, 42, 180, 68, "result", "Python package", "tables, figures", "scripts/gearfilm")
ALL = (CASE, INPUT, MESH, NUMERICS, FILMS, BODIES, STEPS, HEAT, MARCH, ORBITS, RESULTS, PYTHON)
LIBRARIES = ((INPUT, "yaml-cpp"), (NUMERICS, "PETSc DM\nMPI"), (BODIES, "FFTW\nEigen"), (HEAT, "PETSc"),
             (ORBITS, "SLEPc\nFFTW"), (PYTHON, "HDF5\nJSON"))


def draw_frame(axes, left, bottom, width, height):
    axes.add_patch(FancyBboxPatch((left, bottom), width, height, boxstyle="round,pad=0,rounding_size=6",
                                  facecolor="none", edgecolor=BLUE, linewidth=1.3, linestyle="--"))


def draw_film_system(axes):
    """A frame around films and bodies, and what they exchange."""
    draw_frame(axes, 80, 409, 600, 132)
    label(axes, (96, 527), "film system", fontsize=NORMAL, fontweight="bold", ha="left")
    label(axes, (192, 526), "solver", family="monospace", color=PLACE, ha="left")
    right, left = FILMS.side("e"), BODIES.side("w")
    for rise, begin, end, text in ((14, right, left, "forces"), (-14, left, right, "gaps")):
        link(axes, (begin[0], begin[1] + rise), (end[0], end[1] + rise))
        label(axes, (0.5 * (begin[0] + end[0]), begin[1] + rise + 10), text)


def draw_callers(axes):
    """Who calls all of this, beside it."""
    left, width = CALLERS
    axes.add_patch(FancyBboxPatch((left, 8), width, HEIGHT - 16, boxstyle="round,pad=0,rounding_size=6",
                                  facecolor="#F7F7F7", edgecolor=GREY, linewidth=1.3))
    middle = left + 0.5 * width
    for height, text, style in ((180, "commands", {"fontsize": NORMAL, "fontweight": "bold"}),
                                (272, "app, bench", {"family": "monospace", "color": PLACE}),
                                (455, "C++ library", {"fontsize": NORMAL, "fontweight": "bold"}),
                                (552, "interface", {"family": "monospace", "color": PLACE})):
        label(axes, (middle, height), text, rotation=90, **style)


def draw_data_flow():
    figure, axes = chart(HEIGHT)
    draw_callers(axes)
    draw_film_system(axes)
    for box in ALL:
        draw_box(axes, box)
    link(axes, CASE.side("e"), INPUT.side("w"))
    between = 0.5 * (INPUT.side("s")[1] + MESH.side("n")[1])
    for box in (MESH, NUMERICS):
        link(axes, INPUT.side("s"), (INPUT.x, between), (box.x, between), box.side("n"))
        link(axes, box.side("s"), (box.x, 541))
    link(axes, (STEPS.x, 409), STEPS.side("n"))
    link_down(axes, STEPS, MARCH, ORBITS, RESULTS)
    link(axes, STEPS.side("e", -0.2), HEAT.side("w", -0.2))
    link(axes, HEAT.side("n"), (HEAT.x, 409))
    label(axes, (HEAT.x, 0.5 * (HEAT.side("n")[1] + 409)), "flow factors", (-6, 0), ha="right")
    link_around(axes, ORBITS.side("w"), MARCH.side("w"), 76)
    label(axes, (84, 0.5 * (MARCH.y + ORBITS.y)), "next start", ha="left")
    link(axes, MARCH.side("e"), (462, MARCH.y), (462, 93), (400, 93), (400, RESULTS.side("n")[1]))
    label(axes, (470, 0.5 * (MARCH.y + ORBITS.y)), "history, films, checkpoints", ha="left")
    link(axes, RESULTS.side("e"), PYTHON.side("w"))
    label(axes, (LIBRARIES_AT, HEIGHT - 12), "libraries", fontweight="bold")
    for box, text in LIBRARIES:
        label(axes, (LIBRARIES_AT, box.y), text)
    axes.plot([LIBRARIES_AT - 46] * 2, [8, HEIGHT - 8], color=GREY, linewidth=0.8, linestyle=":")
    return figure
