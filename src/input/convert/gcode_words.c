/* Words of a line of G-code.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/gcode.h"

#include <ctype.h>
#include "base/context/scope.h"
#include "base/number/rational.h"

int gcode_has(const gcode_block *b, char letter) {
    return (int)(b->present >> (letter - 'A') & 1);
}

graze_status gcode_refuse(const gcode_block *b, const char *reason) {
    return context_fail_in(b->context, GRAZE_EINPUT, b->source, b->line, "%s", reason);
}

/* Refuse a byte that begins no word. */
static graze_status refuse_byte(const gcode_block *b, int byte) {
    if (byte == '/' && !b->present)
        return gcode_refuse(b, "some machines skip a line that begins with /, others do not; "
                               "expected a program without such lines");
    if (byte && strchr("#[]O", byte))
        return gcode_refuse(b, "macros, variables and subprograms are not read; expected words "
                               "such as X1.5");
    return context_fail_in(b->context, GRAZE_EINPUT, b->source, b->line,
                           byte > 32 && byte < 127 ? "a word begins with %c; %s"
                                                   : "a word begins with byte %d; %s",
                           byte, "expected X, Y, Z, I, J, K, R, F, S, T, G, M, N or P");
}

static graze_status take_code(gcode_block *b, int *code, int *count, fmpq_t value) {
    fmpq_mul_si(value, value, 10);
    if (!fmpz_is_one(fmpq_denref(value)) || fmpq_sgn(value) < 0 || fmpq_cmp_si(value, 99999) > 0 ||
        *count == GCODE_CODES)
        return gcode_refuse(b, "a G or M word has no code, or the line over 32 of them; expected "
                               "codes such as G1 and G91.1");
    code[(*count)++] = (int)fmpz_get_si(fmpq_numref(value));
    return GRAZE_OK;
}

/* Take the word of a letter, if there is one, and its digits. Codes are never rounded. */
static graze_status end_word(gcode_block *b, char letter, text *digits) {
    graze_rounding rounding = b->context->rounding;
    int code = letter == 'G' || letter == 'M';
    if (!letter)
        return GRAZE_OK;
    if (digits->failed)
        return context_fail(b->context, GRAZE_ESYSTEM, "out of memory");
    if (!digits->length)
        return context_fail_in(b->context, GRAZE_EINPUT, b->source, b->line,
                               "%c has no number; expected one such as %c1.5", letter, letter);
    if (gcode_has(b, letter) && !code)
        return context_fail_in(b->context, GRAZE_EINPUT, b->source, b->line,
                               "%c stands twice; expected it once on a line", letter);
    b->present |= 1u << (letter - 'A');
    if (!b->first && letter != 'N')
        b->first = letter;
    fmpq *value = b->value + (letter - 'A');
    b->context->rounding = code ? GRAZE_ROUND_NONE : rounding;
    graze_status status = rational_parse(value, b->context, digits->data, digits->length);
    b->context->rounding = rounding;
    digits->length = 0;
    TRY(context_in(b->context, status, b->source, b->line));
    if (!code)
        return GRAZE_OK;
    return letter == 'G' ? take_code(b, b->g, &b->g_count, value)
                         : take_code(b, b->m, &b->m_count, value);
}

graze_status gcode_block_read(gcode_block *b, field line) {
    HELD(text, digits);
    char letter = '\0'; /* of the word that is read */
    b->present = 0;
    b->g_count = b->m_count = b->percent = 0;
    b->first = '\0';
    for (size_t i = 0; i < line.length && line.start[i] != ';'; i++) {
        int byte = toupper((unsigned char)line.start[i]);
        if (byte == ' ' || byte == '\t' || byte == '\r')
            continue;
        if (letter && byte && strchr("+-.0123456789", byte)) {
            text_bytes(&digits, line.start + i, 1);
            continue;
        }
        if (letter && !digits.length && (byte == '#' || byte == '['))
            return refuse_byte(b, byte);
        TRY(end_word(b, letter, &digits));
        letter = '\0';
        if (byte == '(') {
            const char *end = memchr(line.start + i, ')', line.length - i);
            if (!end)
                return gcode_refuse(b, "a comment does not end; expected a closing parenthesis");
            i = (size_t)(end - line.start);
        } else if (byte == '%' && !b->present) {
            b->percent = 1;
        } else if (b->percent || !byte || !strchr("FGIJKMNPRSTXYZ", byte)) {
            return refuse_byte(b, byte);
        } else {
            letter = (char)byte;
        }
    }
    return end_word(b, letter, &digits);
}
