"""Units and meanings of the quantities in summaries, and the units in which a page shows them."""
from typing import NamedTuple

# Name, unit in the summary, meaning. The first part is that of `gearfilm figures`.
TABLE = """
H0 | - | rigid displacement at the end
V0 | - | its velocity at the end
power_sliding | W | power lost by sliding, mean in time
power_rolling | W | power lost by rolling, mean in time
power_loss | W | power lost by sliding and rolling, mean in time
wall_time | s | time the steps took
p_max | Pa | largest pressure
h_min | m | smallest film thickness
film_temperature_max | K | largest temperature in the film
force_ratio_max | - | largest force on one contact over the static force
pitch_h_central | m | central film at the step nearest to the pitch point
entry_h_central | m | central film at the first step after a contact entered
pitch_h_min | m | smallest film at the step nearest to the pitch point
entry_h_min | m | smallest film at the first step after a contact entered
p_hertz_max | Pa | largest Hertz pressure under the present force
sliding_velocity_max | m/s | largest sliding velocity, of a contact behind the pitch point
sliding_velocity_min | m/s | smallest sliding velocity, negative where a contact is before the pitch point
lambda_min | - | smallest film over the roughness
surface_temperature_pinion_max | K | largest temperature of the pinion's flank
surface_temperature_wheel_max | K | largest temperature of the wheel's flank
temperatures_missed_max | - | largest part of a contact's loaded nodes where temperatures across the film did not settle
total_force_ratio_max | - | largest force on all contacts together over the static force
total_force_ratio_min | - | smallest force on all contacts together over the static force
back_force_ratio_max | - | largest force on reverse flanks over the static force
steps | - | time steps
contact_steps | - | time steps of contacts, each counted by itself
newton_iterations | - | iterations of Newton's method
krylov_iterations | - | iterations of the linear solver
t | s | the same
xi | m | position on the line of action, from the pitch point
force | N | force on the contact
p_central | Pa | pressure at x = y = 0
p_spike | Pa | height of the outlet's spike, where pressure rises once more behind its fall; zero where it does not
p_spike_max | Pa | largest height of the outlet's spike
h_central | m | film thickness at x = y = 0
p_hertz | Pa | Hertz pressure under the present force, zero without force
sliding_velocity | m/s | surface velocity of the pinion less that of the wheel
lambda | - | smallest film over the roughness of both flanks together
lambda_central | - | film at x = y = 0 over the roughness of both flanks together
lambda_smooth | - | central film of smooth flanks by formula over the roughness of both flanks together; zero without force
real_area_ratio | - | part of the surface on which asperities touch at x = y = 0
friction_force | N | force of sliding friction, with the sign of the sliding velocity
rolling_force | N | force of rolling friction on either flank
friction_coefficient | - | friction_force over the force on the contact
flash_temperature | K | largest rise of the surfaces if both were equally warm and took all heat of sliding
surface_temperature_pinion | K | largest temperature of the pinion's flank
surface_temperature_wheel | K | largest temperature of the wheel's flank
film_temperature_mean_max | K | largest temperature of the film, each place's mean across it
heat_pinion | W | heat from the film into the pinion
heat_wheel | W | heat from the film into the wheel
heat_oil | W | heat that the oil takes away
temperatures_missed | - | part of the loaded nodes where temperatures across the film did not settle
heat_balance | - | heat that is made in the film and goes nowhere, over all that is made
asperity_load_share | - | part of the force that asperities carry
asperity_force | N | force that asperities carry
wear_depth_pinion | m | wear of the pinion's flank by one passage of the contact, where it is largest
wear_depth_wheel | m | wear of the wheel's flank by one passage of the contact, where it is largest
wear_rate_pinion | m^3/s | volume that the pinion's flank loses by time
wear_rate_wheel | m^3/s | volume that the wheel's flank loses by time
mean_gap_central | m | mean gap of the rough surfaces at x = y = 0
mean_gap_min | m | smallest mean gap
p_fluid_max | Pa | largest pressure of the oil
p_asperity_max | Pa | largest pressure of the asperities
friction_coefficient_fluid | - | the oil's part of friction_coefficient
friction_coefficient_boundary | - | the asperities' part of friction_coefficient
friction_force_boundary | N | the asperities' part of friction_force
power_boundary | W | the asperities' part of power_sliding
asperity_load_share_max | - | largest part of a contact's force that asperities carry
asperity_load_share_mean | - | part of the force on all contacts together that asperities carry, mean in time
wear_depth_pinion_max | m | largest wear of the pinion's flank in one mesh
wear_depth_wheel_max | m | largest wear of the wheel's flank in one mesh
wear_rate_pinion_mean | m^3/s | volume that the pinion loses by time, mean
wear_rate_wheel_mean | m^3/s | volume that the wheel loses by time, mean
p_fluid | Pa | pressure of the oil
p_asperity | Pa | pressure of the asperities
von_mises_max_pinion | Pa | largest von Mises stress below the contact, in the row that carries most; in the pinion
von_mises_depth_pinion | m | its depth
shear_max_pinion | Pa | largest half difference of principal stresses there; in the pinion
shear_depth_pinion | m | its depth
orthogonal_shear_pinion | Pa | half the range of tau_xz along x, the largest over depth; in the pinion
orthogonal_shear_depth_pinion | m | its depth
surface_tension_pinion | Pa | largest principal stress at the pinion's surface; zero where none is tensile
von_mises_pinion | Pa | von Mises stress in the pinion at the depth where it is largest in its worst row
von_mises_max_wheel | Pa | largest von Mises stress below the contact, in the row that carries most; in the wheel
von_mises_depth_wheel | m | its depth
shear_max_wheel | Pa | largest half difference of principal stresses there; in the wheel
shear_depth_wheel | m | its depth
orthogonal_shear_wheel | Pa | half the range of tau_xz along x, the largest over depth; in the wheel
orthogonal_shear_depth_wheel | m | its depth
surface_tension_wheel | Pa | largest principal stress at the wheel's surface; zero where none is tensile
von_mises_wheel | Pa | von Mises stress in the wheel at the depth where it is largest in its worst row
dang_van_max_pinion | Pa | largest Dang Van stress below z = 0.05 a, off both ends of the flank
dang_van_s_pinion | m | where: along the flank from the base circle
dang_van_z_pinion | m | its depth
dang_van_y_pinion | m | its row
dang_van_surface_pinion | Pa | the same at the surface, which depends on the grid
safety_dang_van_pinion | - | least factor on the stresses of the load at which the limit is met; null without a limit
safety_dang_van_s_pinion | m | where: along the flank
safety_dang_van_z_pinion | m | its depth
safety_dang_van_y_pinion | m | its row
cycles_dang_van_pinion | - | 5e7 S_DV^13.22, the slope of ISO's life factor; null where S_DV is 1 or more: above 5e7
dang_van_max_wheel | Pa | largest Dang Van stress below z = 0.05 a, off both ends of the flank
dang_van_s_wheel | m | where: along the flank from the base circle
dang_van_z_wheel | m | its depth
dang_van_y_wheel | m | its row
dang_van_surface_wheel | Pa | the same at the surface, which depends on the grid
safety_dang_van_wheel | - | least factor on the stresses of the load at which the limit is met; null without a limit
safety_dang_van_s_wheel | m | where: along the flank
safety_dang_van_z_wheel | m | its depth
safety_dang_van_y_wheel | m | its row
cycles_dang_van_wheel | - | 5e7 S_DV^13.22, the slope of ISO's life factor; null where S_DV is 1 or more: above 5e7
life_ratio | - | life by Lundberg and Palmgren's risk of both flanks over that of dry contacts of the static load shares; above 1 where the motion unloads the flanks
sigma_H | Pa | line contact's pressure under the force, over the whole face
sigma_H_max | Pa | largest pressure of a line contact under the force, over the whole face
sigma_F_pinion | Pa | stress at the root of the pinion's tooth, by this contact
sigma_F_wheel | Pa | stress at the root of the wheel's tooth, by this contact
sigma_F_max_pinion | Pa | largest stress at the root of the pinion's teeth
sigma_F_max_wheel | Pa | largest stress at the root of the wheel's teeth
lambda_GF | - | film after ISO/TS 6336-22 over Ra; zero without force
contact_temperature | K | largest temperature of either flank; without heat in the film the bodies' with the flash on it
contact_temperature_max | K | largest temperature of either flank, for scuffing
working_pressure_angle_deg | deg | working pressure angle
base_radius_pinion | m | base radius of the pinion
base_radius_wheel | m | base radius of the wheel
base_pitch | m | distance of two contacts on the line of action
xi_entry | m | where a contact enters, from the pitch point
xi_exit | m | where a contact leaves, from the pitch point
contact_ratio | - | contacts at a time, on the average
R_x | m | reduced radius in the direction of rolling, at the pitch point or of the bare contact
R_y | m | reduced radius along the face
E_prime | Pa | reduced modulus
load | N | static force along the line of action, or the point load that stands for it
tooth_force | N | static force along the line of action
implied_backlash | m | normal backlash that both given profile shifts leave at the centre distance
entrainment_velocity | m/s | mean of the velocities of both flanks
kappa | - | ratio of the half axes a/b of the Hertz ellipse
a | m | half axis of the ellipse in the direction of rolling
b | m | half axis along the face
hertz_approach | m | approach of the dry bodies
M | - | Moes' group of the load
L | - | Moes' group of the lubricant
D | - | R_x/R_y
f_m | Hz | mesh frequency
mesh_period | s | time from one contact's entering to the next, 1/f_m
mesh_period_dimensionless | - | mesh period over a/u_m
entry_penetration | m | by which an entering tooth meets its mate under the static force; negative: they part
corner_contact_distance | m | how far before the path of contact real tips would touch
m_ge | kg | equivalent mass of the pair
I_n | - | dimensionless inertia
k_el | N/m | stiffness of the dry mesh under the static force, all contacts together, one at the pitch point
f_n | Hz | natural frequency of the dry pair on that stiffness
hamrock_dowson_h_central | m | central film, formula of Hamrock and Dowson
hamrock_dowson_h_min | m | smallest film, formula of Hamrock and Dowson
nijenbanning_venner_moes_h_central | m | central film, formula of Nijenbanning, Venner and Moes
thermal_loading | - | thermal loading parameter of the inlet
murch_wilson_thermal_factor | - | factor of the film by heat in the inlet, Murch and Wilson
gupta_thermal_factor | - | factor of the film by heat in the inlet, Gupta and others
nx | - | nodes in X
ny | - | nodes in Y
x_min | a | inlet end of the domain
x_max | a | outlet end of the domain
y_half | b | half width of the domain
expected_error_h_central | - | relative error of the central film that such a grid leads to expect
expected_error_h_min | - | relative error of the smallest film
steps_in_mesh_period | - | time steps in a mesh period
steps_in_free_oscillation | - | time steps in a free oscillation
distance | m | way along the line of action since the start
force_total | N | force on all contacts together
contacts | - | number of contacts
static_force | N | static force on the pair
H0_after_leaving | - | H_0 just after a contact has left
V0_after_leaving | - | V_0 just after a contact has left
contact_lost | | whether the total force falls below 0.02 of the static force
back_contact | | whether reverse flanks touch
transmission_error_peak_to_peak | m | transmission error, largest less smallest
transmission_error_rms | m | transmission error, root mean square of its deviation from the mean
floquet_modulus | - | what a disturbance keeps over the period
stable | | whether disturbances die away: floquet_modulus below 1
free_frequency | Hz | free oscillation about the periodic state
damping_ratio | - | damping ratio of the free oscillation
efficiency | - | power that goes through over the power that goes in
mean_friction_coefficient | - | mean friction coefficient
defect | - | change of the motion over the periodic period
film_defect | - | largest change of any pressure over the periodic period, in units of p_h (of films that feel their heat: root mean square of a field over its largest value)
periods_used | - | mesh periods marched to find the state
order | - | mesh periods, or patterns of teeth with errors, after which its states repeat
dT | - | time step over a/u_m
completed | | whether the run has come to its end
te_mean | m | transmission error, mean over the mesh period
te_peak_to_peak | m | transmission error, largest less smallest
te_pitch | m | transmission error with a contact at the pitch point
te_harmonics | m | amplitudes at the first multiples of the mesh frequency
mesh_stiffness_pitch | N/m | mesh stiffness with a contact at the pitch point
mesh_stiffness_mean | N/m | mesh stiffness, mean over the mesh period
effective_contact_ratio | - | contacts that carry more than a thousandth of the load, on the average
p_max_dry | Pa | largest Hertz pressure
iso_stiffness_single | N/m | c' of ISO 6336-1, method B, times the face width
iso_stiffness_mesh | N/m | c_gamma of ISO 6336-1, method B, times the face width
load_ratio | - | load over the static force
position | m | position on the line of action, from the pitch point
H_central | - | central film in units of a^2/R_x
H_min | - | smallest film in units of a^2/R_x
residual | - | last residual
convolutions | - | convolutions
newton_iterations_all_grids | - | iterations of Newton's method, on all grids of the start
krylov_iterations_all_grids | - | iterations of the linear solver, on all grids of the start
convolutions_all_grids | - | convolutions, on all grids of the start
h_central_isothermal | m | central film without heat
h_min_isothermal | m | smallest film without heat
thermal_factor | - | central film, of rough surfaces mean gap, with heat over that without
thermal_factor_min | - | the same of the smallest
thermal_change | - | change of the film in the last turn
thermal_turns | - | turns of film and heat
inertia_pinion | kg m^2 | moment of inertia of the pinion
inertia_wheel | kg m^2 | moment of inertia of the wheel
rigid_frequency | Hz | frequency of the rigid rotation: zero but for round-off
damped_frequency | Hz | frequency of the damped dry pair
film_frequency | Hz | frequency of the pair on its films
film_damping_ratio | - | damping ratio of the pair on its films
film_damping_ratio_bound | - | on stiff films: what the damping ratio is at most
swings_in_passage | - | radians of the swing while oil crosses half a contact
swing_solutions | - | linear solutions for the mode
swing_krylov_iterations | - | iterations of the linear solver in all of them
over | | what is varied
points_found | - | points found
points_failed | - | points where none was found
points | - | points
speed_rpm | rpm | speed of the pinion
torque | N m | torque of the pinion
viscosity | Pa s | viscosity at ambient pressure
direction | | way of the sweep
start | | where the search began
branch | - | number of the branch
kind | | kind of the bifurcation
number | - | number of the branch
end | | how it ends
born_on | - | branch at whose flip it is born
model | | model
motion | | whether bodies have inertia (dynamic) or are in balance at every moment (quasi_static)
repeats_every | - | mesh periods after which the march repeats
repeats_within | - | distance in (H0, V0) within which it does
settles_on | - | mesh periods after which the motion that it comes to repeat begins again
attractor | - | number of the motion
share | - | part of the starts that lead there
event | | entry or exit of a contact
from | | value of the parameter where it begins
to | | value of the parameter where it ends
distance_end | m | way along the line of action where contact is found again
largest_h_central | m | largest central film in between
frequency | Hz | frequency
torque_mean | N m | torque, mean in time
torque_max | N m | largest torque
torque_min | N m | smallest torque
force_mean | N | size of the force, mean in time
force_max | N | largest size
force_x_mean | N | its part along the line of centres, to the wheel, mean in time
force_y_mean | N | its part across, mean in time
rotation_acceleration_rms | rad/s^2 | root mean square of its angular acceleration
x_acceleration_rms | m/s^2 | of that along the line of centres
y_acceleration_rms | m/s^2 | of that across it
work_of_torques | J | work of the torques on the motion beside the mean rotation
work_of_teeth | J | work of the forces between flanks on it
dissipated_energy | J | what dampers take
stored_energy_change | J | change of the energy of motion, shafts and bearings
energy_balance_residual | - | what is left of both works less both energies, over the dissipated and the largest kinetic energy
"""
# What tells of the solver and its grid, not of the gears.
INTERNAL = {"steps", "contact_steps", "newton_iterations", "krylov_iterations", "wall_time", "H0", "V0", "nx", "ny",
            "x_min", "x_max", "y_half", "dT", "expected_error_h_central", "expected_error_h_min",
            "steps_in_mesh_period", "steps_in_free_oscillation", "temperatures_missed", "temperatures_missed_max",
            "heat_balance", "mesh_period_dimensionless", "defect", "film_defect", "periods_used", "H_central", "H_min",
            "residual", "convolutions", "newton_iterations_all_grids", "krylov_iterations_all_grids",
            "convolutions_all_grids", "thermal_change", "thermal_turns", "T", "last_H0", "last_V0", "rigid_frequency", "completed",
            "neighbour_error", "coarse_error"}
# From the unit of the summary: factor, unit, and from which size on, largest first.
SHOWN = {"m": ((0.9999e-4, 1e3, "mm"), (0.0, 1e6, "µm")), "Pa": ((1e7, 1e-9, "GPa"), (0.0, 1e-6, "MPa")),
         "s": ((1.0, 1.0, "s"), (1e-3, 1e3, "ms"), (0.0, 1e6, "µs")), "N/m": ((0.0, 1e-6, "N/µm"),)}


class Quantity(NamedTuple):
    """A quantity of a summary; the unit is empty for what is no number."""
    unit: str
    meaning: str


def _read(text):
    for line in text.strip().splitlines():
        name, unit, meaning = (cell.strip() for cell in line.split("|"))
        yield name, Quantity(unit, meaning)


KNOWN = dict(_read(TABLE))


def quantity(name):
    """The quantity of a name; errors and extrapolated values are as what they belong to. None of an unknown name."""
    for ending in ("_error", "_extrapolated"):
        if name not in KNOWN and name.endswith(ending):
            name = name.removesuffix(ending)
    return KNOWN.get(name)


def shown(unit, size):
    """Factor and unit in which numbers up to this size are read most easily."""
    for least, factor, other in SHOWN.get(unit, ()):
        if size >= least or size == 0:
            return factor, other
    return 1.0, unit
