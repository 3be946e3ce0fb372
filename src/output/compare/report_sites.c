/* Contact points in reports. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/compare/compare.h"

#include "output/compare/judgement.h"
#include "output/compare/rows.h"

static void put_lacking(text *out, const graze_comparison *c, int whose, const char *name) {
    int any = 0;
    for (int k = 0; k < JUDGED_COUNT; k++) {
        if (c->lacking[k] != whose)
            continue;
        if (!any)
            text_format(out, "not judged, since the %s has no such column:", name);
        text_format(out, " %s", judged_name(k));
        any = 1;
    }
    text_put(out, any ? "\n" : "");
}

void put_sites(text *out, const graze_comparison *c) {
    text_put(out, "contact points, matched by (");
    for (size_t k = 0; k < c->key.count; k++)
        text_format(out, "%s%s", k ? ", " : "", column_name(c->key.at[k]));
    text_format(out, "); rounding: %s\n", graze_rounding_name(c->rounding));
    put_lacking(out, c, 1, "candidate");
    put_lacking(out, c, 2, "golden table");
}

void put_sites_by_column(text *out, const graze_comparison *c) {
    if (!c->contacts)
        return;
    text_put(out, "\n| column | agree | wrong |\n|---|--:|--:|\n");
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->judged[k])
            text_format(out, "| %s | %lu | %lu |\n", judged_name(k),
                        c->rows - c->missing - c->column_wrong[k], c->column_wrong[k]);
}

static void put_json_names(json_writer *w, const char *name, const graze_comparison *c, int whose) {
    json_open(w, name, '[');
    for (int k = 0; k < JUDGED_COUNT; k++)
        if (c->lacking[k] == whose)
            json_text(w, NULL, judged_name(k));
    json_close(w, ']');
}

void put_json_sites(json_writer *w, const graze_comparison *c) {
    if (!c->contacts)
        return;
    json_open(w, "matched-by", '[');
    for (size_t k = 0; k < c->key.count; k++)
        json_text(w, NULL, column_name(c->key.at[k]));
    json_close(w, ']');
    put_json_names(w, "not-in-candidate", c, 1);
    put_json_names(w, "not-in-golden", c, 2);
}
