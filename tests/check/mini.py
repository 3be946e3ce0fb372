"""graze-check on mini-gmp says what graze-check says on GMP, of all that the suites of this folder give it.

SPDX-License-Identifier: GPL-3.0-or-later

`make graze-check-mini` builds it: 5,000 lines of C in place of GMP's. The calls that the suites make, the golden cases' and other
certificates, forged ones, bad files, are recorded as for weakened.py, and both programs run on each: status and texts must be the same.
By hand, and in test-long; it needs Debian's archive once.
"""
import concurrent.futures
import glob
import json
import os
import subprocess
import sys
import tempfile

from weakened import SUITES  # sets the path
from harness import Checks, options

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
LEAST = {0: 300, 1: 1000, 2: 200}  # calls of each status


def recorded(folder, graze):
    for k, suite in enumerate(SUITES):
        place = os.path.join(folder, str(k))
        os.mkdir(place)
        subprocess.run([sys.executable, os.path.join(HERE, suite), "--graze", graze], env=dict(os.environ, GRAZE_CHECK_RECORD=place),
                       stdout=subprocess.DEVNULL, check=True)
    return sorted(glob.glob(os.path.join(folder, "*", "*", "call.json")))


def both(programs, path):
    """(status, output, error) of each program for a recorded call."""
    with open(path, encoding="utf-8") as file:
        words = json.load(file)["words"]
    done = [subprocess.run([program, *words], cwd=os.path.dirname(path), stdin=subprocess.DEVNULL, capture_output=True, check=False, timeout=300)
            for program in programs]
    return [(one.returncode, one.stdout, one.stderr) for one in done]


def main():
    graze = os.path.abspath(options(__doc__).graze)
    tally, build, counts = Checks(), os.path.dirname(graze), dict.fromkeys(LEAST, 0)
    subprocess.run(["make", "-s", f"B={os.path.relpath(build, ROOT)}", "graze-check-mini"], cwd=ROOT, check=True)
    programs = [os.path.join(build, name) for name in ("graze-check", "graze-check-mini")]
    linked = subprocess.run(["ldd", programs[1]], capture_output=True, text=True, check=True).stdout
    tally.holds("libgmp" not in linked, linked)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        calls = recorded(folder, graze)
        for path, (gmp, mini) in zip(calls, pool.map(lambda path: both(programs, path), calls)):
            tally.equal(mini, gmp, path)
            counts[gmp[0]] = counts.get(gmp[0], 0) + 1
    for status, least in LEAST.items():
        tally.holds(counts[status] >= least, f"{counts[status]} calls of status {status}, expected at least {least}")
    print(f"calls by status: {counts}")
    tally.finish()


if __name__ == "__main__":
    main()
