# Functions that both makers of man pages use. SPDX-License-Identifier: GPL-3.0-or-later

# Text as roff prints it: every sign is the one of the keyboard, and no line is a request.
function roff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    gsub(/\^/, "\\(ha", text)
    gsub(/~/, "\\(ti", text)
    gsub(/`/, "\\(ga", text)
    gsub(/'/, "\\(aq", text)
    if (text ~ /^\./)
        text = "\\&" text
    return text
}

function head(name, section, title) {
    printf ".TH %s %s \"\" \"graze %s\" \"Graze\"\n.SH NAME\n%s \\- %s\n", roff(toupper(name)), section, version,
        roff(name), roff(title)
}

# Close the block that is open, if any, and open another: "" is running text.
function block(kind) {
    if (open == kind)
        return
    if (open == "nofill")
        print ".fi"
    if (kind == "nofill")
        print ".PP\n.nf"
    open = kind
}
