#!/usr/bin/env python3
"""Speed of Graze beside its peers, in one run on one core: what each kind of work must reach and what it does.

Peers are built with CGAL: all intersections of segments with a mesh (the straight trajectory, or the chord of
an arc), the union of 1,000 sampled positions, reading and checking a mesh. Both sides take the same points in
turns, fresh ones in every repeat; times are CPU microseconds a query, ratios the medians of the repeats'. Rates
move with the machine: compare only figures of one run.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import statistics
import tempfile

import certificates
import collisions
import contacts
import curved
import distances
import judging
import outlines
import positions
import scenes
import turns
import waiting
from cores import Cores
from measure import Server, Stream, fitting, in_turns, run_cpu, same_numbers
from table import Table

REPEATS = 5
SAMPLES = 1000
MOTIONS = {"translation": scenes.TRANSLATION, "rotation": scenes.ROTATION, "screw": scenes.SCREW,
           "axis": scenes.AXIS_PARALLEL}


class Bench:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.graze = options.graze
        self.programs = os.path.join(os.path.dirname(options.graze), "tests", "bench")
        self.total = 20000 if options.quick else 100000
        self.target = 0.2 if options.quick else 0.6
        self.sizes = [n for n in scenes.TORUS_SIZES if n <= (100000 if options.quick else 1000000)]
        self.sizes = [n for n in self.sizes if n <= options.largest]
        self.table = Table()
        self.growth = {}
        self.asked = self.exact = 0

    def path(self, name):
        return os.path.join(self.folder, name)

    def prepare(self):
        box = scenes.TORUS_BOX
        for name, motion in MOTIONS.items():
            with open(self.path(name + ".json"), "w", encoding="ascii") as file:
                file.write(motion.json)
        for name in ("translation", "rotation", "screw"):
            motion = MOTIONS[name]
            points = scenes.points_crossing(motion, box, self.total, 1)
            scenes.save_points(self.folder, name, motion, points)
            if name == "translation":
                scenes.write_csv(self.path("translation.csv"), points)
        for name, width in (("near", 1.25), ("far", 2)):
            scenes.save_points(self.folder, name, scenes.TRANSLATION,
                               scenes.points_around(scenes.TRANSLATION, box, width, self.total, 1))
        scenes.save_samples(self.path("screw.samples"), scenes.SCREW, SAMPLES)
        scenes.save_points(self.folder, "grid", scenes.AXIS_PARALLEL,
                           scenes.points_grid(scenes.GRID_SIZE, self.total, 1))

    # ------------------------------------------------------------------------------------ one program each
    def peers(self, solid):
        return Server(os.path.join(self.programs, "peers"), self.path(solid))

    def inside(self, solid):
        return Server(os.path.join(self.programs, "inside"), self.path(solid))

    def points(self, inside, points, counted=True):
        """A function (start, n) -> seconds of Graze."""
        name = points if points == "made" else self.path(points + ".points")

        def ask(start, n):
            answer = inside.ask("classify", name, start, n)
            if counted:
                self.asked += n
                self.exact = None if answer["exact"] < 0 or self.exact is None else self.exact + answer["exact"]
            return answer["seconds"]
        return ask

    def segments(self, peers, points):
        return lambda start, n: peers.ask("count", self.path(points + ".segments"), start, n)["seconds"]

    def each(self, inside, points, n):
        name = points if points == "made" else self.path(points + ".points")
        return inside.ask("each", name, 0, n)

    # ------------------------------------------------------------------------------------------------ rows
    def against_count(self, work, key, size, inside, peers, points, most):
        """Graze in process against all intersections of the same segments, or chords."""
        graze, peer, ratio, n = in_turns(self.points(inside, points), self.segments(peers, points),
                                         self.total, self.target, REPEATS)
        hit = peers.ask("count", self.path(points + ".segments"), 0, n)["hit"] / n
        self.table.row(f"{work}, {size:,} faces ({hit:.0%} hit, {n:,} points)", ratio, most=most,
                       graze=graze, peer=peer, each=self.each(inside, points, n))
        self.growth.setdefault(key, {})[size] = graze, peer
        return graze

    def against_embree(self, size, inside, solid, peers):
        """Embree, in single precision: no requirement, and how many of its counts are not those of Graze."""
        program = os.path.join(self.programs, "embree")
        if not os.path.exists(program):
            return
        embree = Server(program, self.path(solid))
        graze, peer, ratio, n = in_turns(self.points(inside, "translation", False), self.segments(embree, "translation"), self.total,
                                         self.target, REPEATS)
        self.table.row(f"translation against Embree {embree.ready['version'] / 10000:.0f}, single precision, {size:,} faces ({n:,} points)",
                       ratio, graze=graze, peer=peer)
        made = self.path("designed.csv")
        run_cpu([self.graze, "generate", self.path(solid), self.path("translation.json"), "-n", "2000", "--seed", "1", "--representable",
                 "binary64", "--quiet", "--output", made])
        scenes.save_points(self.folder, "designed", scenes.TRANSLATION, scenes.read_csv(made))
        for points in ("translation", "designed"):
            self.agreement(size, inside, embree, points, "Embree")
        self.agreement(size, inside, peers, "designed", "CGAL")
        embree.close()

    def exact_path(self, work, size, inside, points, filtered):
        inside.ask("filter", 0)
        ask = self.points(inside, points, counted=False)
        n = fitting(ask, self.total // 3, self.target)
        spent = statistics.median(ask(r * n, n) / n for r in range(3))
        self.table.row(f"{work}, {size:,} faces, the exact path alone, as multiple", spent / filtered,
                       graze=spent, each=self.each(inside, points, n))
        inside.ask("filter", 1)

    def command_line(self, size, solid, peers):
        with open(self.path("translation.csv"), encoding="ascii") as file:
            lines = file.readlines()
        paths = self.path(solid), self.path("translation.json")
        stream = Stream(self.graze, *paths)
        n = stream.fitting(lines, self.target, REPEATS)
        times = [(stream.rows(lines[r * n:(r + 1) * n]) / n,
                  self.segments(peers, "translation")(r * n, n) / n) for r in range(REPEATS)]
        stream.close()
        graze, peer = (statistics.median(t[k] for t in times) for k in (0, 1))
        self.table.row(f"graze classify, translation, {size:,} faces ({n:,} rows)",
                       statistics.median(a / b for a, b in times), most=4, graze=graze, peer=peer)
        stream = Stream(self.graze, *paths, "--no-filter")
        n = stream.fitting(lines, self.target, REPEATS)
        exact = statistics.median(stream.rows(lines[r * n:(r + 1) * n]) / n for r in range(3))
        stream.close()
        self.table.row(f"graze classify --no-filter, {size:,} faces, as multiple ({n:,} rows)", exact / graze,
                       graze=exact)

    def union(self, size, inside, peers):
        ask = lambda start, n: peers.ask("union", self.path("screw.points"), start, n,
                                         self.path("screw.samples"))["seconds"]
        peer, graze, ratio, n = in_turns(ask, self.points(inside, "screw"), self.total, self.target, REPEATS)
        self.table.row(f"screw against the union of {SAMPLES:,} samples, {size:,} faces ({n:,} points)", ratio,
                       least=3, graze=graze, peer=peer, each=self.each(inside, "screw", n))
        sampled = peers.ask("union", self.path("screw.points"), 0, n, self.path("screw.samples"))["inside"]
        exact = inside.ask("classify", self.path("screw.points"), 0, n)["in"]
        self.table.note(f"{size:,} faces: inside are {sampled:.0f} of {n} points by samples, {exact:.0f} in truth")

    def pmc_alone(self, name, size, solid, full, peers):
        """pmc alone against the union of samples, and for points inside against the full answer."""
        quick = self.inside(solid)
        quick.ask("columns", "pmc")
        quick.ask("motion", self.path(name + ".json"))
        if name == "screw":
            ask = lambda start, n: peers.ask("union", self.path("screw.points"), start, n,
                                             self.path("screw.samples"))["seconds"]
            peer, graze, ratio, n = in_turns(ask, self.points(quick, "screw"), self.total, self.target, REPEATS)
            self.table.row(f"pmc alone, screw against that union, {size:,} faces ({n:,} points)", ratio, least=10,
                           graze=graze, peer=peer, each=self.each(quick, "screw", n))
        count = int(full.ask("inside", self.path(name + ".points"), 0, self.total // 2, self.path("in.points"))["count"])
        all_, graze, ratio, n = in_turns(self.points(full, "in", False), self.points(quick, "in", False), count,
                                         self.target, REPEATS)
        self.table.row(f"pmc alone, {name}, points inside against the full answer, {size:,} faces ({n:,} points)",
                       ratio, least=3, graze=graze, peer=all_, each=self.each(quick, "in", n))
        quick.close()

    def static(self, size, peers):
        n = self.total
        spent = peers.ask("static", self.path("screw.points"), 0, n)["seconds"] / n
        self.table.row(f"CGAL's point in the standing solid, {size:,} faces", spent * 1e6, unit="us", peer=spent)

    def agreement(self, size, inside, peers, points, name="CGAL"):
        n = min(2000, self.total)
        one, other = self.path("graze.i"), self.path("peers.i")
        inside.ask("verdicts", self.path(points + ".points"), 0, n, one)
        peers.ask("counts", self.path(points + ".segments"), 0, n, other)
        same, count = same_numbers(one, other)
        self.table.note(f"{size:,} faces, {points}: {name}'s hits agree with Graze's intersections for {same} of {count} points")

    def loading(self, size, solid):
        """Start both programs in turns; the last pair is handed back, warm."""
        judged = size == self.sizes[-1]
        repeats = REPEATS if size < 1000000 else 3
        loads, inside, peers = [], None, None
        for _ in range(repeats):
            for server in (inside, peers):
                if server:
                    server.close()
            peers, inside = self.peers(solid), self.inside(solid)
            checks = peers.ask("checks")["seconds"]
            validate = inside.ask("validate", self.path(solid))["validate"]
            load = inside.ready["load"] - validate
            loads.append((load, peers.ready["read"] + peers.ready["tree"], validate, checks))
        load, read, validate, checks = (statistics.median(r[k] for r in loads) for k in range(4))
        for work, one, other, most in (("load and tree", load, read, 2), ("validation", validate, checks, 10)):
            self.table.row(f"{work}, {size:,} faces, one mesh", one / other,
                           most=most if judged else None, graze=one, peer=other)
        self.table.row(f"memory a face, {size:,} faces, binary64", inside.ready["bytes"] / inside.ready["facets"],
                       most=400 if judged else None, unit=" B")
        return inside, peers

    def long_numbers(self):
        solid = self.path("long.off")
        scenes.write_off(solid, scenes.torus(*scenes.TORUS_SIZES[10000]), 30)
        inside = self.inside("long.off")
        inside.close()
        self.table.row("memory a face, 10,000 faces, 47 decimals", inside.ready["bytes"] / inside.ready["facets"],
                       most=1000, unit=" B")

    def degenerate(self, inside, name):
        """The generator's defaults against its random points, as rationals."""
        n = fitting(self.made(inside, "default"), self.total // REPEATS, self.target)
        pairs = []
        for seed in range(REPEATS):
            pairs.append([self.made(inside, strata)(seed, n) / n for strata in ("default", "random")])
        self.made(inside, "default")(0, n)
        spent = inside.ask("make", "default", 0, n)["seconds"] / n
        self.table.row(f"generating such points, {name}, 1,000 faces, points a second", 1 / spent, least=5500, unit="",
                       graze=spent)
        graze, random = (statistics.median(p[k] for p in pairs) for k in (0, 1))
        self.table.row(f"degenerate points, {name}, 1,000 faces, points a second", 1 / graze, least=40000, unit="",
                       graze=graze, each=self.each(inside, "made", n))
        self.table.row(f"degenerate points, {name}: share of the random rate",
                       statistics.median(b / a for a, b in pairs), least=0.05, unit="", graze=graze, peer=random)

    def made(self, inside, strata):
        def ask(seed, n):
            inside.ask("make", strata, seed, n)
            return self.points(inside, "made", counted=False)(0, n)
        return ask

    def cores(self, solid):
        with open(self.path("translation.csv"), encoding="ascii") as file:
            lines = file.readlines()
        two = Cores(self.graze, self.folder, self.path(solid), self.path("translation.json"), lines, REPEATS)
        two.measure(self.table, 5 * self.target)

    def grid(self, name, mesh):
        solid = name.replace(" ", "") + ".off"
        scenes.write_off(self.path(solid), mesh)
        inside = self.inside(solid)
        inside.ask("motion", self.path("axis.json"))
        ask = self.points(inside, "grid", counted=False)
        n = fitting(ask, self.total // REPEATS, self.target)
        spent = statistics.median(ask(r * n, n) / n for r in range(REPEATS))
        self.table.row(f"grid of {scenes.GRID_SIZE}^3, {name}, in process, points a second ({n:,} drawn)", 1 / spent,
                       least=50000, unit="", graze=spent, each=self.each(inside, "grid", n))
        inside.close()
        # The small grid takes every fourth plane, so that more of its points are coincident.
        size, high = (50, 196) if self.options.quick or spent > 4e-5 else (scenes.GRID_SIZE, 199)
        cpu, _ = run_cpu([self.graze, "classify", "--jobs", "1", "--grid", f"{size},{size},{size}",
                          "--box", f"0,0,0,{high},{high},{high}", self.path(solid), self.path("axis.json")])
        self.table.row(f"graze classify --grid {size},{size},{size}, {name}, points a second", size ** 3 / cpu,
                       least=50000, unit="", graze=cpu / size ** 3)

    def grid_together(self, size, solid):
        """pmc of a whole grid around the sweep, against points of it from a file; without loading and start."""
        side, part = (128, 5) if self.options.quick else (256, 19)
        words = [self.graze, "classify", "--jobs", "1", "--quiet", "--columns", "pmc", self.path(solid), self.path("rotation.json")]
        grid = [*words, "--grid", f"{side},{side},{side}"]
        run_cpu([*grid, "--shard", f"1/{part}", "--output", self.path("part.csv")])
        with open(self.path("one.csv"), "w", encoding="ascii") as file:
            file.write("0,0,0\n")
        times = []
        for _ in range(REPEATS):
            empty, one, all_ = (run_cpu([*w, "--output", os.devnull])[0]
                                for w in ([*words, self.path("one.csv")], [*words, self.path("part.csv")], grid))
            times.append(((all_ - empty) / side ** 3, (one - empty) / (side ** 3 // part)))
        graze, peer = (statistics.median(t[k] for t in times) for k in (0, 1))
        self.table.row(f"pmc of a grid of {side}^3, rotation, {size:,} faces, against its points one by one",
                       statistics.median(b / a for a, b in times), least=10, graze=graze, peer=peer)

    def grown(self):
        sizes = self.sizes[0], self.sizes[-1]
        for key, by_size in self.growth.items():
            small, large = (by_size[n] for n in sizes)
            self.table.row(f"growth from {sizes[0]:,} to {sizes[1]:,} faces, {key}: Graze's by CGAL's",
                           (large[0] / small[0]) / (large[1] / small[1]), most=1.5)

    # ----------------------------------------------------------------------------------------------- order
    def mesh(self, size):
        table, solid = self.table, f"torus{size}.off"
        scenes.write_off(self.path(solid), scenes.torus(*scenes.TORUS_SIZES[size]))
        table.head(f"Torus of {2 * scenes.TORUS_SIZES[size][0] * scenes.TORUS_SIZES[size][1]:,} faces")
        inside, peers = self.loading(size, solid)
        inside.ask("motion", self.path("translation.json"))
        self.agreement(size, inside, peers, "translation")
        filtered = self.against_count("translation", "translation", size, inside, peers, "translation", 1.5)
        self.against_embree(size, inside, solid, peers)
        self.against_count("translation, most miss", "most miss", size, inside, peers, "near", 3)
        self.against_count("translation, nearly all miss", "nearly all miss", size, inside, peers, "far", 3)
        self.exact_path("translation", size, inside, "translation", filtered)
        self.command_line(size, solid, peers)
        self.pmc_alone("translation", size, solid, inside, peers)
        if size == self.sizes[0]:
            self.degenerate(inside, "translation")
            self.cores(solid)
        inside.ask("motion", self.path("rotation.json"))
        filtered = self.against_count("rotation, degree 4, against its chord", "rotation", size, inside, peers,
                                      "rotation", 5)
        self.exact_path("rotation", size, inside, "rotation", filtered)
        self.pmc_alone("rotation", size, solid, inside, peers)
        if size == self.sizes[0]:
            self.degenerate(inside, "rotation")
        if size == 100000:
            self.grid_together(size, solid)
        inside.ask("motion", self.path("screw.json"))
        self.union(size, inside, peers)
        self.pmc_alone("screw", size, solid, inside, peers)
        self.static(size, peers)
        inside.close()
        peers.close()

    def run(self):
        print(f"CPU microseconds a query; medians of {REPEATS}; peers by CGAL with EPICK"
              f"{'; small counts' if self.options.quick else ''}. `{self.graze}`, {os.cpu_count()} cores")
        self.prepare()
        for size in self.sizes:
            self.mesh(size)
        turns.measure(self)
        turns.measure_poses(self)
        distances.measure(self)
        curved.measure(self)
        collisions.measure(self)
        self.table.head("Over all sizes")
        if len(self.sizes) > 1:
            self.grown()
        self.table.row("random queries that reach the exact path, in 1,000",
                       None if self.exact is None else 1000 * self.exact / self.asked, most=1, unit="")
        self.long_numbers()
        self.grid("integer box", scenes.BLOCK)
        self.grid("L-shape", scenes.L_SHAPE)
        certificates.run(self.table, self.graze, self.folder, 60 if self.options.quick else 300)
        contacts.run(self.table, self.graze, self.folder, 500 if self.options.quick else 2000)
        waiting.run(self.table, self.graze, self.folder)
        judging.run(self.table, self.graze, self.folder, self.options.quick)
        outlines.run(self.table, self.graze, self.folder)
        positions.run(self.table, self.graze, self.folder, 20 if self.options.quick else 100)
        self.table.end(self.options.json)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--graze", default="build/graze")
    parser.add_argument("--quick", action="store_true", help="small counts, up to 100,000 faces")
    parser.add_argument("--largest", type=int, default=1000000, help="faces of the largest mesh")
    parser.add_argument("--json", help="write the rows there too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        Bench(options, folder).run()


if __name__ == "__main__":
    main()
