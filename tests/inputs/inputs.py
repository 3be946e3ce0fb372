#!/usr/bin/env python3
# suite
"""Where input comes from: devices and directories are refused by name, also behind a link; FIFOs, process substitution
and /dev/stdin are read like files, `bytes` limits them, and a signal ends the wait for them.

What comes through a pipe must give the bytes that the same file gives. SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import pathlib
import shlex
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "lib"))

from harness import Checks, options, run  # noqa: E402

COMMON = pathlib.Path(__file__).resolve().parents[1] / "refuse" / "common"
SECONDS = 60
PROMPT = 5      # seconds in which what need not be read is refused, and a signal ends a wait
POSES = b"t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,8,0,0,0,0,0,1\n"


class Bench:
    def __init__(self, graze, folder):
        self.graze, self.folder = graze, pathlib.Path(folder)
        self.checks = Checks()

    def check(self, holds, what, *seen):
        self.checks.holds(holds, what, *(repr(s)[:600] for s in seen))

    def start(self, words, **more):
        return subprocess.Popen([self.graze, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                **{"stdin": subprocess.DEVNULL, **more})

    def run(self, words, **more):
        """(exit status, standard output, standard error, seconds) of graze; status None: it had to be killed."""
        begin = time.monotonic()
        child = self.start(words, **more)
        try:
            out, err = child.communicate(timeout=SECONDS)
            return child.returncode, out, err, time.monotonic() - begin
        except subprocess.TimeoutExpired:
            child.kill()
            out, err = child.communicate()
            return None, out, err, SECONDS


def inputs(bench):
    """(name of the input, its file, the words of a command with None in its place)."""
    solid, motion, points = COMMON / "cube.off", COMMON / "move3.json", bench.folder / "points.csv"
    points.write_bytes(b"x,y,z,note\n" + b"".join(b"%d/3,1,%d,n%d\n" % (k, k % 3, k) for k in range(3000)))
    marks = bench.folder / "marks.csv"
    marks.write_bytes(b"1,1,1\n2,1,1/2\n")
    table, poses, receipt = (bench.folder / name for name in ("table.csv", "poses.csv", "receipt.txt"))
    table.write_bytes(bench.run(["classify", solid, motion, points])[1])
    poses.write_bytes(POSES)
    bench.run(["check", "--receipt", receipt, solid, motion])
    yield "a solid", solid, ["classify", None, motion, points]
    yield "a motion", motion, ["classify", solid, None, points]
    yield "points", points, ["classify", solid, motion, None]
    yield "a receipt", receipt, ["classify", "--receipt", None, solid, motion, points]
    yield "marks", marks, ["draw", solid, motion, None, "-o", bench.folder / "picture.svg"]
    yield "a golden table", table, ["compare", None, table]
    yield "a candidate's table", table, ["compare", table, None]
    yield "poses", poses, ["motion", "poses", None]


def put(words, path):
    return [path if word is None else word for word in words]


def check_devices(bench, name, file, words):
    """Links to devices and directories are refused at once and named."""
    for target, kind in (("/dev/zero", b"device"), ("/dev/null", b"device"), (bench.folder, b"directory")):
        link = bench.folder / ("link" + file.suffix)
        link.symlink_to(target)
        status, _, err, seconds = bench.run(put(words, link))
        says = b"%s: is a %s; expected a file or a pipe\n" % (os.fsencode(link), kind)
        bench.check(status == 5 and err == b"graze: " + says and seconds < PROMPT,
                    f"{name}: a link to {target} is refused", status, err, seconds)
        link.unlink()


def feed(path, content):
    """Write into a FIFO in two parts, the second a little later."""
    with open(path, "wb", buffering=0) as fifo:
        fifo.write(content[:len(content) // 2])
        time.sleep(0.2)
        fifo.write(content[len(content) // 2:])


def check_pipes(bench, name, file, words):
    """A FIFO whose writer comes late, process substitution and /dev/stdin give what the file gives."""
    status, whole, told, _ = bench.run(put(words, file))
    bench.check(status == 0, f"{name}: the file is read", status, told)
    same = lambda out, path: out.replace(os.fsencode(path), os.fsencode(file)) == whole
    fifo = bench.folder / ("fifo" + file.suffix)
    os.mkfifo(fifo)
    writer = threading.Timer(0.2, feed, (fifo, file.read_bytes()))
    writer.daemon = True
    writer.start()
    status, out, err, _ = bench.run(put(words, fifo))
    bench.check(status == 0 and same(out, fifo), f"{name}: a FIFO is read", status, err)
    fifo.unlink()
    if name == "a solid":  # told by its extension, which no descriptor has
        return
    line = " ".join("<(cat %s)" % shlex.quote(str(file)) if w is None else shlex.quote(str(w)) for w in words)
    done = run(["bash", "-c", f"{shlex.quote(bench.graze)} {line}"], SECONDS, text=False)
    bench.check(done.returncode == 0 and (name in ("a golden table", "a candidate's table") or done.stdout == whole),
                f"{name}: process substitution is read", done.returncode, done.stderr)
    with open(file, "rb") as held:
        status, out, err, _ = bench.run(put(words, "/dev/stdin"), stdin=held)
    bench.check(status == 0 and same(out, "/dev/stdin"), f"{name}: /dev/stdin that is a file", status, err)
    cat = subprocess.Popen(["cat", file], stdout=subprocess.PIPE)
    status, out, err, _ = bench.run(put(words, "/dev/stdin"), stdin=cat.stdout)
    cat.stdout.close()
    cat.wait()
    bench.check(status == 0 and same(out, "/dev/stdin"), f"{name}: /dev/stdin that is a pipe", status, err)


def check_waits(bench, name, file, words):
    """A signal ends the wait for a FIFO that is not opened, and for one that is not written into."""
    fifo = bench.folder / ("silent" + file.suffix)
    os.mkfifo(fifo)
    for held in (False, True):
        child = bench.start(put(words, fifo))
        end = os.open(fifo, os.O_RDWR) if held else -1
        time.sleep(0.5)
        bench.check(child.poll() is None, f"{name}: a FIFO is waited for", child.returncode)
        begin = time.monotonic()
        child.send_signal(signal.SIGTERM)
        try:
            child.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            child.kill()
            child.communicate()
        seconds = time.monotonic() - begin
        bench.check(child.returncode == -signal.SIGTERM and seconds < PROMPT,
                    f"{name}: SIGTERM ends the wait, writer: {held}", child.returncode, seconds)
        if held:
            os.close(end)
    fifo.unlink()


def flood(path):
    try:
        with open(path, "wb", buffering=0) as fifo:
            while True:
                fifo.write(bytes(65536))
    except BrokenPipeError:
        pass


def check_bytes(bench, name, file, words):
    """`bytes` limits what comes out of a FIFO that does not end."""
    fifo = bench.folder / ("endless" + file.suffix)
    os.mkfifo(fifo)
    threading.Thread(target=flood, args=(fifo,), daemon=True).start()
    words = words + ["--limit", "bytes=1000000"]
    status, _, err, _ = bench.run(put(words, fifo))
    says = b"%s: more than the limit bytes=1000000 allows" % os.fsencode(fifo)
    bench.check(status == 6 and says in err, f"{name}: bytes limits a FIFO", status, err)
    fifo.unlink()


def check_parts(bench):
    """The parts of merge are plain files, and others are refused without being opened."""
    fifo = bench.folder / "part.csv"
    os.mkfifo(fifo)
    for path in ("/dev/zero", fifo, bench.folder):
        status, _, err, seconds = bench.run(["merge", path])
        bench.check(status == 5 and b"expected a plain file; parts are read in turn" in err and seconds < PROMPT,
                    f"merge refuses {path}", status, err, seconds)
    fifo.unlink()


def check_standard_input(bench):
    """`-` stays what it is: also a device, where a person types or nothing is to come."""
    status, out, err, _ = bench.run(["classify", COMMON / "cube.off", COMMON / "move3.json", "-"])
    bench.check(status == 0 and out.endswith(b"# complete 0\n"), "standard input may be /dev/null", status, err)


def main():
    graze = options(__doc__).graze
    with tempfile.TemporaryDirectory(prefix="graze-inputs-") as folder:
        bench = Bench(graze, folder)
        for one in inputs(bench):
            check_devices(bench, *one)
            check_pipes(bench, *one)
            check_waits(bench, *one)
            if one[0] in ("a solid", "a motion", "poses"):
                check_bytes(bench, *one)
        check_parts(bench)
        check_standard_input(bench)
    bench.checks.finish()


if __name__ == "__main__":
    main()
