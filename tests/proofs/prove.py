#!/usr/bin/env python3
"""Compiles the proofs, and checks that they prove what they are said to prove.

No proof is left out and no axiom added: no such word stands in the sources; coqchk reads our compiled
files again with its own kernel, and names as axioms the standard library's alone. The statements of the
main theorems and the axioms of each, as Coq prints them, are those recorded in
proofs/coq/statements.txt (with --record they are written there, to be read before they are committed).
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import difflib
import os
import re
import time

from coq import OPTIONS, SOURCE, Checks, compile_file, copy, order, run, sources, without_comments

RECORD = os.path.join(SOURCE, "statements.txt")
FORBIDDEN = re.compile(r"\b(Admitted|admit|Axioms?|Conjecture|Parameters?|Abort|Declare\s+Module|bypass_check|"
                       r"Unset\s+(Guard|Positivity|Universe)\s+Checking|Type\s+in\s+Type)\b")
# The axioms of the standard library: its real numbers, and classical logic.
AXIOMS = {"ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec",
          "FunctionalExtensionality.functional_extensionality_dep", "Classical_Prop.classic"}


def check_sources(checks):
    for name in sources():
        with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
            text = file.read()
        checks.holds(text.startswith("(*") and "SPDX-License-" "Identifier: GPL-3.0-or-later" in text[:400],
                     f"{name}: expected a head that says what the file proves, and the licence")
        checks.holds(text.count("\n") <= 600, f"{name}: more than 600 lines")
        code, depth = without_comments(text), 0
        for number, line in enumerate(code.split("\n"), 1):
            found = FORBIDDEN.search(line)
            checks.holds(not found, f"{name}, line {number}: {found and found.group()}")
            depth += bool(re.match(r"\s*Section\b", line)) - bool(re.match(r"\s*End\b", line))
            # Outside a section these are axioms.
            loose = re.match(r"\s*(Variables?|Hypothes[ie]s|Context)\b", line)
            checks.holds(not loose or depth > 0, f"{name}, line {number}: {line.strip()} in no section")


def check_compiles(checks, folder):
    log = {}
    for name in order(folder):
        start = time.time()
        done = compile_file(folder, name)
        log[name] = done.stdout
        ok = checks.holds(done.returncode == 0, f"{name}: {done.stderr}")
        print(f"  COQ  {name} ({time.time() - start:.1f} s)", flush=True)
        if not ok:
            checks.finish()
    return log


def check_kernel(checks, folder):
    modules = ["Graze." + name[:-2] for name in sources()]
    done = run(folder, "coqchk", "-o", "-silent", *OPTIONS, *[a for m in modules for a in ("-norec", m)])
    if not checks.holds(done.returncode == 0, f"coqchk: {done.stdout}{done.stderr}"):
        return
    summary = done.stdout + done.stderr
    print(summary.strip())
    parts = dict(re.findall(r"^\* ([^\n]*?):(.*?)(?=^\* |\Z)", summary, re.M | re.S))
    axioms = set(parts.get("Axioms", "").split())
    checks.holds("Axioms" in parts and axioms, "coqchk: expected a list of axioms")
    for axiom in sorted(axioms):
        checks.holds(not axiom.startswith("Graze."), f"coqchk: an axiom of ours: {axiom}")
    for title, text in parts.items():
        if title != "Axioms" and not title.startswith("Theory"):
            checks.holds(text.strip() == "<none>", f"coqchk: {title}: {text.strip()}")


def axioms_printed(text):
    """The names printed after `Axioms:`, up to the next name that statements.v asks for."""
    with open(os.path.join(SOURCE, "statements.v"), encoding="utf-8") as file:
        asked = set(re.findall(r"^(?:Check|Print) (\w+)\.", file.read(), re.M))
    found, inside = set(), False
    for line in text.split("\n"):
        name = re.match(r"[\w.]+", line)
        if line == "Axioms:":
            inside = True
        elif line.startswith("Closed under") or (name and name.group() in asked):
            inside = False
        elif inside and name:
            found.add(name.group())
    return found


def check_statements(checks, text, record):
    """The log of statements.v against the record, and its axioms against those allowed."""
    if record:
        with open(RECORD, "w", encoding="utf-8") as file:
            file.write(text)
    with open(RECORD, encoding="utf-8") as file:
        recorded = file.read()
    same = text.split() == recorded.split()
    checks.holds(same, "statements.v prints something else than statements.txt:\n" + "\n".join(
        difflib.unified_diff(recorded.split("\n"), text.split("\n"), "statements.txt", "printed", lineterm="")))
    found = axioms_printed(text)
    checks.holds(found, "no axiom of the library's real numbers is printed")
    for axiom in sorted(found):
        checks.holds(axiom in AXIOMS, f"an axiom that is not the library's: {axiom}")
    checks.holds(text.count("Closed under the global context") > 0, "no theorem without axioms")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", default="build")
    parser.add_argument("--record", action="store_true")
    args = parser.parse_args()
    checks = Checks()
    start = time.time()
    folder = os.path.join(args.build, "proofs")
    check_sources(checks)
    copy(folder)
    log = check_compiles(checks, folder)
    print(log["statements.v"])
    check_statements(checks, log["statements.v"], args.record)
    check_kernel(checks, folder)
    print(f"proofs: {time.time() - start:.0f} s")
    checks.finish()


if __name__ == "__main__":
    main()
