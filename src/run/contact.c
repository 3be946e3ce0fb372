/* Writes tables of contact points. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A failure leaves the whole rows before it and no `# complete` line.
 */
#include "run/contact.h"

#include <stdio.h>
#include <stdlib.h>
#include "run/interrupt.h"
#include "run/output.h"
#include "run/progress.h"
#include "run/sites.h"

typedef struct contact_run_state {
    loaded l;
    sites in;
    int is_open, has_output;
    output out;
    mpq_t number[4];
    unsigned long rows;
} contact_run_state;

static int put_contact_head(contact_run_state *s) {
    char *head = NULL;
    graze_status status = graze_site_header(&head, s->l.context, s->l.scene, NULL, s->in.others);
    if (!status)
        output_put(&s->out, head);
    graze_free(head);
    return complain_of(status, s->l.context);
}

/* The row of the numbers at hand. */
static int put_contact_row(contact_run_state *s, graze_format format, const char *rest) {
    graze_site *site = NULL;
    char *row = NULL;
    graze_status status = (s->in.in_world ? graze_site_create_at : graze_site_create)(
        &site, s->l.context, s->l.scene, s->number[0], s->number + 1);
    if (!status)
        status = graze_site_row(&row, s->l.context, site, format, s->in.others ? rest : NULL);
    if (!status)
        output_put(&s->out, row);
    graze_free(row);
    graze_site_destroy(site);
    s->rows += !status;
    if (status == GRAZE_EINPUT || status == GRAZE_ELIMIT)
        return complain(exit_for(status, EXIT_INPUT), "%s:%lu: %s", s->in.in.name, s->in.in.line,
                        graze_context_message(s->l.context));
    return complain_of(status, s->l.context);
}

static int put_contact_rows(contact_run_state *s, const contact_options *o) {
    int status = EXIT_DONE, ended = 0;
    progress line;
    progress_start(&line, o->quiet, 0, (portion){0, 0});
    while (!status && !ended && !s->out.error) {
        text rest;
        text_init(&rest);
        status = sites_next(s->number, &rest, &ended, &s->in);
        if (!status && !ended)
            status = interrupt_signal() ? EXIT_SIGNAL
                                        : put_contact_row(s, o->format, rest.data ? rest.data : "");
        text_clear(&rest);
        progress_show(&line, s->rows, (portion){s->rows, 0});
    }
    progress_end(&line, s->rows, (portion){s->rows, 0});
    return status;
}

static int write_contacts(contact_run_state *s, const contact_options *o) {
    char last[48];
    int status = loaded_read(&s->l, &o->scene, EXIT_INPUT, NULL);
    if (status)
        return status;
    s->is_open = 1;
    status = sites_open(&s->in, s->l.context, o->contacts, graze_scene_dimension(s->l.scene));
    if (!status)
        status = output_open(&s->out, o->output);
    if (status)
        return status;
    s->has_output = 1;
    if (o->format == GRAZE_FORMAT_CSV)
        status = put_contact_head(s);
    if (!status)
        status = put_contact_rows(s, o);
    snprintf(last, sizeof last, "# complete %lu\n", s->rows);
    if (!status && o->format == GRAZE_FORMAT_CSV)
        output_put(&s->out, last);
    return status;
}

int contact_run(const contact_options *o) {
    contact_run_state *s = calloc(1, sizeof *s);
    if (!s)
        return complain(EXIT_IO, "out of memory");
    for (int k = 0; k < 4; k++)
        mpq_init(s->number[k]);
    int status = write_contacts(s, o);
    if (s->has_output) {
        int closed = output_close(&s->out);
        status = status ? status : closed;
    }
    if (s->is_open)
        sites_close(&s->in);
    for (int k = 0; k < 4; k++)
        mpq_clear(s->number[k]);
    loaded_clear(&s->l);
    free(s);
    return status;
}
