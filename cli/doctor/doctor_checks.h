/* doctor_checks.h - tests the parts that every user needs: a known daylight factor by a
 * hand method and by simulation, threads, drawings in each format, a font, and a file
 * that is written and read. */
#ifndef PP_CLI_DOCTOR_DOCTOR_CHECKS_H
#define PP_CLI_DOCTOR_DOCTOR_CHECKS_H

#include <stdbool.h>

#include "charts/sheet/canvas.h"

struct pp_doctor_check {
    const char *name;
    bool passes;
    char result[600]; /* value or path that was found; after a failure the reason */
};

enum { PP_DOCTOR_CHECK_COUNT = 8 };

/* Runs all checks. Takes about a second. */
void pp_doctor_checks_run(struct pp_doctor_check list[PP_DOCTOR_CHECK_COUNT]);

/* Draws the test page as a file in memory. *bytes belongs to *canvas, which the caller
 * destroys. */
enum pp_status pp_doctor_checks_page(struct pp_canvas **canvas,
                                     const unsigned char **bytes, size_t *length,
                                     enum pp_chart_format format, struct pp_error *err);

#endif
