"""What the program takes for parameters that are not given, and a case file that holds all others of a run.

The table is made from `gearfilm parameters`; it has no parameters without a default.
"""
import json
import re

TABLE = """
case.kind = gear_pair
pinion.tip_relief = 0
pinion.tip_relief_shape = parabolic
pinion.root_relief = 0
pinion.root_relief_shape = parabolic
pinion.profile_slope = 0
pinion.profile_crowning = 0
pinion.end_relief = 0
pinion.end_relief_shape = circular
pinion.lead_slope = 0
pinion.conductivity = 47
pinion.density = 7850
pinion.heat_capacity = 460
pinion.lay = 1
pinion.residual_stress = none
wheel.tip_relief = 0
wheel.tip_relief_shape = parabolic
wheel.root_relief = 0
wheel.root_relief_shape = parabolic
wheel.profile_slope = 0
wheel.profile_crowning = 0
wheel.end_relief = 0
wheel.end_relief_shape = circular
wheel.lead_slope = 0
wheel.conductivity = 47
wheel.density = 7850
wheel.heat_capacity = 460
wheel.lay = 1
wheel.residual_stress = none
gear.end_face = free
gear.end_face_factor = 1.39
gear.misalignment = 0
gear.load_model = point
gear.tooth_compliance = none
gear.compliance_factor = 1
gear.mesh_compliance = 0
gear.profile_local = offset
gear.body_coupling = yes
motor.fixed = no
contact.sliding_velocity = 0
contact.conductivity_1 = 47
contact.density_1 = 7850
contact.heat_capacity_1 = 460
contact.conductivity_2 = 47
contact.density_2 = 7850
contact.heat_capacity_2 = 460
contact.lay = 1
contact.end_relief = 0
contact.end_relief_shape = circular
contact.misalignment = 0
contact.logarithmic_profile = 0
contact.end_face = free
contact.end_face_factor = 1.39
roughness.model = none
roughness.asperity_law = zhao_maietta_chang
roughness.asperity_density_product = 0.05
roughness.asperity_slope = 0.01
roughness.hardness = 7e9
roughness.summit_shift = yes
roughness.exponential_gap = 0.48
roughness.mean_gap = gaussian
roughness.direction = transverse
roughness.phase_1 = 0
roughness.phase_2 = 0
wear.largest_step = 0.1
wear.points = 201
lubricant.viscosity_law = roelands
lubricant.density_law = dowson_higginson
lubricant.tait_beta_k = 0
lubricant.tait_expansion = 0
lubricant.doolittle_expansion = 0
lubricant.conductivity = 0.137
lubricant.conductivity_pressure_1 = 1.72e-9
lubricant.conductivity_pressure_2 = 5.4e-10
lubricant.density = 870
lubricant.heat_capacity = 2000
lubricant.expansion = 0
friction.law = none
friction.eyring_stress = 8e6
friction.carreau_modulus = 8e6
friction.carreau_exponent = 0.6
friction.limiting_ratio = 0.045
friction.limiting_stress = 5e6
friction.boundary_coefficient = 0.11
friction.in_film = no
friction.in_motion = no
thermal.model = none
thermal.temperature = 363.15
thermal.points = 17
stress.model = none
stress.rows = most_loaded
stress.depth_max = 2
stress.points = 24
stress.every = 0.05
fatigue.criterion = none
fatigue.alpha = 0.3
fatigue.compression = yes
fatigue.shear_per_hardness = 4e5
fatigue.flank_points = 101
fatigue.margin = 1
fatigue.stress_exponent = 10.333333333333334
fatigue.depth_exponent = 2.3333333333333335
fatigue.weibull_slope = 1.1111111111111112
fatigue.threshold = 0
rating.cycles = 1e9
grid.domain = auto
grid.accuracy = 0.02
grid.whole_face = auto
grid.row_growth = 1.35
film.discretisation = fitted
steady.position = 0
steady.load_ratio = 1
static.load_ratios = 0.25, 0.5, 0.75, 1, 1.25
static.positions = 400
model = dynamic
motion = dynamic
geometry = moving
mesh_periods = 2
ramp.inertia_torque = no
restart = no
keep_checkpoint = no
load_sharing.kind = step
load_sharing.at_end = 0.3333333333333333
load_sharing.at_inner_edge = 0.6666666666666666
load_sharing.jump_time = 0.025
load_sharing.jump_refinement = 10
start.place = pitch
time.newton_max_iterations = 30
time.krylov_max_iterations = 60
time.levels = 0
periodic.tolerance = 1e-4
periodic.film_tolerance = 0.001
periodic.max_periods = 40
periodic.order = 1
periodic.max_pattern = 1
periodic.multipliers = yes
eigen.modes = 4
eigen.orbit = no
eigen.periods = 5
sweep.over = speed
sweep.points = 31
sweep.direction = both
sweep.chain_points = 0
sweep.groups = 0
sweep.kind = periodic
sweep.march_periods = 200
sweep.kept_periods = 16
sweep.starts = 21
continuation.parameter = speed
continuation.points = 5000
continuation.follow_flips = yes
continuation.largest_order = 2
solver.processes = useful
solver.newton_tolerance = 1e-8
solver.newton_max_iterations = 60
solver.krylov_tolerance = 0.01
solver.krylov_max_iterations = 200
solver.levels = 0
solver.smoothing_sweeps = 1
solver.coarse_sweeps = 4
solver.precision = single
"""
KNOWN = dict(line.split(" = ", 1) for line in TABLE.strip().splitlines())
OF_THE_RUN = {"output.dir", "restart"}      # say nothing about the pair
PLAIN = re.compile(r"[A-Za-z_][\w.-]*")     # of words that YAML needs no quotes for


def same(text, other):
    """Whether two values are written differently at most."""
    try:
        return float(text) == float(other)
    except ValueError:
        return text == other


def in_digits(value):
    """A value as a case file has it, to the last bit."""
    if not isinstance(value, float):
        return str(value)
    return repr(value).removesuffix(".0").replace("e+", "e")


def given(parameters):
    """Name and text of the parameters of a run that are not as they would be without being given."""
    for name, parameter in parameters.items():
        text = in_digits(parameter.value)
        if name not in OF_THE_RUN and not (name in KNOWN and same(text, KNOWN[name])):
            yield name, text if isinstance(parameter.value, float) or PLAIN.fullmatch(text) else json.dumps(text)


def case_file(parameters):
    """Text of a case file with what was given: sections, and keys without one at the end."""
    sections = {}
    for name, text in given(parameters):
        section, _, key = name.rpartition(".")
        sections.setdefault(section, []).append(f"{'  ' if section else ''}{key}: {text}")
    lines = [line for section in sorted(sections, key=lambda name: (not name, name != "case"))
             for line in ([f"{section}:"] if section else []) + sections[section]]
    return "\n".join(lines) + "\n"
