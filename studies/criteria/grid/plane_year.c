/* plane_year.c - see plane_year.h. */
#include "studies/criteria/grid/plane_year.h"

enum { YEAR_POINTS = 400 };

static const double year_spacing_m = 0.5;

struct pp_annual_options pp_plane_year_options(const struct pp_study_options *study)
{
    struct pp_annual_options annual = pp_annual_options_lm83;
    annual.seed = study->seed;
    annual.threads = study->threads;
    annual.strict = study->strict;
    annual.watch = study->watch;
    return annual;
}

enum pp_status pp_plane_year_grid(struct pp_plane_grid *grid,
                                  const struct pp_world *world,
                                  const struct pp_grid_choice *choice, bool of_lm83,
                                  struct pp_error *err)
{
    if (choice->spacing_m > 0.0 || choice->largest)
        return pp_plane_grid_make(grid, world, NULL, choice, 0, err);
    return pp_plane_grid_at_most(grid, world, year_spacing_m,
                                 of_lm83 ? 0.0 : PP_PLANE_GRID_MARGIN_M,
                                 of_lm83 ? PP_PLANE_GRID_MOST : YEAR_POINTS, err);
}
