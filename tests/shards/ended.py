#!/usr/bin/env python3
# suite
"""Runs that are ended, locked out or out of disk leave whole rows that can be continued; progress on a terminal.

Every expected table is the one a single run writes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import concurrent.futures
import math
import os
import re
import resource
import shlex
import signal
import subprocess
import time

from bench import COMMON, SECONDS, run_checks
from machine import on_terminal


def heed_signals():
    """A shell's background job ignores SIGINT, one under nohup SIGHUP, and what it starts does too."""
    for which in (signal.SIGINT, signal.SIGHUP):
        signal.signal(which, signal.SIG_DFL)


def check_lock(bench):
    """Two runs do not write one file."""
    words = ["classify", COMMON / "square.wkt", COMMON / "move2.json", "-", "--resume", bench.folder / "held.csv"]
    first = subprocess.Popen([bench.graze, *map(str, words)], stdin=subprocess.PIPE)
    first.stdin.write(b"1,1\n")
    first.stdin.flush()
    end = time.monotonic() + SECONDS
    while not (words[-1].exists() and b"\n1,1," in words[-1].read_bytes()) and time.monotonic() < end:
        time.sleep(0.01)
    status, _, err = bench.run(*words, stdin=b"1,1\n")
    bench.check(status == 5 and b"held.csv: another run is writing it" in err, "the second run is refused", status, err)
    first.stdin.close()
    bench.check(first.wait(SECONDS) == 0 and words[-1].read_bytes().endswith(b"\n# complete 1\n"), "the first one ends")


def check_threads(bench):
    """More threads than cores would take turns: there are none, and the table is the same."""
    path = bench.folder / "threads.csv"
    words = ["classify", COMMON / "square.wkt", COMMON / "move2.json", "-", "--jobs", "64", "--output", path]
    run = subprocess.Popen([bench.graze, *map(str, words)], stdin=subprocess.PIPE)
    run.stdin.write(b"1,1\n")
    run.stdin.flush()
    end = time.monotonic() + SECONDS
    while not (path.exists() and b"\n1,1," in path.read_bytes()) and time.monotonic() < end:
        time.sleep(0.01)
    threads = len(os.listdir(f"/proc/{run.pid}/task"))
    bench.check(1 < threads <= os.cpu_count() + 1, "threads of --jobs 64, and the one that reads", threads)
    run.stdin.close()
    bench.check(run.wait(SECONDS) == 0, "the run ends")


def check_signals(bench):
    """A run that is ended in its middle leaves whole rows, and is continued."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json", "--grid", "60,50,40", "--jobs", 2]
    whole = bench.good(*words)
    path = bench.folder / "killed.csv"
    for which in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL):
        path.unlink(missing_ok=True)
        ends, told, longest = 0, 0, 0.2
        for _ in range(40):
            child = subprocess.Popen([bench.graze, *map(str, words), "--resume", path], stderr=subprocess.PIPE,
                                     preexec_fn=heed_signals)
            end = time.monotonic() + bench.random.uniform(0, longest)
            size = path.stat().st_size if path.exists() else 0
            while child.poll() is None and (time.monotonic() < end or not path.exists() or path.stat().st_size <= size):
                time.sleep(0.005)
            child.send_signal(which)
            err = child.communicate(timeout=SECONDS)[1]
            if child.returncode == 0 or path.read_bytes() == whole:
                if ends:
                    break
                path.unlink()  # too late: a new run, and a shorter wait
                longest /= 2
                continue
            ends += 1
            text = path.read_bytes()
            rows = sum(not line.startswith(b"#") for line in text.splitlines()) - 1
            ended = b"" if which == signal.SIGKILL else b"graze: ended by %s\n" % which.name.encode()
            has = (b"graze: %s: has %d whole rows; the same command with --resume FILE continues a table\n"
                   % (os.fsencode(path), rows))
            told += err == has + ended
            bench.check(child.returncode == -which and err in (ended, has + ended),
                        f"{which.name} ends it as the shell sees it, and it says so", child.returncode, err, rows)
            bench.check(which == signal.SIGKILL or text.endswith(b"\n"), f"{which.name} leaves whole rows", text[-80:])
            bench.check(whole.startswith(text), f"{which.name} leaves a beginning of the table")
        bench.check(ends > 0, f"{which.name} came before the end")
        bench.check(told > 0 or which == signal.SIGKILL, f"{which.name}: the number of rows is reported")
        if path.read_bytes() != whole:
            bench.good(*words, "--resume", path)
        bench.check(path.read_bytes() == whole, f"after {which.name} the table is that of one run")


def check_ignored(bench):
    """A signal that is ignored, as under nohup, does not end a run."""
    words = ["classify", COMMON / "cube.off", COMMON / "move3.json", "-", "--output", bench.folder / "nohup.csv"]
    child = subprocess.Popen([bench.graze, *map(str, words)], stdin=subprocess.PIPE, stderr=subprocess.PIPE,
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    child.stdin.write(b"1,1,1\n")
    child.stdin.flush()
    end = time.monotonic() + SECONDS
    while not (words[-1].exists() and b"\n1,1,1," in words[-1].read_bytes()) and time.monotonic() < end:
        time.sleep(0.01)
    child.send_signal(signal.SIGHUP)
    err = child.communicate(b"2,2,2\n", timeout=SECONDS)[1]
    bench.check(child.returncode == 0 and words[-1].read_bytes().endswith(b"\n# complete 2\n"),
                "nohup is heeded", child.returncode, err)


def check_full(bench):
    """Where no more can be written, whole rows stand and can be continued; a limit of the file's size, which is
    met in the middle of a write, stands for the full disk."""
    words = [bench.graze, "classify", str(COMMON / "cube.off"), str(COMMON / "move3.json"), "--grid", "30,20,20"]
    for form in ("csv", "jsonl"):
        whole = subprocess.run([*words, "--format", form], stdout=subprocess.PIPE, check=True).stdout
        for size in (200, 1000, 65536, 65537, 65536 + 4001, len(whole) - 3):
            for how in ("--output", "--resume", ">"):
                if form == "jsonl" and how == "--resume":
                    continue
                path = bench.folder / f"full-{form}-{size}-{how.strip('-')}"
                path.write_bytes(b"")
                with open(path, "wb") as file:
                    done = subprocess.run(
                        [*words, "--format", form, *([] if how == ">" else [how, str(path)])], timeout=SECONDS,
                        stdout=file, stderr=subprocess.PIPE,
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
                text = path.read_bytes()
                row = max(map(len, whole.splitlines())) + 1
                bench.check(done.returncode == 5 and b"writing failed: File too large" in done.stderr,
                            "a write that fails is reported", form, size, how, done.returncode, done.stderr)
                bench.check(whole.startswith(text) and text[-1:] in (b"", b"\n") and size - len(text) <= row,
                            "it leaves whole lines", form, size, how, len(text), text[-80:])
                if how == "--resume":
                    bench.good(*words[1:], "--resume", path)
                    bench.check(path.read_bytes() == whole, "and is continued", size)


def check_progress(bench):
    """Per cent and time left where the end is known; nothing with --quiet."""
    words = [bench.graze, "classify", COMMON / "cube.off", COMMON / "move3.json", "--jobs", "1", "--grid", "90,90,90"]
    start = time.monotonic()
    seen = on_terminal(bench.checks, words, SECONDS)
    if not seen:
        return
    status, shown = seen
    elapsed = time.monotonic() - start
    form = rb"(\d+) rows, (\d+) rows/s, (\d+) %(, \d+:\d\d:\d\d left)?\s*"
    lines = [re.fullmatch(form, line) for line in shown.strip().split(b"\r")]
    bench.check(status == 0 and all(lines), "the form of progress", shown)
    if all(lines):
        rows, parts = [int(m[1]) for m in lines], [int(m[3]) for m in lines]
        bench.check(all(p == r * 100 // 90**3 for r, p in zip(rows, parts)), "per cent are those of the rows", shown)
        # The work takes no longer than the whole run.
        bench.check(int(lines[-1][2]) >= int(90**3 / elapsed), "the rate is that of the clock", elapsed, shown)
        bench.check(len(lines) <= elapsed + 1, "at most a line a second and the last", elapsed, shown)
        bench.check(rows[-1] == 90**3 and lines[-1][4] is None, "the last line is the end", shown)
        bench.check(all(m[4] for m in lines if int(m[1]) < 90**3), "before it there is time left", shown)
    status, shown = on_terminal(bench.checks, words[:-1] + ["20,20,20", "--quiet"], SECONDS)
    bench.check((status, shown) == (0, b""), "--quiet shows nothing", status, shown)


def ring(n, m):
    """A torus of 2 n m triangles, with the decimals of a file from elsewhere."""
    turn, tilt = [[2 * math.pi * k / count for k in range(count)] for count in (n, m)]
    corner = lambda i, j: i % n * m + j % m  # noqa: E731
    rows = [f"{(3 + math.cos(b)) * math.cos(a):.6f} {(3 + math.cos(b)) * math.sin(a):.6f} {math.sin(b):.6f}" for a in turn for b in tilt]
    rows += [f"3 {corner(i, j)} {a} {b}" for i in range(n) for j in range(m)
             for a, b in ((corner(i + 1, j), corner(i + 1, j + 1)), (corner(i + 1, j + 1), corner(i, j + 1)))]
    return "\n".join(["OFF", f"{n * m} {2 * n * m} 0", *rows, ""]).encode()


TURNING = (b'{"dimension": 3, "pieces": [{"t": ["0", "1"], "transform": {"compose": [{"translate": ["4*t^5", "t^2", "t^3"]}, '
           b'{"quaternion": ["1", "t", "t^2-t/3", "t^3-t/7+1/11"]}]}}]}')
THROUGH = TURNING.replace(b"4*t^5", b"9-18*t")  # from one side of the ring at rest to the other
# Each works for seconds at least, with the others beside it for more.
HARD = ("check big.off turn.json", "mend big.off -o mended.off", "convert big.off -o converted.off",
        "classify mid.off turn.json --grid 500,500,500", "certify mid.off turn.json places.csv", "explain big.off turn.json 1 2 3",
        "contact big.off turn.json --snap sites.csv", "collide fine.off through.json fine.off", "envelope mid.off turn.json",
        "boundary mid.off turn.json --depth 9 --surface surface.ply", "judge mid.off turn.json mid.off",
        "generate mid.off turn.json -n 9000000 --seed 1", "draw mid.off turn.json -o page.html",
        "validate mid.off turn.json -n 1000000 --seed 1 --candidate 'cp {points} {out}'")


def check_hard_work(bench):
    """Every command is ended by a signal in the middle of hard work. All work at once; the time that they may take is
    that of a busy machine."""
    places = "".join(f"{k}/7,{k % 11}/3,{k % 13}/5\n" for k in range(300000))
    for name, content in (("big.off", ring(600, 400)), ("mid.off", ring(60, 40)), ("fine.off", ring(160, 100)),
                          ("turn.json", TURNING), ("through.json", THROUGH),
                          ("places.csv", b"x,y,z\n" + places.encode()), ("sites.csv", b"time,x,y,z\n" + b"1/3,4,0,0\n" * 100000)):
        bench.file(name, content)
    runs = [(words, subprocess.Popen([bench.graze, *shlex.split(words)], cwd=bench.folder, stdin=subprocess.DEVNULL,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)) for words in HARD]
    time.sleep(3 * bench.scale)
    for words, child in runs:
        bench.check(child.poll() is None, "it is at work", words, child.returncode)
        child.terminate()
    end = time.monotonic() + 20
    for words, child in runs:
        try:
            child.wait(max(0.1, end - time.monotonic()))
        except subprocess.TimeoutExpired:
            child.kill()
        bench.check(child.wait() == -signal.SIGTERM, "a signal ends it in 20 s", words, child.returncode)


DEAF = b"""#include <unistd.h>
int yajl_parse(void *reader, const unsigned char *text, unsigned long length) {
    (void)reader, (void)text, (void)length;
    for (;;)
        pause();
}
"""


def check_deaf(bench):
    """A signal ends a process that waits for another library's call, which never comes back: ten seconds later. Meanwhile other
    checks run."""
    if bench.sanitizers:
        check_full(bench)
        check_signals(bench)
        return
    bench.file("deaf.c", DEAF)
    library = bench.folder / "deaf.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, bench.folder / "deaf.c"], check=True)
    child = subprocess.Popen([bench.graze, "check", COMMON / "cube.off", COMMON / "move3.json"],
                             env={**os.environ, "LD_PRELOAD": str(library)}, stdout=subprocess.DEVNULL)
    time.sleep(0.5)

    def end():
        start = time.monotonic()
        child.terminate()
        try:
            child.wait(20)
        except subprocess.TimeoutExpired:
            child.kill()
        return child.wait(), time.monotonic() - start

    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        ending = pool.submit(end)
        check_full(bench)
        check_signals(bench)
        status, seconds = ending.result()
    bench.check(status == -signal.SIGTERM, "it ends", status)
    bench.check(seconds > 5, "it had a moment to end", seconds)


if __name__ == "__main__":
    run_checks(__doc__, [check_lock, check_threads, check_ignored, check_progress, check_hard_work, check_deaf])
