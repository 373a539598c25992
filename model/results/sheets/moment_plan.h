/* moment_plan.h - illuminances on a working plane at one moment, as drawn.
 *
 * studies/year/moment_plan_study.h fills it. The plane is divided into equal cells, and
 * each cell into SUB x SUB parts. Skylight and reflected sunlight are calculated at the
 * centre of each cell. Direct sunlight has sharp edges and is calculated at the centre
 * of each part.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_MOMENT_PLAN_H
#define PP_MODEL_RESULTS_SHEETS_MOMENT_PLAN_H

#include "model/results/sheets/annual_sheet.h"

enum { PP_MOMENT_PLAN_SUB = 8 };

struct pp_moment_plan {
    const char *when; /* as typed; NULL: the sun is given without a time; not owned */
    struct pp_annual_sheet points; /* the room's own points, in the hour; owned */
    struct pp_annual_sheet cells;  /* centres of the cells in the plane; owned */
    struct pp_receiver *centres;   /* receivers at these centres; owned */
    int columns, rows;
    double low[2], cell_m[2]; /* lower corner of the first cell; sides of a cell */
    int *cell_at;   /* [row][column]: index in cells; -1: outside the plane; owned */
    float *diffuse; /* [part row][part column]: lx without direct sun, interpolated;
                       * NAN: outside the plane; owned */
    float *sun;     /* the same: lx of direct sun; owned */
    double sun_lx;  /* mean direct sunlight over the parts in the plane; `cells` has it
                    * only at the centres of the cells */
    double sun_share;             /* share of the plane in direct sun */
    double lowest_lx, highest_lx; /* extremes over the parts */
};

#endif
