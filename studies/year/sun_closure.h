/* sun_closure.h - the time within a record to which the sun in a weather file belongs,
 * found from the file's radiation.
 *
 * In most files global horizontal = direct normal x sin(altitude) + diffuse horizontal
 * by construction. The sun is placed at the middle of each record plus a shift. The
 * shift of the file is the one with the least root mean square of the difference, over
 * records with direct light.
 */
#ifndef PP_STUDIES_YEAR_SUN_CLOSURE_H
#define PP_STUDIES_YEAR_SUN_CLOSURE_H

#include "formats/epw/epw.h"

enum pp_sun_closure_finding {
    PP_CLOSURE_AT_MIDDLE, /* the file's sun is at the middle of its records */
    PP_CLOSURE_SHIFTED,   /* at another time, given by best_h */
    PP_CLOSURE_SEASONAL, /* shifted in one half of the year only: summer time in the data */
    PP_CLOSURE_SWAPPED, /* the balance closes if direct and diffuse columns are
                         * swapped */
    PP_CLOSURE_NONE,    /* the balance closes at no shift: the data are measured, or
                         * damaged */
    PP_CLOSURE_UNKNOWN, /* no records with direct light and all three irradiances */
};

struct pp_sun_closure {
    enum pp_sun_closure_finding finding;
    int records;               /* number of records with direct light and all three
                                * irradiances */
    double best_h;             /* hours, -1 to 1 */
    double rms_best, rms_0;    /* W/m2 */
    double summer_h, winter_h; /* best shifts from April to September, and in the rest
                                * of the year */
};

struct pp_sun_closure pp_sun_closure_of_epw(const struct pp_epw *epw);

/* Year for the sun's positions: that of the records if all have the same year from 1950
 * to 2050, otherwise (a typical year) 2001. */
int pp_sun_closure_year(const struct pp_epw *epw);

#endif
