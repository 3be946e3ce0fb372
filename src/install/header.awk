# The man page graze(3) from the public headers. SPDX-License-Identifier: GPL-3.0-or-later
#
#   awk -v version=V -f roff.awk -f header.awk include/graze.h include/graze/core.h ...
#
# The comment at the head of graze.h is the introduction, that of another file opens a section, and so does a
# line of dashes with a name; every declaration is shown with the comment before it.

# The text of a comment line.
function inner(line) {
    sub(/ *\*\/ *$/, "", line)
    sub(/^ *\/\*+ */, "", line)
    sub(/^ *\* ?/, "", line)
    return line
}

function intro(line) {
    if (line ~ /SPDX|^@file/)
        return
    if (!named) {
        sub(/^graze\.h - /, "", line)
        sub(/: .*/, "", line)
        head("graze", 3, line)
        print ".SH SYNOPSIS\n.nf\n.B #include <graze.h>\n.PP"
        print "cc \\-std=c11 program.c $(pkg\\-config \\-\\-cflags \\-\\-libs graze)\n.fi\n.SH DESCRIPTION"
        named = 1
    } else if (line == "") {
        print ".PP"
    } else if (line == "Rules of use" || line == "Example") {
        print ".SH " toupper(line)
        code = line == "Example"
    } else if (code && match(line, /^    /)) {
        print ".nf\n" roff(substr(line, RLENGTH + 1)) "\n.fi"
    } else if (match(line, /^ *[0-9]+\. /)) {
        print ".TP 4\n" substr(line, RSTART, RLENGTH) "\n" roff(substr(line, RLENGTH + 1))
    } else {
        sub(/^ +/, "", line)
        print roff(line)
    }
}

# The head of a part: its file and subject are the section's name.
function section(line) {
    if (line ~ /SPDX/)
        return
    if (line ~ /^graze\/.* - /) {
        sub(/\.$/, "", line)
        print ".SH <" substr(line, 1, index(line, " ") - 1) ">\n" roff(substr(line, index(line, " - ") + 3)) "."
    } else if (line == "") {
        print ".PP"
    } else {
        print roff(line)
    }
}

# A line of a comment before a declaration, kept until the declaration is known.
function note(line) {
    sub(/^ +/, "", line)
    if (line == "")
        return
    if (match(line, /^@param(\[out\])? +[a-z_0-9]+(, [a-z_0-9]+)* */)) {
        tag = substr(line, 1, RLENGTH)
        line = substr(line, RLENGTH + 1)
        sub(/^@param(\[out\])? +/, "", tag)
        sub(/ +$/, "", tag)
        notes = notes ".TP\n.I " roff(tag) "\n"
    } else if (sub(/^@return +/, "", line)) {
        notes = notes ".TP\nReturns\n"
    }
    if (line != "")
        notes = notes roff(line) "\n"
}

# A prototype in lines that fit a terminal.
function prototype(text, line, k, n, part) {
    gsub(/GRAZE_API |GRAZE_CHECKED /, "", text)
    gsub(/ +/, " ", text)
    gsub(/\( /, "(", text)
    n = split(text, part, / /)
    line = ""
    for (k = 1; k <= n; k++) {
        if (length(line) + length(part[k]) > 70) {
            print ".B \"" roff(line) "\""
            line = "   "
        }
        line = line (line == "" ? "" : " ") part[k]
    }
    print ".B \"" roff(line) "\""
}

function declaration(text, n, line, k) {
    print ".PP\n.nf"
    if (text ~ /^GRAZE_API/) {
        gsub(/\n */, " ", text)
        prototype(text)
    } else {
        n = split(text, line, /\n/)
        for (k = 1; k <= n; k++)
            print roff(line[k])
    }
    print ".fi"
    if (notes != "")
        printf ".RS 4\n%s.RE\n", notes
    notes = ""
}

FNR == 1 { state = NR == 1 ? "intro" : "part" }
state == "part" {
    section(inner($0))
    if (/\*\/ *$/)
        state = ""
    next
}
state == "intro" {
    intro(inner($0))
    if (/\*\/ *$/)
        state = ""
    next
}
state == "" && /^\/\* -+/ {
    gsub(/[^a-z ]/, "")
    gsub(/^ +| +$/, "")
    print ".SH " toupper($0)
    next
}
state == "" && /^\/\*\*/ {
    state = "comment"
    notes = ""
}
state == "comment" {
    note(inner($0))
    if (/\*\/ *$/)
        state = ""
    next
}
state == "" && /^#define GRAZE_[A-Z_]+ [^_]/ && notes != "" {
    sub(/ *\\$/, "")
    declaration($0)
}
state == "" && /^(GRAZE_API|typedef)/ {
    state = "declaration"
    text = ""
    depth = 0
}
state == "declaration" {
    text = text (text == "" ? "" : "\n") $0
    depth += gsub(/{/, "{") - gsub(/}/, "}")
    if (depth == 0 && /;/) {
        declaration(text)
        state = ""
    }
}
END {
    print ".SH SEE ALSO\n.BR graze (1)\n.PP\nThe terms are defined in glossary.md, which is installed beside README.md."
}
