# Completion of commands, options and the words an option chooses from, all read from graze --help.
# SPDX-License-Identifier: GPL-3.0-or-later

# The help of command $2 of program $1; a list of options that goes on in the next line is one line.
_graze_help() {
    "$1" "$2" --help 2>/dev/null | sed -e ':a' -e '/,$/{N;s/,\n */, /;ba' -e '}'
}

# The words that option $3 of command $2 takes, by its help or that of the command it refers to.
_graze_words() {
    local help words other
    help=$(_graze_help "$1" "$2")
    words=$(grep -oE -- "(^  |[, [])$3 [a-z0-9]+(\|[a-z0-9]+)*( |,|$)" <<<"$help" |
        sed -e 's/.*--[a-z-]* //' -e 's/[ ,]*$//' | tr '|' '\n')
    if [ -z "$words" ]; then
        other=$(grep -E -- "(^  |, )$3[ ,]" <<<"$help" | sed -n 's/.*as in graze \([a-z]*\).*/\1/p')
        [ -n "$other" ] && [ "$other" != "$2" ] && words=$(_graze_words "$1" "$other" "$3")
    fi
    printf '%s\n' "$words"
}

_graze() {
    local program=${COMP_WORDS[0]/#\~/$HOME} word=${COMP_WORDS[COMP_CWORD]}
    local command=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD - 1]} words=
    # Bash parts --round=binary64 at the equals sign.
    if [ "$word" = = ]; then
        word=
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    if [ "$COMP_CWORD" = 1 ]; then
        words="--help "$("$program" --help 2>/dev/null | sed -n 's/^  graze \([a-z-]*\) .*/\1/p')
    elif [[ $before == --* ]]; then
        words=$(_graze_words "$program" "$command" "$before")
    elif [ "$COMP_CWORD" = 2 ] && [[ $word != -* ]]; then
        # The kinds of a command that has several.
        words=$(_graze_help "$program" "$command" | sed -n 's/^  \([a-z][a-z]*\) .*/\1/p')
    fi
    if [ -z "$words" ] && [[ $word == -* ]]; then
        # Whatever the help names outside its examples, in brackets too.
        words="--help $(_graze_help "$program" "$command" | sed '/^Example/,/^$/d' |
            grep -oE -- '(^|[ [])--?[a-z][a-z-]*' | tr -d ' [')"
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o bashdefault -o default -F _graze graze
