/* print.h - reports of rooms, as text for people, and as JSON and CSV for programs.
 *
 * All print per cent of the unobstructed horizontal illuminance, with a point whatever
 * the locale, and never "nan".
 */
#ifndef PP_CLI_PRINT_PRINT_H
#define PP_CLI_PRINT_PRINT_H

#include <stdbool.h>
#include <stdio.h>

#include "studies/study_options.h"
#include "model/results/report.h"

/* A report and what the run has to say of it. */
struct pp_result {
    struct pp_report report;
    const char *file; /* as typed; not owned */
    bool by_clock;    /* the simulation was stopped by --time, so that it can't be done
                       * again to the digit */
};

struct pp_results {
    struct pp_result *list;
    int count;
    bool several; /* as a list, even if there is only one */
    bool more_than_one_file;
    const struct pp_study_options *options; /* not owned */
};

/* As text `width` columns wide where that is possible (60 or more); utf8: with a true
 * plus-minus sign. */
enum pp_status pp_df_text(const struct pp_results *results, int width, bool utf8,
                          FILE *out, struct pp_error *err);

/* As INTERFACE has it: one object a room, an array of them if there are several. Ten
 * significant digits. */
enum pp_status pp_df_json(const struct pp_results *results, FILE *out,
                          struct pp_error *err);

/* One line a value, with a line of names at the top [RFC4180]; lines end with CR LF.
 * Ten significant digits; what there is not is empty. */
enum pp_status pp_df_csv(const struct pp_results *results, FILE *out,
                         struct pp_error *err);

/* The names of components in JSON and CSV: "sc", "erc", "irc", "df". */
extern const char *const pp_component_names[PP_COMPONENT_COUNT];

/* How the figures of the report's first point come about, method by method, one step a
 * line; nothing where no steps were asked for. */
void pp_df_steps(const struct pp_report *report, int width, bool utf8, FILE *out);

/* The room's name and its file, on a line. */
void pp_print_title(const struct pp_world *world, const char *file, FILE *out);

/* What was assumed of the room, one fact a line; the first part of the text. */
void pp_print_assumed(const struct pp_world *world, int width, FILE *out);

/* Words of text from column `column` on, wrapped at `width`; further lines are indented
 * by `indent`. Ends the line. */
void pp_print_wrapped(const char *text, int column, int indent, int width, FILE *out);

#endif
