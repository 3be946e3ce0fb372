/* Reports on rows, as Markdown and as JSON. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/report_rows.h"

#include "output/compare/judgement.h"

static const char *const conventions[CONVENTIONS] = {"on", "any", "in", "out"};

void put_share(text *out, unsigned long part, unsigned long whole) {
    unsigned long long hundredths = whole ? (20000ull * part + whole) / (2ull * whole) : 0;
    text_format(out, "%llu.%02llu %%", hundredths / 100, hundredths % 100);
}

static const char *matched_by(const graze_comparison *c) {
    return c->way == MATCH_ORDER ? "order" : c->key.by_id ? "id" : "point";
}

void put_matched(text *out, const graze_comparison *c) {
    char largest[CEILING_ROOM];
    if (c->contacts)
        return;
    text_format(out, "rows matched by: %s", matched_by(c));
    ceiling_text(largest, c->drift);
    if (c->drifted)
        text_format(out, "; %lu rows have coordinates other than the golden ones, by at most %s",
                    c->drifted, largest);
    text_put(out, "\n");
}

void put_wrong_rows(text *out, const graze_comparison *c) {
    if (c->missing) {
        text_format(out, "missing: %lu of %lu rows; of the others wrong: %lu", c->missing, c->rows,
                    c->wrong);
    } else {
        text_put(out, "wrong: ");
        put_share(out, c->wrong, c->rows);
        text_put(out, " of the rows");
    }
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            text_format(out, "; %s %lu", judged_name(k), c->column_wrong[k]);
    text_put(out, "\n");
}

void put_conventions(text *out, const graze_comparison *c) {
    if (!comparison_has_no_on(c))
        return;
    text_format(out,
                "conventions: %lu golden rows are `on`, which the candidate never answers; rows "
                "wrong with",
                c->golden_on);
    for (int k = 0; k < CONVENTIONS; k++)
        text_format(out, "%s `--on-as %s`: %lu", k ? "," : "", conventions[k], c->wrong_as[k]);
    text_put(out, "\n");
}

void put_json_rows(json_writer *w, const graze_comparison *c) {
    char largest[CEILING_ROOM];
    if (!c->contacts)
        json_text(w, "matched-by", matched_by(c));
    if (!c->contacts && (c->way == MATCH_ORDER || c->key.by_id)) {
        ceiling_text(largest, c->drift);
        json_count(w, "rows-with-other-coordinates", c->drifted);
        json_text(w, "largest-difference", largest);
    }
    if (!comparison_has_no_on(c))
        return;
    json_open(w, "wrong-by-convention", '{');
    for (int k = 0; k < CONVENTIONS; k++)
        json_count(w, conventions[k], c->wrong_as[k]);
    json_close(w, '}');
}
