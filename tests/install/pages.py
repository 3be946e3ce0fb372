"""--help, man pages and completion name the same commands, options and functions.

SPDX-License-Identifier: GPL-3.0-or-later

Which commands and options there are is asked in two ways: from the texts of --help, and from what the program
accepts.
"""
import glob
import os
import re

from programs import ROOT, check, output, read, run, same


def commands_of(graze):
    """The commands, from the complaint about one that is none."""
    complaint = run([graze, "nothing"])[1]
    return re.split(r", | or ", re.search(r"expected a command: (.*)\n", complaint)[1])


def accepted(graze, command, folder):
    """{option: words it takes, or None} by the complaints about each option of the program."""
    tables = {path: set(re.findall(r'\b(OPTION|FLAG|REPEATED|FILE_READ|FILE_WRITTEN)\("([a-z-]{2,})"', read(path))) for path in glob.glob("src/program/cli/*.c")}
    for path, found in tables.items():
        found |= {("FLAG", name) for name in re.findall(r'\{"([a-z-]{2,})", OPTION_MAYBE', read(path))}  # with a value or without
    own = {name for kind, name in tables[f"src/program/cli/{command}.c"]}
    names = set().union({("FLAG", "help")}, *tables.values())
    check(len(names) > 20 and own, f"long options of the program: {names}")
    found = {}
    for kind, name in sorted(names):
        if name not in own and any(longer.startswith(name) for longer in own):  # taken for the longer one
            continue
        complaint = run([graze, command, f"--{name}" + ("" if kind == "FLAG" else "=zzz")], folder)[1]
        if "has no such option" in complaint:
            continue
        words = re.search(r"zzz: expected ([a-z0-9]+(?:(?:, | or )[a-z0-9]+)*)\n", complaint)
        found["--" + name] = set(re.split(r", | or ", words[1])) if words else None
    return found


def check_help(graze, commands):
    """Every help fits a screen and begins with its usage, in a line, and examples; tests/readme/readme.py types these."""
    for words in [[graze], [graze + "-check"]] + [[graze, command] for command in commands]:
        lines = output([*words, "--help"]).splitlines()
        check(len(lines) <= 40 and max(map(len, lines)) <= 100, f"help of {words}: {len(lines)} lines")
        check(lines[1] == "" and lines[2].startswith("Example: graze"), f"help of {words}: its second paragraph is {lines[2]}")


def check_completion(graze, script, commands, folder):
    def complete(*words):
        code = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _graze; printf "%s\\n" "${COMPREPLY[@]}"'
        return set(output(["bash", "--norc", "-c", code, "bash", script, *words], folder).split())

    same(complete(graze, ""), set(commands) | {"--help", "--version"}, "completion of commands")
    same(complete(graze, "cl"), {"classify"}, "completion of cl")
    for command in commands:
        options = accepted(graze, command, folder)
        same(complete(graze, command, "--"), set(options), f"completion of options of {command}")
        for option, words in options.items():
            if words is not None:
                offered = complete(graze, command, option, "")
                check(offered and offered <= words, f"{command} {option}: {offered} of {words}")
    check("-n" in complete(graze, "generate", "-"), "completion of -n")
    same(complete(graze, "classify", "--overlap", ""), {"extend", "reject"}, "words of --overlap")
    same(complete(graze, "validate", "--round", "="), {"none", "binary64", "binary32"}, "words of --round=")
    same(complete(graze, "explain", "--round", "=", "bin"), {"binary64", "binary32"}, "words of --round=bin")
    same(complete(graze, "motion", ""), {"line", "rotate", "screw", "joints", "poses", "gcode", "dyadic"}, "kinds of graze motion")
    same(complete(graze, "classify", ""), set(), "classify has no kinds")
    same(complete(graze, "classify", "--output", "x"), set(), "file names are left to the shell")
    registered = output(["bash", "--norc", "-c", f"source '{script}'; complete -p graze"])
    check("_graze" in registered and "default" in registered, f"registered as {registered}")


def rendered(page):
    """The page as plain text without hyphenation; the formatter must have nothing to say."""
    text, complaint, status = run(["groff", "-ww", "-K", "utf8", "-man", "-Tascii", "-rHY=0", "-P-cbou", page])
    check(status == 0 and complaint == "", f"{page}: {complaint}")
    return text


def check_pages(graze, folder, commands):
    pages = {name for section in ("man1", "man3", "man5") for name in os.listdir(os.path.join(folder, section))}
    same(pages, {"graze.1", "graze.3", "graze-motion.5"} | {f"graze-{command}.1" for command in commands}, "man pages")
    for command in [None] + commands:
        page = rendered(os.path.join(folder, "man1", f"graze-{command}.1" if command else "graze.1"))
        text = output([graze, command, "--help"] if command else [graze, "--help"])
        words = set(page.split())
        for heading in ("NAME", "SYNOPSIS", "EXIT STATUS", "SEE ALSO") + (("OPTIONS", "EXAMPLE") if command else ()):
            check(re.search(f"^{heading}$", page, re.M), f"{command}: no {heading}")
        if command == "check":  # the page of the program graze-check, and of the command
            check(0 < page.find("graze-check SOLID MOTION CERTIFICATE") < page.find("graze check SOLID [MOTION]"), "graze-check(1) is not the program's first")
            text += "".join(output([graze + "-check", "--help"]).splitlines(keepends=True)[1:])
        for line in text.splitlines()[1:]:
            line = re.sub("^(Example|Exit status):", "", line)
            lost = [word for word in line.split() if word not in words]
            check(not lost, f"man page of {command} lacks {lost}")
    for page in ("man1/graze.1", "man3/graze.3"):
        check("glossary.md" in rendered(os.path.join(folder, page)), f"{page} names the glossary")
    check_format(rendered(os.path.join(folder, "man5", "graze-motion.5")))
    check_header(rendered(os.path.join(folder, "man3", "graze.3")))


def check_format(page):
    """graze-motion(5) has every example of a motion file, and the names of its keys."""
    examples = re.findall(r"```json\n(.*?)```", read("src", "program", "cli", "formats.md"), re.S)
    check(len(examples) >= 10, "examples of formats.md")
    lines = {line.strip() for line in page.splitlines()}
    for line in "".join(examples).splitlines():
        check(line.strip() in lines, f"graze-motion(5) lacks {line}")
    words = set(re.findall(r"\w+", page))
    for key in "translate rotate turn quaternion scale matrix compose keyframes relative sequence timestamp qw".split():
        check(key in words, f"graze-motion(5) lacks {key}")


def headers():
    """The text of graze.h and of its parts."""
    return read("include", "graze.h") + "".join(read("include", "graze", name)
                                                for name in sorted(os.listdir(os.path.join(ROOT, "include", "graze"))) if name.endswith(".h"))


def check_header(page):
    """graze(3) has every function, type and value of the headers, and all words of their comments."""
    header = headers()
    functions = public_functions()
    check(len(functions) > 50, f"{len(functions)} functions in the headers")
    words = set(re.findall(r"\w+", page))
    for name in functions | set(re.findall(r"\bGRAZE_[A-Z0-9_]+ =", header)):
        check(name.split()[0] in words, f"graze(3) lacks {name}")
    # The page has the first lines of graze.h as its name, and the headings there in capitals.
    header = re.sub(r"/\*\* @file\n.*\n.*SPDX.*\n", "/**\n", header, count=1)
    header = re.sub(r"^ \* (Example|Rules of use)$", lambda heading: heading[0].upper(), header, flags=re.M)
    for comment in re.findall(r"/\*\*(?!<)(.*?)\*/", header, re.S):
        lost = set(re.findall(r"\w+", re.sub(r"@(param(\[out\])?|return)", "", comment))) - words
        check(not lost, f"graze(3) lacks {lost} of the comment {comment[:60]!r}")


def public_functions():
    """The functions that the headers declare."""
    header = re.sub(r"/\*.*?\*/", "", headers(), flags=re.S)
    return set(re.findall(r"^GRAZE_API[^;{]*?\b(graze_\w+)\(", header, re.M))


def check_all(graze, root, folder):
    """Everything here, of a program and of the pages and the completion installed under `root`."""
    commands = commands_of(graze)
    check(len(commands) >= 7, f"commands: {commands}")
    check_help(graze, commands)
    check_pages(graze, os.path.join(root, "share", "man"), commands)
    check_completion(graze, os.path.join(root, "share", "bash-completion", "completions", "graze"), commands, folder)
