# SPDX-License-Identifier: Apache-2.0
"""The scene sets of the recognition statistics: what is rendered, and with which options."""

SCENES_PER_SET = 40
SCENES_PER_POINT = 20

# Name, options of `trihedron render`, seed. Scenes of every kind, two libraries.
KINDS = [
    ("cad-isolated", "--look cad", 11),
    ("cad-two", "--look cad --objects 2", 12),
    ("studio-isolated", "--look studio", 13),
    ("studio-two", "--look studio --objects 2", 14),
    ("lab-isolated", "--look lab", 15),
    ("lab-two", "--look lab --objects 2", 16),
    ("lab-stacked", "--look lab --objects 2 --stacked", 17),
    ("lab-hd", "--look lab --rig hd --objects 5 --stacked", 18),
    ("lab-leaning", "--look lab --objects 2 --leaning", 19),
]

# Objects that are not in the library: stretched by 10 % along one axis, or mirrored.
UNKNOWN = [
    ("unknown-studio", "--look studio --variant both", 2361),
    ("unknown-lab", "--look lab --variant both", 2401),
]

# The other way round: scenes of a kind, a library that holds nothing but the variants of an unknown set.
IMPOSTORS = [
    ("impostors-studio", "studio-two", "unknown-studio"),
    ("impostors-lab", "lab-two", "unknown-lab"),
    ("impostors-hd", "lab-hd", "unknown-lab"),
]

# Condition, its unit, option, values; the poses are the same at every value.
SWEEP_OPTIONS = "--look lab --objects 2"
SWEEP_SEED = 31
# Five cameras share too small a field for two of the larger parts.
SWEEPS = [
    ("noise", "standard deviation of the pixel noise, grey levels", "--noise", [1, 2.5, 5, 8, 12]),
    ("contrast", "factor of all grey-level differences", "--contrast", [1, 0.6, 0.4, 0.25, 0.15]),
    ("views", "number of views", "--cameras", [2, 3, 4]),
    ("calibration", "calibration error in the image, px", "--calibration-error", [0, 0.25, 0.5, 1, 2]),
]

# Four objects a scene, each drawn from the library and its unknown variants together.
MIXED_OPTIONS = "--look lab --rig hd --objects 4"
MIXED_SEED = 41
