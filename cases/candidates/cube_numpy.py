"""A candidate in ten lines of numpy: the cube of README.md's first scene at 1000 times."""  # SPDX-License-Identifier: CC0-1.0
import sys
import numpy as np

points = np.genfromtxt(sys.argv[1], delimiter=",", names=True, usecols=("id", "x", "y", "z"))
x, y, z = points["x"], points["y"], points["z"]
passed = np.zeros(len(x), bool)
for front in 8 * np.linspace(0, 1, 1000):
    passed |= (front < x) & (x < front + 2) & (0 < y) & (y < 2) & (0 < z) & (z < 2)
rows = np.c_[points["id"].astype(int), np.where(passed, "in", "out")]
np.savetxt(sys.argv[2], rows, fmt="%s", delimiter=",", header="id,pmc", comments="")
