"""Every comparison that graze-check makes is needed: dropped, or turned, it lets something bad pass, or refuses
something good.

SPDX-License-Identifier: GPL-3.0-or-later

Records the calls of graze-check that the suites of this folder make, then builds mutants of src/check, one at a
time: a condition in front of a refusal dropped; == and != exchanged, an order loosened, tightened or negated, && and
|| exchanged, outside the heads of loops. Each must end some recorded call otherwise, note other columns, or crash or
hang, unless weakened.txt has a line FILE | MUTANT | REASON for it; a line of no mutant is a failure too. For each message of
refusal --scale times EACH calls are kept. Not touched: main.c, whose calls are a command line's, ends.c, sha256.c. Run from
the top of the repository;
--only A,B narrows to some files. CI asks the files that follow a row, the motion's, and those of the legal
solid; the others, which read files, are asked by hand.
"""
import collections
import concurrent.futures
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

import lib_certificate  # noqa: F401  (sets the path)
from harness import ONLY, Checks, options

HERE = os.path.dirname(os.path.abspath(__file__))
SPARED = ("main.c", "ends.c", "sha256.c")
EACH = 60
SUITES = ("rows.py", "solids.py", "limits.py", "golden.py", "contacts.py", "mutants.py")  # the first calls of a message are taken
FLAGS = ["-std=c11", "-D_POSIX_C_SOURCE=200809L", "-O1", "-w", "-Dfree=checker_free", "-Dfopen=checker_fopen",
         "-Dfclose=checker_fclose"]
TURNED = {"==": ["!="], "!=": ["=="], "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"],
          "&&": ["||"], "||": ["&&"]}
OPERATOR = re.compile(r"(?<![-<>=!&|])(==|!=|<=|>=|<|>|&&|\|\|)(?![<>=&|])")
REFUSAL = re.compile(r"\b(refute|give_up|fail|source_fail|differs)\(")


def record(folder, graze):
    """The calls that the suites make, as lines for battery.c: some of each message."""
    def ask(k):
        calls = os.path.join(folder, "calls", str(k))
        os.makedirs(calls)
        subprocess.run([sys.executable, os.path.join(HERE, SUITES[k]), "--graze", graze],
                       env=dict(os.environ, GRAZE_CHECK_RECORD=calls), stdout=subprocess.DEVNULL)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(ask, reversed(range(len(SUITES)))))  # the long ones stand last
    by_message = collections.defaultdict(list)
    for path in sorted(glob.glob(os.path.join(folder, "calls", "*", "*", "call.json"))):
        with open(path, encoding="utf-8") as file:
            call = json.load(file)
        words = [w for w in call["words"] if w != "--assume-legal"]
        files = [os.path.join(os.path.dirname(path), w) for w in words]
        if len(files) in (3, 4) and all(map(os.path.isfile, files)):
            message = re.sub(r"\S*/\S*|[-\d.]+|'.*?'", "", call["error"])
            assume = int("--assume-legal" in call["words"])
            note = 0 if call["status"] else len(call["error"].encode())
            by_message[(call["status"], message)].append(
                f"{call['status']} {assume} {note} {' '.join(files[:3])} {files[3] if len(files) == 4 else '-'}")
    return by_message


def chosen(by_message, each):
    """Lines, one of each message first; of those verified more."""
    out = []
    for k in range(10 * each):
        out += [lines[k] for (status, _), lines in sorted(by_message.items())
                if k < len(lines) and (k < each or status == 0)]
    return "\n".join(out) + "\n"


def code_of(line):
    """The line without strings, characters and comments, which become blanks."""
    return re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|/\*.*?\*/|//.*', lambda m: " " * len(m[0]), line)


def conditions(text):
    """Where `if (...)` stands in front of a refusal: begin and end of the condition."""
    for at in re.finditer(r"\bif \(", text):
        depth, end = 1, at.end()
        while depth:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        if REFUSAL.match(text[end:].lstrip(" \n{")):
            yield at.end(), end - 1


def mutants(text):
    """(what, mutated text): what names it, a line's text and the change."""
    for begin, end in conditions(text):
        condition = " ".join(text[begin:end].split())
        yield f"dropped: {condition}", text[:begin] + "0" + text[end:]
    at, comment = 0, False
    for line in text.splitlines(keepends=True):
        code = code_of(line)
        inside = comment or code.lstrip().startswith(("/*", "#"))
        comment = (comment or "/*" in code) and "*/" not in line
        for found in OPERATOR.finditer(code):
            if inside or code.lstrip().startswith(("for ", "} while", "while ")) and found[1] not in ("&&", "||"):
                continue
            for other in TURNED[found[1]]:
                changed = line[:found.start()] + other + line[found.end():]
                yield f"turned: {' '.join(changed.split())}", text[:at] + changed + text[at + len(line):]
        at += len(line)


def equivalents():
    """(file, what) -> reason."""
    out = {}
    with open(os.path.join(HERE, "weakened.txt"), encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                name, what, reason = line.rstrip("\n").split(" | ")
                out[name, what] = reason
    return out


class Bench:
    """All objects built once; a mutant's own is built beside them."""

    def __init__(self, folder, lines):
        self.folder, self.lines = folder, lines
        self.sources = [p for p in sorted(glob.glob("src/check/*.c")) if os.path.basename(p) not in SPARED[:2]]
        extra = ["-std=c11", "-O1", "-w", "-c"]
        for path in self.sources:
            subprocess.run(["cc", *FLAGS, "-c", path, "-o", self.object(path)], check=True)
        for path in ("tests/fuzz/checker/inside.c", os.path.join(HERE, "battery.c")):
            subprocess.run(["cc", *extra, path, "-o", self.object(path)], check=True)
        self.objects = {p: self.object(p) for p in [*self.sources, "inside.c", "battery.c"]}

    def object(self, path):
        return os.path.join(self.folder, os.path.basename(path)[:-2] + ".o")

    def judge(self, number, path, text):
        """The effect of a mutated file: a word and a call, or "" if it has none."""
        place = os.path.join(self.folder, f"mutant{number}")
        source, made, program = place + ".c", place + ".o", place
        with open(source, "w", encoding="utf-8") as file:
            file.write(text)
        others = [o for p, o in self.objects.items() if p != path]
        built = subprocess.run(["cc", *FLAGS, "-Isrc/check", "-c", source, "-o", made], stderr=subprocess.DEVNULL)
        if built.returncode != 0:
            return "unbuilt"
        if path and subprocess.run(["cmp", "-s", made, self.object(path)]).returncode == 0:
            return "same object"
        subprocess.run(["cc", made, *others, "-o", program, "-lgmp", "-lm"], check=True)
        try:
            done = subprocess.run(["bash", "-c", "ulimit -v 4000000; exec " + program], input=self.lines, timeout=120, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, text=True)
            out = done.stdout.strip() if done.returncode == 0 else f"crashes {done.returncode}"
        except subprocess.TimeoutExpired:
            out = "hangs"
        for rest in (source, made, program):
            os.remove(rest)
        return out


def main():
    wanted, tally = options(__doc__, ONLY), Checks()
    known, counts = equivalents(), collections.Counter()
    base = "/dev/shm" if os.path.isdir("/dev/shm") else None
    with tempfile.TemporaryDirectory(dir=base) as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        lines = chosen(record(folder, os.path.abspath(wanted.graze)), int(EACH * wanted.scale))
        bench = Bench(folder, lines)
        print(f"{len(lines.splitlines())} calls", flush=True)
        with open(bench.sources[0], encoding="utf-8") as file:
            tally.equal(bench.judge(0, bench.sources[0], file.read() + "\nint unchanged;\n"), "",
                        "the checker as it is ends each call as recorded")
        jobs = []
        for path in bench.sources:
            name = os.path.basename(path)
            if name in SPARED or not any(part in name for part in wanted.only.split(",")):
                continue
            with open(path, encoding="utf-8") as file:
                text = file.read()
            made = list(mutants(text))
            jobs += [(len(jobs) + k + 1, path, what, mutant) for k, (what, mutant) in enumerate(made)]
            for what in {what for file, what in known if file == name} - {what for what, _ in made}:
                tally.fail("weakened.txt has a line of no mutant", name, what)
        results = pool.map(lambda job: (job, bench.judge(job[0], job[1], job[3])), jobs)
        for (_, path, what, _), result in results:
            name = os.path.basename(path)
            kind = result.split()[0] if result else "unnoticed"
            counts[kind] += 1
            listed = (name, what) in known
            if kind in ("unnoticed",):
                tally.holds(listed, "nothing notices", name, what)
                print(f"{'equivalent' if listed else 'UNNOTICED'} | {name} | {what}", flush=True)
            elif kind not in ("unbuilt", "same"):
                if kind in ("crashes", "hangs"):  # what reads past an array may not do so elsewhere: another call should notice it
                    print(f"{result} | {name} | {what}", flush=True)
                tally.holds(not listed, "weakened.txt calls it equivalent", name, what, result)
        print(", ".join(f"{count} {kind}" for kind, count in sorted(counts.items())))
    tally.finish()


if __name__ == "__main__":
    main()
