/* pane_tables.c - makes the tables; openings for which the tables would be equal share
 * one. */
#include "methods/fast/pane_tables.h"

#include <stdlib.h>

/* A table and the first opening that uses it. */
struct glass_made {
    int opening;
    struct pp_axial_table *table;
};

struct sky_made {
    int opening;
    struct pp_sky_table *table;
};

struct pp_pane_tables {
    struct pp_axial_table *gradation;
    int glass_count, sky_count;
    struct glass_made *glasses;
    struct sky_made *skies;
    struct pp_pane_light list[]; /* one for each opening */
};

/* ---- equality ---- */

static bool same_vector(struct pp_vec3 a, struct pp_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_glass(const struct pp_glass *a, const struct pp_glass *b)
{
    return a->panes == b->panes && a->n == b->n && a->kl == b->kl
           && a->scale == b->scale && a->diffusing == b->diffusing;
}

/* True if the openings have the same orientation; their positions do not matter. */
static bool same_axes(const struct pp_opening *a, const struct pp_opening *b)
{
    return same_vector(a->along, b->along) && same_vector(a->up, b->up)
           && same_vector(a->inner.normal, b->inner.normal);
}

/* ---- the tables ---- */

static double transmittance_at(const void *glass, double c)
{
    return pp_glass_transmittance(glass, c);
}

static double gradation_at(const void *sky, double z)
{
    return pp_sky_table_gradation(sky, z);
}

static enum pp_status create_axial(struct pp_axial_table **table,
                                   pp_axial_function *function, const void *context,
                                   struct pp_error *err)
{
    *table = malloc(sizeof **table);
    if (!*table)
        return pp_fail_memory(err);
    pp_axial_table_init(*table, function, context);
    return PP_OK;
}

static enum pp_status add_glass(struct pp_pane_tables *tables,
                                const struct pp_world *world, int index,
                                struct pp_error *err)
{
    const struct pp_glass *glass = &world->openings[index].glass;
    struct glass_made *made = tables->glasses, *end = made + tables->glass_count;
    while (made < end && !same_glass(&world->openings[made->opening].glass, glass))
        made++;
    enum pp_status status = PP_OK;
    if (made == end) {
        made->opening = index;
        status = create_axial(&made->table, transmittance_at, glass, err);
        tables->glass_count += status == PP_OK;
    }
    tables->list[index].glass = made->table;
    return status;
}

static enum pp_status add_sky(struct pp_pane_tables *tables,
                              const struct pp_world *world, const struct pp_sky *sky,
                              struct pp_vec3 plane, int index, struct pp_error *err)
{
    const struct pp_opening *opening = &world->openings[index];
    struct sky_made *made = tables->skies, *end = made + tables->sky_count;
    while (made < end
           && !(same_glass(&world->openings[made->opening].glass, &opening->glass)
                && same_axes(&world->openings[made->opening], opening)))
        made++;
    enum pp_status status = PP_OK;
    if (made == end) {
        struct pp_projection axes = {.along = opening->along,
                                     .up = opening->up,
                                     .toward =
                                         pp_vec_scale(opening->inner.normal, -1.0)};
        made->opening = index;
        status =
            pp_sky_table_create(&made->table, sky, &opening->glass, &axes, plane, err);
        tables->sky_count += status == PP_OK;
    }
    tables->list[index].sky = made->table;
    return status;
}

/* Makes the tables of one opening, or shares those of an equal opening. */
static enum pp_status add_pane_table(struct pp_pane_tables *tables,
                                     const struct pp_world *world,
                                     const struct pp_sky *sky,
                                     const struct pp_vec3 *plane, int index,
                                     struct pp_error *err)
{
    const struct pp_glass *glass = &world->openings[index].glass;
    enum pp_status status = PP_OK;
    if (glass->diffusing)
        return PP_OK;
    if (glass->panes > 0)
        status = add_glass(tables, world, index, err);
    if (status != PP_OK || sky->kind != PP_SKY_ISO)
        return status;
    if (glass->panes == 0 && !pp_sky_has_azimuth(sky)) {
        if (!tables->gradation)
            status = create_axial(&tables->gradation, gradation_at, sky, err);
        tables->list[index].gradation = tables->gradation;
        return status;
    }
    return plane ? add_sky(tables, world, sky, *plane, index, err) : PP_OK;
}

enum pp_status pp_pane_tables_create(struct pp_pane_tables **tables,
                                     const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_vec3 *plane, struct pp_error *err)
{
    size_t count = (size_t)world->opening_count;
    struct pp_pane_tables *made = calloc(1, sizeof *made + count * sizeof *made->list);
    if (!made)
        return pp_fail_memory(err);
    made->glasses = malloc((count + 1) * sizeof *made->glasses);
    made->skies = malloc((count + 1) * sizeof *made->skies);
    enum pp_status status = made->glasses && made->skies ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        status = add_pane_table(made, world, &light->sky, plane, i, err);
    if (status != PP_OK)
        pp_pane_tables_destroy(made);
    else
        *tables = made;
    return status;
}

void pp_pane_tables_destroy(struct pp_pane_tables *tables)
{
    if (!tables)
        return;
    for (int i = 0; i < tables->glass_count; i++)
        free(tables->glasses[i].table);
    for (int i = 0; i < tables->sky_count; i++)
        pp_sky_table_destroy(tables->skies[i].table);
    free(tables->glasses);
    free(tables->skies);
    free(tables->gradation);
    free(tables);
}

const struct pp_pane_light *pp_pane_tables_at(const struct pp_pane_tables *tables,
                                              int opening)
{
    return &tables->list[opening];
}
