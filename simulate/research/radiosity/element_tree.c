/* element_tree.c - see element_tree.h. */
#include "simulate/research/radiosity/element_tree.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/clip.h"

/* Parts smaller than this fraction of an element are dropped. */
static const double NOTHING = 1e-9;

struct pp_vec3 pp_element_tree_normal(const struct pp_element_tree *tree, int side)
{
    struct pp_vec3 n = tree->facets->list[side / 2].normal;
    return side % 2 ? pp_vec_scale(n, -1.0) : n;
}

struct pp_vec3 pp_element_tree_middle(const struct pp_vec3 *corners, int count,
                                      double *area_m2)
{
    struct pp_vec3 sum = pp_vec(0.0, 0.0, 0.0);
    double area = 0.0;
    for (int i = 2; i < count; i++) {
        struct pp_vec3 e1 = pp_vec_sub(corners[i - 1], corners[0]);
        struct pp_vec3 e2 = pp_vec_sub(corners[i], corners[0]);
        double own = 0.5 * pp_vec_length(pp_vec_cross(e1, e2));
        area += own;
        sum = pp_vec_along(sum, own / 3.0, pp_vec_add(e1, e2));
    }
    if (area_m2)
        *area_m2 = area;
    return area > 0.0 ? pp_vec_along(corners[0], 1.0 / area, sum) : corners[0];
}

/* ---- cutting ---- */

static void extent_along_axis(const struct pp_vec3 *corners, int count,
                              struct pp_vec3 axis, double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (int i = 0; i < count; i++) {
        double place = pp_vec_dot(corners[i], axis);
        *low = fmin(*low, place);
        *high = fmax(*high, place);
    }
}

void pp_element_tree_cut(struct pp_element_parts *parts, const struct pp_facet *facet,
                         const struct pp_vec3 *corners, int count)
{
    double left, right, low, high, area, own;
    extent_along_axis(corners, count, facet->a, &left, &right);
    extent_along_axis(corners, count, facet->b, &low, &high);
    pp_element_tree_middle(corners, count, &area);
    bool across = PP_ELEMENT_LONG * (right - left) >= high - low;
    bool up = PP_ELEMENT_LONG * (high - low) > right - left;
    parts->count = 0;
    for (int i = 0; i < (across ? 2 : 1); i++) {
        struct pp_vec3 half[PP_FORM_FACTOR_MOST + 1];
        const struct pp_vec3 *ring = corners;
        int ring_count = count;
        double sign = i ? -1.0 : 1.0;
        if (across) {
            ring_count =
                pp_clip_convex(half, corners, count, pp_vec_scale(facet->a, -sign),
                               -sign * 0.5 * (left + right));
            ring = half;
        }
        for (int k = 0; k < (up ? 2 : 1); k++) {
            struct pp_vec3 *part = parts->corners[parts->count];
            double way = k ? -1.0 : 1.0;
            int n = ring_count;
            if (up)
                n = pp_clip_convex(part, ring, ring_count, pp_vec_scale(facet->b, -way),
                                   -way * 0.5 * (low + high));
            for (int v = 0; !up && v < n; v++)
                part[v] = ring[v];
            if (n >= 3)
                pp_element_tree_middle(part, n, &own);
            if (n >= 3 && own > NOTHING * area)
                parts->counts[parts->count++] = n;
        }
    }
}

/* ---- building ---- */

static enum pp_status append_element(struct pp_element_tree *tree, int side, int parent,
                                     const struct pp_vec3 *corners, int count,
                                     struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(&tree->list, &tree->room, tree->count + 1,
                                             sizeof *tree->list, err);
    if (status == PP_OK)
        status =
            pp_array_reserve(&tree->corners, &tree->corner_room,
                             tree->corner_count + count, sizeof *tree->corners, err);
    if (status != PP_OK)
        return status;
    struct pp_element *element = &tree->list[tree->count++];
    *element = (struct pp_element){.side = side,
                                   .first_corner = tree->corner_count,
                                   .count = count,
                                   .parent = parent,
                                   .spread = INFINITY};
    element->middle = pp_element_tree_middle(corners, count, &element->area_m2);
    for (int i = 0; i < count; i++)
        tree->corners[tree->corner_count++] = corners[i];
    return PP_OK;
}

enum pp_status pp_element_tree_divide(struct pp_element_tree *tree, int index,
                                      struct pp_error *err)
{
    struct pp_element_parts parts;
    struct pp_element element = tree->list[index];
    enum pp_status status = PP_OK;
    int first = tree->count;
    pp_element_tree_cut(&parts, &tree->facets->list[element.side / 2],
                        &tree->corners[element.first_corner], element.count);
    for (int i = 0; status == PP_OK && i < parts.count; i++) {
        status = append_element(tree, element.side, index, parts.corners[i],
                                parts.counts[i], err);
        if (status == PP_OK)
            tree->list[tree->count - 1].radiosity = element.radiosity;
    }
    if (status == PP_OK) {
        tree->list[index].first_part = first;
        tree->list[index].part_count = parts.count;
    }
    return status;
}

/* True if the part is longer than size_m, or too long for its width. */
static bool is_too_long(const struct pp_element_tree *tree, int index, double size_m)
{
    const struct pp_element *element = &tree->list[index];
    const struct pp_facet *facet = &tree->facets->list[element->side / 2];
    const struct pp_vec3 *corners = &tree->corners[element->first_corner];
    double left, right, low, high;
    extent_along_axis(corners, element->count, facet->a, &left, &right);
    extent_along_axis(corners, element->count, facet->b, &low, &high);
    double length = fmax(right - left, high - low);
    return length > size_m || length > PP_ELEMENT_LONG * fmin(right - left, high - low);
}

static bool gives(const struct pp_facet *facet, int side)
{
    return facet->side[side].indoors
           && (facet->side[side].reflectance > 0.0 || facet->side[side].exitance > 0.0
               || facet->through > 0.0);
}

static enum pp_status add_roots(struct pp_element_tree *tree, struct pp_error *err)
{
    const struct pp_facets *facets = tree->facets;
    enum pp_status status = PP_OK;
    for (int side = 0; status == PP_OK && side < 2 * facets->count; side++) {
        const struct pp_facet *facet = &facets->list[side / 2];
        tree->roots[side][0] = tree->count;
        if (!gives(facet, side % 2))
            continue;
        for (int i = 0; status == PP_OK && i < facet->piece_count; i++) {
            const struct pp_piece *piece = &facets->pieces[facet->first_piece + i];
            status =
                append_element(tree, side, -1, &facets->corners[piece->first_corner],
                               piece->count, err);
        }
        tree->roots[side][1] = tree->count - tree->roots[side][0];
    }
    return status;
}

enum pp_status pp_element_tree_create(struct pp_element_tree **result,
                                      const struct pp_facets *facets, double size_m,
                                      struct pp_error *err)
{
    *result = NULL;
    struct pp_element_tree *tree = calloc(1, sizeof *tree);
    if (!tree)
        return pp_fail_memory(err);
    tree->facets = facets;
    tree->roots = calloc((size_t)facets->count * 2 + 1, sizeof *tree->roots);
    enum pp_status status = tree->roots ? add_roots(tree, err) : pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < tree->count; i++)
        if (is_too_long(tree, i, size_m))
            status = pp_element_tree_divide(tree, i, err);
    if (status != PP_OK) {
        pp_element_tree_destroy(tree);
        return status;
    }
    *result = tree;
    return PP_OK;
}

void pp_element_tree_destroy(struct pp_element_tree *tree)
{
    if (!tree)
        return;
    free(tree->list);
    free(tree->corners);
    free(tree->roots);
    free(tree);
}

/* ---- queries ---- */

/* Distance of the point beyond the element's edge, m; 0 or less: within. */
static double beyond(const struct pp_element_tree *tree, int index,
                     struct pp_vec3 point)
{
    const struct pp_element *element = &tree->list[index];
    const struct pp_vec3 *corners = &tree->corners[element->first_corner];
    struct pp_vec3 n = tree->facets->list[element->side / 2].normal;
    double most = -INFINITY;
    for (int i = 0; i < element->count; i++) {
        struct pp_vec3 along =
            pp_vec_sub(corners[i + 1 < element->count ? i + 1 : 0], corners[i]);
        struct pp_vec3 out = pp_vec_cross(along, n);
        double length = pp_vec_length(out);
        if (length > 0.0)
            most = fmax(most, pp_vec_dot(out, pp_vec_sub(point, corners[i])) / length);
    }
    return most;
}

/* True if the point lies within all edges. */
static bool holds(const struct pp_element_tree *tree, int index, struct pp_vec3 point)
{
    const struct pp_element *element = &tree->list[index];
    const struct pp_vec3 *corners = &tree->corners[element->first_corner];
    struct pp_vec3 n = tree->facets->list[element->side / 2].normal;
    for (int i = 0; i < element->count; i++) {
        const struct pp_vec3 *next = &corners[i + 1 < element->count ? i + 1 : 0];
        struct pp_vec3 out = pp_vec_cross(pp_vec_sub(*next, corners[i]), n);
        if (pp_vec_dot(out, pp_vec_sub(point, corners[i])) > 0.0)
            return false;
    }
    return true;
}

/* Element that contains the point or, if rounding puts it outside all of them, the
 * nearest one. */
static int nearest(const struct pp_element_tree *tree, int first, int count,
                   struct pp_vec3 point)
{
    int best = first;
    double least = INFINITY;
    for (int i = first; i < first + count; i++)
        if (holds(tree, i, point))
            return i;
    for (int i = first; i < first + count; i++) {
        double off = beyond(tree, i, point);
        if (off < least) {
            least = off;
            best = i;
        }
    }
    return best;
}

int pp_element_tree_at(const struct pp_element_tree *tree, int side,
                       struct pp_vec3 point)
{
    if (tree->roots[side][1] == 0)
        return -1;
    int at = nearest(tree, tree->roots[side][0], tree->roots[side][1], point);
    while (tree->list[at].part_count > 0)
        at = nearest(tree, tree->list[at].first_part, tree->list[at].part_count, point);
    return at;
}

/* Sets the spread within each undivided part of an element to half of `spread`, the
 * difference between the parts: the middles of the part's own parts would be half as
 * far apart. */
static void spread_within(struct pp_element_tree *tree, const struct pp_element *parent,
                          double spread)
{
    for (int i = 0; i < parent->part_count; i++) {
        struct pp_element *part = &tree->list[parent->first_part + i];
        if (part->part_count == 0)
            part->spread = 0.5 * spread;
    }
}

void pp_element_tree_average(struct pp_element_tree *tree)
{
    for (int i = tree->count - 1; i >= 0; i--) {
        struct pp_element *element = &tree->list[i];
        if (element->part_count == 0) {
            if (element->parent < 0)
                element->spread = fabs(element->radiosity);
            continue;
        }
        double low = INFINITY, high = -INFINITY, beneath = 0.0;
        element->radiosity = element->sky = element->outside = 0.0;
        for (int k = 0; k < element->part_count; k++) {
            const struct pp_element *part = &tree->list[element->first_part + k];
            double share = part->area_m2 / element->area_m2;
            element->radiosity += share * part->radiosity;
            element->sky += share * part->sky;
            element->outside += share * part->outside;
            low = fmin(low, part->radiosity);
            high = fmax(high, part->radiosity);
            if (part->part_count > 0)
                beneath = fmax(beneath, part->spread);
        }
        element->spread = fmax(high - low, beneath);
        spread_within(tree, element, high - low);
    }
}
