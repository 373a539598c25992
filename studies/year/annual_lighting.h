/* annual_lighting.h - electric light saved by daylight in a simulated year, with standard
 * errors.
 *
 * Points are added by any number of threads. The results do not depend on the order of
 * the points, because the darkest point of an hour is the same in any order.
 */
#ifndef PP_STUDIES_YEAR_ANNUAL_LIGHTING_H
#define PP_STUDIES_YEAR_ANNUAL_LIGHTING_H

#include "studies/year/annual.h"

struct pp_annual_lighting;

/* Allocates the results in the sheet, whose hours must be filled. latitude_rad: for EN
 * 15193; NAN: not known. PP_BAD_INPUT if a control point does not exist. *lighting is
 * NULL if the options have no control. */
enum pp_status pp_annual_lighting_create(struct pp_annual_lighting **lighting,
                                         struct pp_annual_sheet *sheet,
                                         double latitude_rad,
                                         const struct pp_annual_options *options,
                                         int workers, struct pp_error *err);
void pp_annual_lighting_destroy(
    struct pp_annual_lighting *lighting); /* NULL: allowed */

/* Adds illuminances of point x (lx, indexed by sky), with open blinds, and with the
 * blinds of the chosen control. without: number of the batch that these means leave
 * out; -1: none. */
void pp_annual_lighting_add(struct pp_annual_lighting *lighting, int worker, int x,
                            int without, const float *open, const float *blinds);

/* Fills the results, after all points were added. */
void pp_annual_lighting_finish(struct pp_annual_lighting *lighting);

#endif
