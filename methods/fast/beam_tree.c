/* beam_tree.c - divides the pieces into halves along the longest extent of their
 * centres. */
#include "methods/fast/beam_tree.h"

#include <math.h>
#include <stdlib.h>

enum { LEAF = 4 };

static double middle(const struct beam_piece *piece, int axis)
{
    return axis == 0   ? piece->low.x + piece->high.x
           : axis == 1 ? piece->low.y + piece->high.y
                       : piece->low.z + piece->high.z;
}

/* Orders pieces along the axis, and ties by the index of their first corner. */
static int compare_along_axis(const struct beam_piece *a, const struct beam_piece *b,
                              int axis)
{
    double x = middle(a, axis), y = middle(b, axis);
    return x != y ? (x > y) - (x < y) : (a->first > b->first) - (a->first < b->first);
}

static int by_x(const void *a, const void *b)
{
    return compare_along_axis(a, b, 0);
}

static int by_y(const void *a, const void *b)
{
    return compare_along_axis(a, b, 1);
}

static int by_z(const void *a, const void *b)
{
    return compare_along_axis(a, b, 2);
}

static struct pp_vec3 least(struct pp_vec3 a, struct pp_vec3 b)
{
    return pp_vec(fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z));
}

static struct pp_vec3 most(struct pp_vec3 a, struct pp_vec3 b)
{
    return pp_vec(fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z));
}

/* The axis along which the centres of the pieces are spread most widely. */
static int longest_axis(const struct beam_piece *pieces, int count)
{
    int longest = 0;
    double reach = -1.0;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < count; i++) {
            low = fmin(low, middle(&pieces[i], axis));
            high = fmax(high, middle(&pieces[i], axis));
        }
        if (high - low > reach) {
            reach = high - low;
            longest = axis;
        }
    }
    return longest;
}

/* Adds the node of `count` pieces from `first` on, then the nodes below it: first the
 * half with the lower centres. */
static void add_node(struct pp_beam *beam, int first, int count)
{
    struct beam_piece *pieces = beam->outside.list + first;
    struct beam_node *node = &beam->nodes[beam->node_count++];
    *node = (struct beam_node){.low = pieces[0].low, .high = pieces[0].high};
    for (int i = 1; i < count; i++) {
        node->low = least(node->low, pieces[i].low);
        node->high = most(node->high, pieces[i].high);
    }
    if (count <= LEAF) {
        node->first = first;
        node->count = count;
    } else {
        static int (*const by[3])(const void *, const void *) = {by_x, by_y, by_z};
        qsort(pieces, (size_t)count, sizeof *pieces, by[longest_axis(pieces, count)]);
        add_node(beam, first, count / 2);
        add_node(beam, first + count / 2, count - count / 2);
    }
    node->next = beam->node_count;
}

enum pp_status pp_beam_tree_grow(struct pp_beam *beam, struct pp_error *err)
{
    if (beam->outside.count == 0)
        return PP_OK;
    /* A leaf has at least LEAF / 2 pieces, or is the only node. */
    beam->nodes = malloc((size_t)beam->outside.count * 2 * sizeof *beam->nodes);
    if (!beam->nodes)
        return pp_fail_memory(err);
    add_node(beam, 0, beam->outside.count);
    return PP_OK;
}
