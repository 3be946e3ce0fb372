/* Reports on rows and contact points, as Markdown and as JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/compare/judgement.h"

const struct quantile quantiles[QUANTILES] = {{"50", 500}, {"90", 900}, {"99", 990}, {"99.9", 999}};

static const char *const conventions[CONVENTIONS] = {"on", "any", "in", "out"};

void put_quantiles(text *out, const errors *e, int count) {
    for (int k = 0; k <= count; k++) {
        text_put(out, " ");
        ceiling_put(out, k < count ? errors_quantile(e, quantiles[k].per_mille) : e->largest);
        text_put(out, " |");
    }
}

void put_ceiling(json_writer *w, const char *name, ceiling c) {
    text *out = json_begin(w, name);
    text_put(out, "\"");
    ceiling_put(out, c);
    text_put(out, "\"");
}

void put_json_quantiles(json_writer *w, const errors *e, int count) {
    json_open(w, "quantiles", '{');
    for (int k = 0; k < count; k++)
        put_ceiling(w, quantiles[k].name, errors_quantile(e, quantiles[k].per_mille));
    json_close(w, '}');
    put_ceiling(w, "largest", e->largest);
}

void put_share(text *out, unsigned long part, unsigned long whole) {
    unsigned long long hundredths = whole ? (20000ull * part + whole) / (2ull * whole) : 0;
    text_format(out, "%llu.%02llu %%", hundredths / 100, hundredths % 100);
}

static const char *matched_by(const graze_comparison *c) {
    return c->way == MATCH_ORDER ? "order" : c->key.by_id ? "id" : "point";
}

void put_matched(text *out, const graze_comparison *c) {
    if (c->contacts)
        return;
    text_format(out, "rows matched by: %s", matched_by(c));
    if (c->drifted) {
        text_format(out, "; %lu rows have coordinates other than the golden ones, by at most ",
                    c->drifted);
        ceiling_put(out, c->drift);
    }
    text_put(out, "\n");
}

/* Append a line on the wrong rows under each convention for `on`, if the candidate never answers
 * `on`. */
static void put_conventions(text *out, const graze_comparison *c) {
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

void put_wrong_rows(text *out, const graze_comparison *c) {
    if (c->missing) {
        text_format(out, "missing: %lu of %lu rows; of the others wrong: %lu", c->missing, c->rows,
                    c->wrong);
    } else {
        text_put(out, "wrong: ");
        put_share(out, c->wrong, c->rows);
        text_put(out, " of the rows");
    }
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++)
        if (c->judged[j])
            text_format(out, "; %s %lu", column_name(j), c->column_wrong[j]);
    text_put(out, "\n");
    if (c->of_mesh)
        text_format(
            out, "on the mesh: %lu points whose golden answer is `in` or `out`, undecided here\n",
            c->apart);
    put_conventions(out, c);
}

static unsigned long depths_taken(const graze_comparison *c) {
    const errors *by = c->depth.by;
    return by[PMC_IN].rows + by[PMC_ON].rows + by[PMC_OUT].rows;
}

/* Append how many wrong rows are deeper than each part of the size. */
static void put_parts(text *out, const depths *d) {
    if (fmpq_is_zero(d->size)) {
        text_put(
            out,
            "\nNot counted by parts of the size, as the golden table has no line `# diagonal`\n");
        return;
    }
    text_put(out,
             "\nWrong rows that are for certain deeper than 1e-12, 1e-9, 1e-6, 1e-3 of the size, ");
    ceiling_put(out, ceiling_of(d->size));
    text_format(out, " (the diagonal of the box at the start): %lu, %lu, %lu, %lu\n", d->deeper[0],
                d->deeper[1], d->deeper[2], d->deeper[3]);
}

void put_depths(text *out, const graze_comparison *c) {
    if (c->depth.unmeasured)
        text_format(out, "\nDepth of the wrong rows: not measured, %s\n", c->depth.unmeasured);
    if (!depths_taken(c) || c->depth.unmeasured)
        return;
    text_format(
        out,
        "\nDepth of the wrong rows: upper bounds of |s|, s the signed distance to the exact "
        "set, of %lu of %lu of them, by the golden answer:\n\n| golden pmc | rows |",
        depths_taken(c), c->depth.wrong);
    for (int k = 0; k < DEPTH_QUANTILES; k++)
        text_format(out, " %s %% |", quantiles[k].name);
    text_put(out, " largest |\n|---|");
    for (int k = 0; k < DEPTH_QUANTILES + 2; k++)
        text_put(out, "--:|");
    for (int pmc = 0; pmc < 3; pmc++) {
        const errors *e = &c->depth.by[pmc];
        if (!e->rows)
            continue;
        text_format(out, "\n| %s | %lu |", pmc_words[pmc], e->rows);
        put_quantiles(out, e, DEPTH_QUANTILES);
    }
    text_put(out, "\n");
    put_parts(out, &c->depth);
}

static void put_json_depths(json_writer *w, const graze_comparison *c) {
    int sized = !fmpq_is_zero(c->depth.size);
    json_open(w, "depth-of-wrong-rows", '{');
    json_count(w, "wrong", c->depth.wrong);
    json_count(w, "measured", depths_taken(c));
    if (sized)
        put_ceiling(w, "size", ceiling_of(c->depth.size));
    else
        json_text(w, "size", NULL);
    json_open(w, "deeper-than", '{');
    for (int k = 0; k < DEPTH_PARTS && sized; k++)
        json_count(w, depth_parts[k], c->depth.deeper[k]);
    json_close(w, '}');
    for (int pmc = 0; pmc < 3; pmc++) {
        json_open(w, pmc_words[pmc], '{');
        json_count(w, "rows", c->depth.by[pmc].rows);
        put_json_quantiles(w, &c->depth.by[pmc], DEPTH_QUANTILES);
        json_close(w, '}');
    }
    json_close(w, '}');
}

void put_json_rows(json_writer *w, const graze_comparison *c) {
    if (!c->contacts)
        json_text(w, "matched-by", matched_by(c));
    if (c->of_mesh)
        json_count(w, "on-the-mesh", c->apart);
    if (!c->contacts && (c->way == MATCH_ORDER || c->key.by_id)) {
        json_count(w, "rows-with-other-coordinates", c->drifted);
        put_ceiling(w, "largest-difference", c->drift);
    }
    if (depths_taken(c))
        put_json_depths(w, c);
    if (!comparison_has_no_on(c))
        return;
    json_open(w, "wrong-by-convention", '{');
    for (int k = 0; k < CONVENTIONS; k++)
        json_count(w, conventions[k], c->wrong_as[k]);
    json_close(w, '}');
}

static void put_lacking(text *out, const graze_comparison *c, int whose, const char *name) {
    int any = 0;
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++) {
        if (c->lacking[j] != whose)
            continue;
        if (!any)
            text_format(out, "not judged, since the %s has no such column:", name);
        text_format(out, " %s", column_name(j));
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
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++)
        if (c->judged[j])
            text_format(out, "| %s | %lu | %lu |\n", column_name(j),
                        c->rows - c->missing - c->column_wrong[j], c->column_wrong[j]);
}

static void put_json_names(json_writer *w, const char *name, const graze_comparison *c, int whose) {
    json_open(w, name, '[');
    for (column j = COLUMN_X; j < COLUMN_OPTIONS; j++)
        if (c->lacking[j] == whose)
            json_text(w, NULL, column_name(j));
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
