/* radiosity_system.c - see radiosity_system.h. */
#include "simulate/research/radiosity/radiosity_system.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Convergence: greatest change of a radiosity, relative to the largest. */
static const double STILL = 1e-9;
/* Limit of iterations, more than any reflectance below 0.999 needs. */
enum { MOST_TURNS = 20000 };
/* Distance of the points of Gauss's 2 x 2 rule from a rectangle's centre, divided by
 * the distance of the centres of its quarters. */
static const double GAUSS = 1.1547005383792515; /* 2 / sqrt(3) */

static void clear_row(struct pp_radiosity_system_row *row)
{
    pp_light_sum_clear(&row->openings);
    pp_light_sum_clear(&row->elements);
    pp_light_sum_clear(&row->behind);
    free(row->wanted.list);
    *row = (struct pp_radiosity_system_row){.has_openings = false};
}

void pp_radiosity_system_clear(struct pp_radiosity_system *system)
{
    for (int i = 0; i < system->row_count; i++)
        clear_row(&system->rows[i]);
    free(system->rows);
    system->rows = NULL;
    system->row_count = system->row_room = 0;
}

/* ---- light of elements ---- */

static struct pp_taker taker_of(const struct pp_radiosity_system *system, int index)
{
    const struct pp_element *element = &system->tree->list[index];
    return (struct pp_taker){element->middle,
                             pp_element_tree_normal(system->tree, element->side),
                             element->side / 2};
}

/* Mean over the element of its light from the openings. Near openings, direct light
 * changes too steeply for the element's middle to represent it. With the middle alone,
 * reflected light would be too high. */
static void mean_by_openings(const struct pp_radiosity_system *system, int index,
                             struct pp_light_sum *sum)
{
    const struct pp_element_tree *tree = system->tree;
    const struct pp_element *element = &tree->list[index];
    struct pp_element_parts parts;
    pp_element_tree_cut(&parts, &tree->facets->list[element->side / 2],
                        &tree->corners[element->first_corner], element->count);
    struct pp_taker taker = taker_of(system, index);
    double way = element->count == 4 ? GAUSS : 1.0; /* in other shapes, such points
                                                     * might lie outside */
    for (int i = 0; i < parts.count; i++) {
        double area;
        struct pp_vec3 middle =
            pp_element_tree_middle(parts.corners[i], parts.counts[i], &area);
        struct pp_light_mark from = pp_light_sum_mark(sum);
        taker.point =
            pp_vec_along(element->middle, way, pp_vec_sub(middle, element->middle));
        pp_opening_light_add(system->room, &taker, &system->accuracy.openings, sum);
        struct pp_light_mark to = pp_light_sum_mark(sum);
        pp_light_sum_scale(sum, &from, &to, area / element->area_m2);
    }
}

static bool by_openings(void *data, int worker, int index)
{
    struct pp_radiosity_system *system = data;
    const struct pp_element *element = &system->tree->list[index];
    const struct pp_facet *facet = &system->tree->facets->list[element->side / 2];
    struct pp_radiosity_system_row *row = &system->rows[index];
    struct pp_taker taker = taker_of(system, index);
    (void)worker;
    if (row->has_openings || element->part_count > 0)
        return true;
    mean_by_openings(system, index, &row->openings);
    if (facet->through > 0.0) {
        struct pp_light_ray_start place = {
            taker.point, pp_vec_scale(taker.normal, -1.0), taker.facet, false};
        pp_outside_cells_hemisphere(system->room, &place, system->accuracy.directions,
                                    (unsigned)index, 1.0, PP_DF, &row->behind);
    }
    row->has_openings = true;
    return true;
}

static bool by_elements(void *data, int worker, int index)
{
    struct pp_radiosity_system *system = data;
    struct pp_radiosity_system_row *row = &system->rows[index];
    struct pp_taker taker = taker_of(system, index);
    struct pp_element_light_accuracy accuracy = system->accuracy.elements;
    (void)worker;
    pp_light_sum_clear(&row->elements);
    row->wanted.count = 0;
    if (system->tree->list[index].part_count > 0)
        return true;
    accuracy.tolerance = system->accuracy.even * row->illuminance;
    accuracy.divided = accuracy.tolerance * INFINITY;
    pp_element_light_add(system->room, &taker, &accuracy, &row->elements, &row->wanted);
    return true;
}

static enum pp_status make_rows(struct pp_radiosity_system *system,
                                struct pp_error *err)
{
    int count = system->tree->count;
    enum pp_status status = pp_array_reserve(&system->rows, &system->row_room, count,
                                             sizeof *system->rows, err);
    if (status != PP_OK)
        return status;
    for (int i = system->row_count; i < count; i++) {
        int parent = system->tree->list[i].parent;
        system->rows[i] = (struct pp_radiosity_system_row){.has_openings = false};
        if (parent >= 0 && parent < system->row_count)
            system->rows[i].illuminance = system->rows[parent].illuminance;
    }
    system->row_count = count;
    return PP_OK;
}

enum pp_status pp_radiosity_system_gather(struct pp_radiosity_system *system,
                                          struct pp_error *err)
{
    enum pp_status status = make_rows(system, err);
    if (status != PP_OK)
        return status;
    int count = system->row_count;
    pp_thread_pool_run(system->pool, 0, count, by_openings, system);
    for (int i = 0; status == PP_OK && i < count; i++) {
        struct pp_radiosity_system_row *row = &system->rows[i];
        status =
            pp_outside_cells_resolve(system->cells, system->room, &row->openings, err);
        if (status == PP_OK)
            status = pp_outside_cells_resolve(system->cells, system->room, &row->behind,
                                              err);
    }
    if (status == PP_OK)
        status =
            pp_outside_cells_gather(system->cells, system->room, system->pool, err);
    if (status != PP_OK)
        return status;
    pp_thread_pool_run(system->pool, 0, count, by_elements, system);
    for (int i = 0; i < count; i++)
        if (system->rows[i].elements.failed)
            return pp_fail_memory(err);
    return PP_OK;
}

/* ---- solving ---- */

static double radiosity_of(const struct pp_radiosity_system *system, int source)
{
    return source >= 0 ? system->tree->list[source].radiosity
                       : system->cells->list[-1 - source].radiosity;
}

/* Value of the whole sum, all components together. */
static double total(const struct pp_radiosity_system *system,
                    const struct pp_light_sum *sum)
{
    double value = 0.0;
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        value += sum->fixed[i];
    for (int i = 0; i < sum->term_count; i++)
        value += sum->terms[i].weight * radiosity_of(system, sum->terms[i].source);
    return value;
}

void pp_radiosity_system_value(const struct pp_radiosity_system *system,
                               const struct pp_light_sum *sum, bool scattered,
                               double value[PP_LIGHT_PARTS])
{
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        value[i] += sum->fixed[i];
    for (int i = 0; i < sum->term_count; i++) {
        const struct pp_light_term *term = &sum->terms[i];
        double light = radiosity_of(system, term->source);
        if (scattered && term->source >= 0) {
            const struct pp_element *element = &system->tree->list[term->source];
            value[PP_SC] += term->weight * element->sky;
            value[PP_ERC] += term->weight * element->outside;
            light -= element->sky + element->outside;
        }
        value[term->part] += term->weight * light;
    }
}

/* Solves the equation of one element; returns the change of its radiosity. */
static double turn_element(struct pp_radiosity_system *system, int index)
{
    struct pp_element *element = &system->tree->list[index];
    struct pp_radiosity_system_row *row = &system->rows[index];
    const struct pp_facet *facet = &system->tree->facets->list[element->side / 2];
    const struct pp_facet_side *side = &facet->side[element->side % 2];
    double before = element->radiosity;
    row->illuminance = total(system, &row->openings) + total(system, &row->elements);
    element->radiosity = side->exitance + side->reflectance * row->illuminance;
    if (facet->through > 0.0) {
        double behind[PP_LIGHT_PARTS] = {0.0};
        pp_radiosity_system_value(system, &row->behind, false, behind);
        element->sky = facet->through * behind[PP_SC];
        element->outside = facet->through * behind[PP_ERC];
        element->radiosity +=
            element->sky + element->outside + facet->through * behind[PP_IRC];
    }
    return fabs(element->radiosity - before);
}

void pp_radiosity_system_solve(struct pp_radiosity_system *system)
{
    double change = INFINITY, most = 0.0;
    for (int turn = 0; turn < MOST_TURNS && change > STILL * most; turn++) {
        change = most = 0.0;
        for (int i = 0; i < system->cells->count; i++) {
            struct pp_outside_cell *cell = &system->cells->list[i];
            double before = cell->radiosity;
            cell->radiosity =
                cell->exitance + cell->reflectance * total(system, &cell->taken);
            change = fmax(change, fabs(cell->radiosity - before));
        }
        for (int i = 0; i < system->tree->count; i++) {
            if (system->tree->list[i].part_count > 0)
                continue;
            change = fmax(change, turn_element(system, i));
            most = fmax(most, system->tree->list[i].radiosity);
        }
        pp_element_tree_average(system->tree);
    }
}

/* ---- dividing ---- */

enum pp_status pp_radiosity_system_divide(struct pp_radiosity_system *system,
                                          const struct pp_wanted *wanted, int *divided,
                                          struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < wanted->count; i++) {
        int index = wanted->list[i];
        if (system->tree->list[index].part_count > 0)
            continue;
        status = pp_element_tree_divide(system->tree, index, err);
        ++*divided;
    }
    return status;
}
