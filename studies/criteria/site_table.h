/* site_table.h - the summary for a planning authority: each window's sky and each
 * room's lit area, before and after, in one table of a site. */
#ifndef PP_STUDIES_CRITERIA_SITE_TABLE_H
#define PP_STUDIES_CRITERIA_SITE_TABLE_H

#include "studies/criteria/assessment.h"

/* One line of the table. */
struct pp_site_row {
    const struct pp_assessment *room; /* not owned, nor are the other pointers */
    const struct pp_criterion *criterion;
    const struct pp_finding *finding; /* finding with the verdict */
    double existing, proposed;        /* NAN: not known; in the unit of
                                       * finding->compared, or in m2 for rights of
                                       * light */
    double ratio;                     /* proposed over existing; NAN: not known */
    double cumulative;                /* in the cumulative state; NAN: there is none */
    double cumulative_ratio;          /* cumulative over existing; NAN: not known */
    const struct pp_finding *in_cumulative; /* the finding in the cumulative state;
                                             * NULL: none */
    const struct pp_lit_change
        *lit;        /* for rights of light; NULL: not assessed, or another criterion */
    double mirrored; /* with the building's mirror image instead of the proposed parts;
                      * NAN: unknown */
    const struct pp_finding *by_mirror_image; /* finding with the verdict by the mirror
                                               * image; NULL: none */
};

/* The lines of all rooms, in the order of the rooms; new rooms are last. */
struct pp_site_table {
    bool has_cumulative;         /* true: some room has a cumulative state */
    bool has_mirror_image;       /* true: some line has a value with the mirror image */
    struct pp_site_row *windows; /* vertical sky component, one line per window */
    int window_count;
    struct pp_site_row *rooms; /* area that sees sky, one line per room */
    int room_count;
    struct pp_site_row *suns; /* share of sunlight hours, one line per window and
                               * season */
    int sun_count;
    struct pp_site_row *gardens; /* sunlit fraction of the area, one line per garden */
    int garden_count;
    struct pp_site_row *rights; /* rights of light: area adequately lit, one line per
                                 * room */
    int rights_count;
    struct pp_lit_change rights_sum; /* sum over the assessed rooms */
    struct pp_site_row *others;      /* every other finding */
    int other_count;
};

/* Makes the table from assessed rooms. The caller clears the table, even after a
 * failure. */
enum pp_status pp_site_table_of(struct pp_site_table *table,
                                const struct pp_assessment *rooms, int count,
                                struct pp_error *err);
/* Title of the table: "Sunlight hours, possible", or "..., probable" if probable hours
 * were assessed. Static. */
const char *pp_site_table_sun_title(const struct pp_site_table *table);

/* Number of rows of existing rooms; the rows of new rooms follow. */
int pp_site_table_existing(const struct pp_site_row *rows, int count);

void pp_site_table_clear(struct pp_site_table *table);

#endif
