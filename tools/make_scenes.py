#!/usr/bin/env python3
"""Writes the scenes that come with Cairn. Uses the standard library alone, and gives the same bytes every time.

usage: tools/make_scenes.py [FOLDER]    (default: the scenes folder beside this one)

Lengths are in meters, masses in kg, densities in kg/m^3, angles in degrees; y is up.
"""

import pathlib
import sys

import scenes_of_bicycles as bicycles
import scenes_of_boxes as boxes
import scenes_of_joints as hung
import scenes_of_machines as machines
import scenes_of_masonry as masonry
import scenes_of_shapes as shapes
import scenes_of_water as water

SCENES = [
    ("01_open_plane", boxes.open_plane),
    ("02_two_planes", boxes.two_planes),
    ("03_big_walled_box", boxes.big_walled_box),
    ("04_small_walled_box", boxes.small_walled_box),
    ("05_varied_masses", boxes.varied_masses),
    ("06_slopes", boxes.slopes),
    ("07_pyramid", boxes.pyramid),
    ("08_tower", boxes.tower),
    ("09_dominoes", boxes.dominoes),
    ("10_billiards_break", boxes.billiards),
    ("11_newtons_cradle", boxes.newtons_cradle),
    ("12_t_handles", boxes.t_handles),
    ("13_pile", boxes.pile),
    ("14_avalanche", boxes.avalanche),
    ("15_marble_run", shapes.marble_run),
    ("16_bowl_of_hulls", shapes.bowl_of_hulls),
    ("17_wrecking_ball", shapes.wrecking_ball),
    ("18_bowling", shapes.bowling),
    ("19_eulers_disk", shapes.eulers_disk),
    ("20_tippe_tops", shapes.tippe_tops),
    ("21_gears", shapes.gears),
    ("22_staircase", shapes.staircase),
    ("23_conveyor_loop", shapes.conveyor_loop),
    ("24_rolling_race", shapes.rolling_race),
    ("25_ragdolls", hung.ragdolls),
    ("26_suspension_bridge", hung.bridge),
    ("27_ball_and_chain", hung.ball_and_chain),
    ("28_cars", hung.cars),
    ("29_walker", machines.walker),
    ("30_clock", machines.clock),
    ("31_chain_reaction", machines.chain_reaction),
    ("32_robot_arm", machines.robot),
    ("33_bullets", boxes.bullets),
    ("34_pinball", boxes.pinball),
    ("35_stroll", machines.stroll),
    ("36_harbor", water.harbor),
    ("37_arches", masonry.arches),
    ("38_bicycles", bicycles.bicycles),
    ("welcome", boxes.welcome),
]


def main():
    if len(sys.argv) > 2 or any(a.startswith("-") for a in sys.argv[1:]):
        sys.exit(__doc__.strip().splitlines()[2])
    default = pathlib.Path(__file__).resolve().parent.parent / "scenes"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) == 2 else default
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in SCENES:
        make().write(folder / f"{name}.gltf")


if __name__ == "__main__":
    main()
