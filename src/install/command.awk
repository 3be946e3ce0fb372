# A man page of section 1 from the text that --help prints. SPDX-License-Identifier: GPL-3.0-or-later
#
#   awk -v version=V [-v command=NAME [-v program=1]] -f roff.awk -f command.awk OVERVIEW [HELP]
#
# OVERVIEW is what `graze --help` prints. With a command its HELP follows; the one line about it and the exit
# status are taken from the overview, the rest from HELP. Without, the page is the overview itself.
# HELP of a program of its own, graze-NAME, has both itself.
# In a help text a line `  TAG   text` describes TAG, deeper lines go on with it, a blank line ends it.
# `Example: ` begins lines of examples, up to a blank line: they stand in a section of their own near the end.

# The line without its indentation, cut at the first wide gap: sets `tag` and `rest`.
function cut(line) {
    sub(/^ +/, "", line)
    tag = line
    rest = ""
    if (match(line, /   *[^ ]/)) {
        tag = substr(line, 1, RSTART - 1)
        rest = substr(line, RSTART + RLENGTH - 1)
    }
}

function section(name) {
    if (name == current)
        return
    block("")
    print ".SH " name
    current = name
}

function paragraph(line) {
    if (fresh && open == "")
        print ".PP"
    fresh = 0
    print roff(line)
}

# One line of either text. `pending` holds a tag whose description begins in a later line.
function body(line, tagged) {
    if (line == "") {
        example = 0
        fresh = 1
        block("")
        return
    }
    if (example || line ~ /^Example: /) {
        example = 1
        examples = examples roff(substr(line, 10)) "\n"
        return
    }
    if (sub(/^Exit status: /, "", line))
        section("EXIT STATUS")
    if (line ~ /^  [^ ]/ && (tagged != "OPTIONS" || line ~ /^  -/)) {
        cut(line)
        tag = pending tag
        pending = ""
        section(tagged)
        if (rest == "" && tag ~ /,$/) {
            pending = tag " "
        } else {
            print ".TP\n.B " roff(tag)
            print rest == "" ? "\\&" : roff(rest)
        }
    } else if (line ~ /^   /) {
        sub(/^ +/, "", line)
        print roff(line)
    } else {
        if (current == tagged)
            section("NOTES")
        paragraph(line)
    }
}

BEGIN { fresh = 0 }

# The overview.
NR == 1 {
    title = $0
    sub(/^graze: /, "", title)
}
/^  graze [a-z]/ && NR == FNR {
    cut($0)
    split(tag, words, " ")
    names[++count] = words[2]
    about[words[2]] = rest
}
/^Exit status: / && NR == FNR { status = 1 }
status && NR == FNR {
    line = $0
    sub(/^Exit status: /, "", line)
    exits = exits roff(line) "\n"
}
NR == FNR && command == "" {
    if (NR == 1) {
        head("graze", 1, title)
        print ".SH SYNOPSIS\n.B graze\n.I COMMAND\n[options] [operands]"
    } else
        body($0, "COMMANDS")
}

# The help of a command.
NR != FNR && FNR == 1 {
    usage = title = $0
    if (!sub(/: .*/, "", usage) && about[command] == "")
        exit 1
    sub(/^[^:]*: /, "", title)
    head("graze-" command, 1, program ? title : about[command])
    print ".SH SYNOPSIS\n.B " roff(usage) "\n[options]"
    section("DESCRIPTION")
}
NR != FNR && FNR > 1 { body($0, "OPTIONS") }

END {
    if (examples != "") {
        section("EXAMPLE")
        block("nofill")
        printf "%s", examples
        block("")
    }
    if (command != "" && !program)
        printf ".SH EXIT STATUS\n%s", exits
    print ".SH SEE ALSO"
    if (command != "")
        print ".BR graze (1),"
    for (k = 1; k <= count; k++)
        if (names[k] != command)
            print ".BR graze\\-" names[k] " (1),"
    print ".BR graze (3)"
    print ".PP\nThe terms are defined in glossary.md, which is installed beside README.md."
}
