#!/usr/bin/env python3
"""Run the fuzz targets, one a core at a time (make fuzz), and say what came of each.

What a run learns is kept in FOLDER/corpus/TARGET (build-fuzz) and used again by the next one, which begins with that
and the seeds of tests/fuzz/corpus. What breaks a target is written to FOLDER/found, the log is added to
FOLDER/logs/TARGET; executions and edges are counted over the whole log. The exit status is 1 if
something was broken.

    fuzz.py [--build FOLDER] [--seconds S] [--runs N] [TARGET ...]
    fuzz.py --keep [TARGET ...]     make the seeds of tests/fuzz/corpus anew: inputs that together reach all edges known
    fuzz.py --pack [TARGET ...]     move files that are too many into the archives; needs no build

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import concurrent.futures
import hashlib
import os
import re
import subprocess
import sys
import tempfile

import seeds

LONGEST = {"nef3": 6000, "scene": 1500, "merge": 3000, "compare": 2500, "sweep": 160, "check": 3000}  # bytes; others 1200


def targets(build):
    listed = subprocess.run([build + "/tests/fuzz/replay"], stdout=subprocess.PIPE, text=True, check=True)
    return listed.stdout.split()


def environment(target, folder):
    return dict(os.environ, GRAZE_FUZZ=target, GRAZE_FUZZ_FOLDER=folder,
                ASAN_OPTIONS="detect_leaks=1:allocator_may_return_null=1",
                UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1")


def scratch():
    return tempfile.TemporaryDirectory(prefix="graze-fuzz-", dir="/dev/shm" if os.path.isdir("/dev/shm") else None)


def told(log):
    """Executions, edges, and the execution that found the last edge, over all runs of a log."""
    before, runs, edges, last = 0, 0, 0, 0
    with open(log, encoding="utf-8", errors="replace") as file:
        for line in file:
            at = re.match(r"#(\d+)\s+(\w+)\s+cov: (\d+)", line)
            if at:
                if int(at[1]) < runs:
                    before += runs
                runs = int(at[1])
                if int(at[3]) > edges:
                    edges, last = int(at[3]), before + runs
            at = re.match(r"stat::number_of_executed_units:\s+(\d+)", line)
            if at:
                runs = int(at[1])
    return before + runs, edges, last


def fuzz(target, build, options):
    """True unless the target was broken."""
    corpus, log = f"{build}/corpus/{target}", f"{build}/logs/{target}"
    for folder in (corpus, build + "/logs", build + "/found"):
        os.makedirs(folder, exist_ok=True)
    command = ["nice", "-n", "15", build + "/tests/fuzz/fuzz", f"-max_len={LONGEST.get(target, 1200)}", "-timeout=30",
               # Weighing seeds by the rarity of what they reach takes a third of the time where an execution is short.
               "-rss_limit_mb=2500", "-close_fd_mask=3", "-print_final_stats=1", "-use_value_profile=0", "-entropic=0",
               f"-artifact_prefix={build}/found/{target}-", f"-max_total_time={options.seconds}"]
    if options.runs:
        command.append(f"-runs={options.runs}")
    words = f"tests/fuzz/words/{target}"
    if os.path.exists(words):
        command.append("-dict=" + words)
    with scratch() as folder, open(log, "a", encoding="utf-8") as out:
        seeds.lay_out(target, folder + "/seeds")
        done = subprocess.run(command + [corpus, folder + "/seeds"], stdout=out, stderr=out,
                              env=environment(target, folder))
    runs, edges, last = told(log)
    quiet = 100 * (runs - last) // max(runs, 1)
    print(f"{target}: {runs} executions, {edges} edges, none new in the last {quiet} %"
          + ("" if done.returncode == 0 else f"; BROKEN, see {log} and {build}/found"), flush=True)
    return done.returncode == 0


def edges_of(target, build, folder, inputs):
    """Path -> edges that the file reaches, by libFuzzer's own record of a merge; not of a file that breaks the target."""
    control = folder + "/control"
    os.makedirs(folder + "/merged")
    subprocess.run([build + "/tests/fuzz/fuzz", "-set_cover_merge=1", "-use_counters=0", "-close_fd_mask=3", "-timeout=30",
                    "-rss_limit_mb=2500", "-merge_control_file=" + control, folder + "/merged", *inputs],
                   env=environment(target, folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    with open(control, encoding="utf-8") as file:
        lines = file.read().splitlines()
    paths = lines[2:2 + int(lines[0])]
    reached = [line.split() for line in lines[2 + len(paths):] if line.startswith("FT ")]
    return {paths[int(words[1])]: {(build, word) for word in words[2:]} for words in reached}


def cover(edges, first, size):
    """Paths that together reach all edges: the first ones, then always that which reaches most that are not reached yet."""
    out, left = list(first), {path: set(reached) for path, reached in edges.items()}
    new = set().union(*(edges.get(path, ()) for path in first))
    while True:
        left = {path: reached - new for path, reached in left.items() if not reached <= new}
        if not left:
            return out
        out.append(min(left, key=lambda path: (-len(left[path]), size[path], path)))
        new = left[out[-1]]


def keep(target, builds):
    """The seeds of a target made anew. Those with names of their own stay and come first."""
    with scratch() as folder:
        known, edges = seeds.lay_out(target, folder + "/seeds"), {}
        learned = [path for path in (f"{build}/corpus/{target}" for build in builds) if os.path.isdir(path)]
        for build in builds:
            for path, reached in edges_of(target, build, f"{folder}/{build}", [folder + "/seeds", *learned]).items():
                edges.setdefault(path, set()).update(reached)
        own = [path for path in known if seeds.is_own(os.path.basename(path))]
        kept = {}
        for path in cover(edges, own, {path: os.path.getsize(path) for path in edges}):
            with open(path, "rb") as file:
                content = file.read()
            kept[os.path.basename(path) if path in own else hashlib.sha1(content).hexdigest()[:12]] = content
        seeds.store(target, kept)
    print(f"{target}: {len(kept)} seeds reach {len(set().union(*edges.values()))} edges", flush=True)


def pack(target):
    """Files beyond the number allowed go into the archive: of those without a name of their own the last."""
    every, files = seeds.load(target), seeds.plain(target)
    order = sorted(files, key=lambda name: (not seeds.is_own(name), name)) + sorted(set(every) - set(files))
    seeds.store(target, {name: every[name] for name in order})
    print(f"{target}: {len(every)} seeds, {len(seeds.plain(target))} of them files")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", action="append", help="build-fuzz; of several all edges are kept, the first one fuzzes")
    parser.add_argument("--seconds", type=int, default=60, help="for each target")
    parser.add_argument("--runs", type=int, default=0, help="executions at most of each target")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--pack", action="store_true")
    parser.add_argument("target", nargs="*")
    options = parser.parse_args()
    builds = options.build or ["build-fuzz"]
    if options.pack:
        for target in options.target or sorted(entry.name for entry in os.scandir(seeds.CORPUS) if entry.is_dir()):
            pack(target)
        return
    known = targets(builds[0])
    for target in options.target:
        if target not in known:
            sys.exit(f"{target}: is no target; expected one of {', '.join(known)}")
    chosen = options.target or known
    if options.keep:
        for target in chosen:
            keep(target, builds)
        return
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        stood = list(pool.map(lambda target: fuzz(target, builds[0], options), chosen))
    print(f"{sum(stood)} passed, {len(stood) - sum(stood)} failed")
    sys.exit(0 if all(stood) else 1)


if __name__ == "__main__":
    main()
