# Sections of formats.md as the page of a file format: awk -v version=V -v name=N -v title=T -v sections="|A|B|" ...
# SPDX-License-Identifier: GPL-3.0-or-later

# Signs that a terminal may lack, and marks of Markdown.
function plain(text) {
    gsub(/⁻¹/, "^-1", text)
    gsub(/³/, "^3", text)
    gsub(/²/, "^2", text)
    gsub(/−/, "-", text)
    gsub(/·/, "*", text)
    gsub(/⋯|…/, "...", text)
    gsub(/τ/, "tau", text)
    gsub(/ş/, "s", text)
    gsub(/₁/, "1", text)
    gsub(/₂/, "2", text)
    while (match(text, /\[[^]]*\]\([^)]*\)/)) {
        link = substr(text, RSTART, RLENGTH)
        sub(/\]\(.*/, "", link)
        text = substr(text, 1, RSTART - 1) substr(link, 2) substr(text, RSTART + RLENGTH)
    }
    return text
}

BEGIN { head(name, 5, title) }

/^```/ {
    code = !code
    block(code ? "nofill" : "")
    next
}
code { print roff(plain($0)); next }
/^#/ {
    wanted = /^## / ? index(sections, "|" substr($0, 4) "|") > 0 : wanted
    block("")
    if (wanted)
        print (/^### / ? ".SS " : ".SH ") roff(plain(toupper(substr($0, /^### / ? 5 : 4))))
    next
}
!wanted { next }
/^\|[-:|]*$/ { next }
/^\|/ {
    block("nofill")
    text = plain(substr($0, 3, length($0) - 4))
    gsub(/ \| /, "\t", text)
    gsub(/`/, "", text)
    print roff(text)
    next
}
/^$/ { block(""); print ".PP"; next }
{
    block("")
    text = plain($0)
    gsub(/`/, "", text)
    if (sub(/^- /, "", text))
        print ".IP \\(bu 2"
    print roff(text)
}
