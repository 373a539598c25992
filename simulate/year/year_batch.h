/* year_batch.h - one randomisation of the light that reaches the points of a room by
 * reflection, for any sky and sun.
 *
 * The inside surfaces are divided into cells (year_cells.h). Paths from a point or a
 * cell end at the next inside surface that is far enough for its cell to count as
 * uniformly lit. At nearer surfaces paths continue. E is the illuminance without direct
 * sun; x are the points (receivers), c the cells:
 *
 *     E_c = D_c light + N_c s + G_c (E + s), E_x = D_x light + N_x s + G_x (E + s) (1)
 *
 *   D   from columns of light (light_columns.h) and outdoor cells, by the paths that
 *       leave through an opening
 *   s   illuminance of cells from the sun
 *   N   from sunlight on cells at which a path has continued
 *   G   from the cells at which paths end
 *
 * The solution, with V = G_x (1 - G)^-1, is
 *
 *     E_x = (D_x + V D) light + (N_x + V + V N) s                                  (2)
 *
 * D_x does not include light that comes directly from sky or open ground, through clear
 * glass, which is added in closed form. The sun is tested at one random point of each
 * cell; the points of all randomisations together fill the cell. Sunlight that panes
 * scatter is represented by groups of panes and classes of leaving light, with the mean
 * sunlight on the panes of the group. Outdoor surfaces have cells whose size grows with
 * their distance. There, the sun is tested where a path has met the surface.
 */
#ifndef PP_SIMULATE_YEAR_YEAR_BATCH_H
#define PP_SIMULATE_YEAR_YEAR_BATCH_H

#include <stdint.h>

#include "model/light/sky_patches.h"
#include "simulate/year/year_cells.h"

enum { PP_YEAR_BATCHES = 16, PP_YEAR_OUTDOOR_CELLS = 512, PP_YEAR_PANE_POINTS = 4 };

/* The task, common to all randomisations. */
struct pp_year_task {
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    const struct pp_year_cells *cells;
    const struct pp_sky_patches *patches;
    const struct pp_receiver *receivers; /* in the room's axes */
    int receiver_count;
    const int *group_of_opening; /* 0 to group_count - 1 */
    int group_count;
    int column_count; /* number of columns of light */
    int class_count;  /* greatest number of classes of light that leaves a scattering
                       * pane; 0: no such pane */
    int cell_paths;   /* from each cell; a power of two */
    int point_paths;  /* from each receiver; a power of two */
    const struct pp_sobol *sobol;
    uint64_t seed;
    /* Called between rows, by each worker with its number. If it returns false, the
     * calculation ends with PP_INTERRUPTED. */
    bool (*goes_on)(void *data, int worker);
    void *data;
};

/* One randomisation. Rows of a receiver have an entry for every group and column. */
struct pp_year_batch {
    float *light;   /* [receiver][group][column]: lx per unit of the column */
    float *outdoor; /* [receiver][group][outdoor cell]: lx per lx of sun on the cell */
    float *inside;  /* [receiver][cell]: lx per lx of sun on the inside cell */
    float *classes; /* [receiver][group][class]: lx divided by the lx of sun on the
                     * outside of the group's panes and by their BTDF (1/sr) */
    struct pp_lit_point *cell_points; /* points at which the sun is tested */
    bool *cell_has_point;
    struct pp_lit_point outdoor_points[PP_YEAR_OUTDOOR_CELLS];
    bool outdoor_is_used[PP_YEAR_OUTDOOR_CELLS];

    /* For blinds: */
    float *by_pane; /* [receiver][group]: lx due to panes with a uniform exitance of 1
                     * lm/m2 */
    float *on_pane; /* [group][column]: mean lx on the outside of panes */
    float *on_pane_outdoor;           /* [group][outdoor cell] */
    struct pp_lit_point *pane_points; /* [group][PP_YEAR_PANE_POINTS]: for the sun */
};

/* Allocates the lists of a batch, filled with zeros; the caller clears *batch, even after
 * a failure. */
enum pp_status pp_year_batch_make_space(struct pp_year_batch *batch,
                                        const struct pp_year_task *task,
                                        struct pp_error *err);

/* Calculates randomisation `index`; the caller clears *batch, even after a failure. */
enum pp_status pp_year_batch_make(struct pp_year_batch *batch,
                                  const struct pp_year_task *task, int index,
                                  int worker, struct pp_error *err);
void pp_year_batch_clear(struct pp_year_batch *batch);

#endif
