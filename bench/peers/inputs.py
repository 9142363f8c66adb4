"""Lists for the engines, made from the project's reference: the grid's designs and the paper's two impacts."""

import csv
import json
import math

from drop import Design

DESIGN_COLUMNS = ["upper_slope_deg", "along_m", "normal_m", "verdict_rod", "verdict_box_1mm"]
STRIKE_COLUMNS = DESIGN_COLUMNS[:3] + ["x_m", "y_m", "angle_rad", "vx_m_s", "vy_m_s", "spin_rad_s"]
GRID_UPPER_SLOPE_DEG = 15.0
CASES = {"rod": ("case1_rod", "case2_rod"), "box": ("case1_box_1mm", "case2_box_1mm")}


def write_grid(reference, target):
    """The 98 designs of the grid: the lower plate's slope and `normal` give its line."""
    with open(reference, newline="") as file:
        rows = list(csv.DictReader(file))
    with open(target, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(DESIGN_COLUMNS)
        for row in rows:
            normal = float(row["line_b_m"])
            between = math.radians(float(row["lower_slope_deg"]) + GRID_UPPER_SLOPE_DEG)
            along = normal / math.tan(between)
            writer.writerow([GRID_UPPER_SLOPE_DEG, along, normal, row["verdict_rod"], row["verdict_box_1mm"]])


def write_strikes(reference, target):
    """The box's state when it touches the lower plate, in both of the paper's cases."""
    with open(reference) as file:
        exact = json.load(file)
    with open(target, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(STRIKE_COLUMNS)
        for name in CASES["box"]:
            writer.writerow(_strike(exact[name]))


def _strike(case):
    line, flight = case["line"], case["flight"]
    design = Design(case["upper_slope_deg"], line["along_m"], line["normal_m"])
    centre, velocity = design.to_world(*flight["centre"]), design.to_world(*flight["velocity"])
    # The paper's angles and spins count from x to y, which is clockwise in world axes.
    angle = -design.slope - math.radians(flight["angle_deg"])
    return [design.upper_slope_deg, design.along, design.normal, *centre, angle, *velocity, -flight["spin"]]


def exact_spins(reference, part):
    """Spin [rad/s] after the impact of each case, counter-clockwise."""
    with open(reference) as file:
        exact = json.load(file)
    return [-exact[name]["impact"]["after"]["spin"] for name in CASES[part]]
