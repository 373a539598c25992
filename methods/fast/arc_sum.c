/* arc_sum.c - divides edges that are too long for one quadrature rule, and places the
 * nodes of a rule along each part. */
#include "methods/fast/arc_sum.h"

#include <stddef.h>

#include "model/geometry/min_max.h"

/* Gauss-Legendre rules on 0 to 1: the lower half of the nodes, and their weights. */
struct arc_rule {
    int nodes;
    double node[PP_ARC_NODES / 2], weight[PP_ARC_NODES / 2];
};

static const struct arc_rule rules[] = {
    {4,
     {0.069431844202973714, 0.33000947820757187},
     {0.17392742256872692, 0.32607257743127307}},
    {6,
     {0.033765242898423986, 0.16939530676686774, 0.38069040695840155},
     {0.085662246189585178, 0.1803807865240693, 0.23395696728634552}},
    {8,
     {0.019855071751231884, 0.10166676129318664, 0.2372337950418355,
      0.40828267875217511},
     {0.050614268145188129, 0.11119051722668724, 0.15685332293894363,
      0.18134189168918099}},
};

struct arc_end {
    struct pp_vec3 v; /* vertex, as in the ring */
    struct pp_vec3 u; /* unit vector in the direction of v */
    double length;
};

struct arc_walk {
    pp_arc_potential *potential;
    const void *context;
    const struct pp_arc_spacing *spacing;
    int count;
    struct arc_end first, last;
    double sum;
};

static struct arc_end end_at(struct pp_vec3 v)
{
    double length = pp_vec_length(v);
    return (struct arc_end){v, pp_vec_scale(v, 1.0 / length), length};
}

static void add_nodes(struct arc_walk *walk, const struct arc_end *a,
                      const struct arc_end *b, double chord2,
                      const struct arc_rule *rule)
{
    struct pp_arc_nodes nodes;
    struct pp_vec3 chord = pp_vec_sub(b->u, a->u);
    nodes.count = rule->nodes;
    nodes.across = pp_vec_scale(pp_vec_cross(a->v, pp_vec_sub(b->v, a->v)),
                                1.0 / (a->length * b->length));
    for (int i = 0; i < rule->nodes; i++) {
        int k = i < rule->nodes / 2 ? i : rule->nodes - 1 - i;
        double t = i == k ? rule->node[k] : 1.0 - rule->node[k];
        double length2 = 1.0 - rule->node[k] * (1.0 - rule->node[k]) * chord2;
        nodes.u[i] = pp_vec_scale(pp_vec_along(a->u, t, chord), 1.0 / sqrt(length2));
        nodes.weight[i] = rule->weight[k] / length2;
    }
    walk->sum += walk->potential(walk->context, &nodes);
}

/* Length of an arc divided by the greatest length for which eight nodes are sufficient.
 * The bounds were chosen by trial over random windows. For a bend, |axis.u| may change
 * along one arc by twice the sum of the bend's width and the least |axis.u|. An arc
 * near the cusp may be as long as the distance between arc and cusp, plus 0.1. */
static double stretch_of(const struct pp_arc_spacing *spacing, const struct arc_end *a,
                         const struct arc_end *b, double chord)
{
    double stretch = chord / spacing->longest;
    for (int i = 0; i < spacing->bend_count; i++) {
        const struct pp_arc_bend *bend = &spacing->bends[i];
        double from = fabs(pp_vec_dot(bend->axis, a->u));
        double to = fabs(pp_vec_dot(bend->axis, b->u));
        stretch =
            pp_max(stretch, fabs(to - from) / (2.0 * (pp_min(from, to) + bend->width)));
    }
    if (spacing->cusp) {
        double near =
            pp_max(pp_vec_dot(*spacing->cusp, a->u), pp_vec_dot(*spacing->cusp, b->u));
        stretch = pp_max(stretch, chord / (sqrt(pp_max(0.0, 2.0 - 2.0 * near)) + 0.1));
    }
    return stretch;
}

enum { DEPTH_MOST = 40 };

static void add_part(struct arc_walk *walk, const struct arc_end *a,
                     const struct arc_end *b, int depth)
{
    struct pp_vec3 chord = pp_vec_sub(b->u, a->u);
    double chord2 = pp_vec_dot(chord, chord);
    double stretch = stretch_of(walk->spacing, a, b, sqrt(chord2));
    if (!(stretch > 1.0) || depth == DEPTH_MOST) {
        add_nodes(walk, a, b, chord2,
                  &rules[stretch > 0.7    ? 2
                         : stretch > 0.35 ? 1
                                          : 0]);
        return;
    }
    /* The bisector of the arc meets the edge here. */
    struct arc_end middle = end_at(pp_vec_along(
        a->v, a->length / (a->length + b->length), pp_vec_sub(b->v, a->v)));
    add_part(walk, a, &middle, depth + 1);
    add_part(walk, &middle, b, depth + 1);
}

/* Positions along an edge, from 0 at a to 1, of the point nearest to the cusp and of
 * the crossing of the cusp's meridian about the axis, where the potential has a weak
 * ridge. Returns their number; they are in ascending order. */
static int find_cuts(double cuts[2], const struct pp_arc_spacing *spacing,
                     struct pp_vec3 a, struct pp_vec3 edge)
{
    const struct pp_vec3 cusp = *spacing->cusp;
    /* Planes through the eye: one contains the cusp and is perpendicular to the edge's
     * plane, the other contains the meridian. */
    const struct pp_vec3 planes[2] = {pp_vec_cross(cusp, pp_vec_cross(a, edge)),
                                      pp_vec_cross(spacing->axis, cusp)};
    int count = 0;
    for (int i = 0; i < 2; i++) {
        double at = pp_vec_dot(planes[i], a), rise = pp_vec_dot(planes[i], edge);
        double t = -at / rise;
        if (t > 0.0 && t < 1.0)
            cuts[count++] = t;
    }
    if (count == 2 && cuts[1] < cuts[0]) {
        double swap = cuts[0];
        cuts[0] = cuts[1];
        cuts[1] = swap;
    }
    return count;
}

/* An edge with a chord shorter than this is not cut: its nodes are close enough. */
#define CUT_LEAST 0.25

static void add_arc_edge(struct arc_walk *walk, const struct arc_end *a,
                         const struct arc_end *b)
{
    double cuts[2];
    struct pp_vec3 edge = pp_vec_sub(b->v, a->v), chord = pp_vec_sub(b->u, a->u);
    bool is_cut =
        walk->spacing->cusp && pp_vec_dot(chord, chord) > CUT_LEAST * CUT_LEAST;
    int count = is_cut ? find_cuts(cuts, walk->spacing, a->v, edge) : 0;
    struct arc_end from = *a;
    for (int i = 0; i < count; i++) {
        struct arc_end to = end_at(pp_vec_along(a->v, cuts[i], edge));
        add_part(walk, &from, &to, 0);
        from = to;
    }
    add_part(walk, &from, b, 0);
}

static void add_vertex(void *data, struct pp_vec3 v)
{
    struct arc_walk *walk = data;
    struct arc_end end = end_at(v);
    if (walk->count++ == 0)
        walk->first = end;
    else
        add_arc_edge(walk, &walk->last, &end);
    walk->last = end;
}

double pp_arc_sum(pp_arc_potential *potential, const void *context,
                  const struct pp_arc_spacing *spacing, const struct pp_vec3 *vertices,
                  int count, const struct pp_vec3 *half_spaces, int half_space_count)
{
    struct arc_walk walk;
    walk.potential = potential;
    walk.context = context;
    walk.spacing = spacing;
    walk.count = 0;
    walk.sum = 0.0;
    pp_half_space_clip(vertices, count, half_spaces, half_space_count, add_vertex,
                       &walk);
    if (walk.count > 2)
        add_arc_edge(&walk, &walk.last, &walk.first);
    return walk.sum;
}
