#!/usr/bin/env python3
"""Run the fuzz targets in turn (make fuzz), and say what came of each.

What a run learns is kept in FOLDER/corpus/TARGET (build-fuzz) and used again by the next one, which begins with that
and the seeds of tests/fuzz/corpus. What breaks a target is written to FOLDER/found, the log is added to
FOLDER/logs/TARGET; executions and edges are counted over the whole log. The exit status is 1 if
something was broken.

    fuzz.py [--build FOLDER] [--seconds S] [--runs N] [TARGET ...]
    fuzz.py --keep [TARGET ...]     put the smallest inputs that reach all edges known into tests/fuzz/corpus

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

SEEDS = "tests/fuzz/corpus"
LONGEST = {"nef3": 6000, "scene": 1500, "merge": 3000, "compare": 2500, "sweep": 160, "check": 3000}  # bytes; others 1200
MOST_KEPT = {"nef3": 110000, "scene": 110000, "compare": 80000}  # bytes of all seeds of a target; others 60000


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


def fuzz(target, options):
    """True unless the target was broken."""
    build = options.build
    corpus, log = f"{build}/corpus/{target}", f"{build}/logs/{target}"
    for folder in (corpus, build + "/logs", build + "/found", f"{SEEDS}/{target}"):
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
        done = subprocess.run(command + [corpus, f"{SEEDS}/{target}"], stdout=out, stderr=out,
                              env=environment(target, folder))
    runs, edges, last = told(log)
    quiet = 100 * (runs - last) // max(runs, 1)
    print(f"{target}: {runs} executions, {edges} edges, none new in the last {quiet} %"
          + ("" if done.returncode == 0 else f"; BROKEN, see {log} and {build}/found"), flush=True)
    return done.returncode == 0


def keep(target, build):
    """The seeds of a target made anew: small inputs first, as many as there is room for."""
    seeds, corpus = f"{SEEDS}/{target}", f"{build}/corpus/{target}"
    os.makedirs(seeds, exist_ok=True)
    with scratch() as folder:
        merged = os.path.join(folder, "merged")
        os.makedirs(merged)
        subprocess.run([build + "/tests/fuzz/fuzz", "-set_cover_merge=1", "-close_fd_mask=3", "-timeout=30", "-rss_limit_mb=2500", merged, seeds, corpus],
                       env=environment(target, folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        files = sorted((os.path.getsize(e.path), e.name, e.path) for e in os.scandir(merged))
        named = [e.name for e in os.scandir(seeds) if not re.fullmatch("[0-9a-f]{12}", e.name)]
        for entry in list(os.scandir(seeds)):
            if entry.name not in named:
                os.remove(entry.path)
        room = MOST_KEPT.get(target, 60000)
        for size, name, path in files:
            room -= size
            if room < 0:
                break
            shutil.copyfile(path, f"{seeds}/{name[:12]}")
    print(f"{target}: {len(os.listdir(seeds))} seeds")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build-fuzz")
    parser.add_argument("--seconds", type=int, default=60, help="for each target")
    parser.add_argument("--runs", type=int, default=0, help="executions at most of each target")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("target", nargs="*")
    options = parser.parse_args()
    known = targets(options.build)
    for target in options.target:
        if target not in known:
            sys.exit(f"{target}: is no target; expected one of {', '.join(known)}")
    chosen = options.target or known
    if options.keep:
        for target in chosen:
            keep(target, options.build)
        return
    broken = [target for target in chosen if not fuzz(target, options)]
    print(f"{len(chosen) - len(broken)} passed, {len(broken)} failed")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
