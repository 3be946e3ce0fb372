"""The same candidate in ten lines of pandas."""  # SPDX-License-Identifier: CC0-1.0
import sys
import numpy as np
import pandas as pd

points = pd.read_csv(sys.argv[1], float_precision="round_trip")  # without it some floats are an ulp off
passed = pd.Series(False, points.index)
for front in 8 * np.linspace(0, 1, 1000):
    passed |= points.x.between(front, front + 2, inclusive="neither")
passed &= points.y.between(0, 2, inclusive="neither") & points.z.between(0, 2, inclusive="neither")
points["pmc"] = passed.map({True: "in", False: "out"})
points[["id", "pmc"]].to_csv(sys.argv[2], index=False)
