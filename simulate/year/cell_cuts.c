/* cell_cuts.c - see cell_cuts.h. */
#include "simulate/year/cell_cuts.h"

#include <math.h>

#include "model/geometry/clip.h"

static const double LEAST_RISE = 2e-3;     /* m; greater than the unevenness of faces */
static const double LEAST_PIECE = 1e-3;    /* m; pieces are not narrower */
static const double LEAST_SHARE = 0.5;     /* of the line in a piece that is covered */
static const double NEARLY_PARALLEL = 0.1; /* sine of the angle between two planes */

void pp_cell_cuts_init(struct pp_cell_cuts *cuts, struct pp_cell_point low,
                       const double step_m[2])
{
    cuts->cut_count = 0;
    cuts->piece_count = 1;
    struct pp_cell_piece *whole = &cuts->pieces[0];
    whole->count = 4;
    for (int i = 0; i < 4; i++) {
        whole->corners[i].a = low.a + (i == 1 || i == 2 ? step_m[0] : 0.0);
        whole->corners[i].b = low.b + (i >= 2 ? step_m[1] : 0.0);
    }
}

static double beyond_line(const struct pp_cell_line *line, struct pp_cell_point at)
{
    return line->normal.a * at.a + line->normal.b * at.b - line->offset_m;
}

static double along_line(const struct pp_cell_line *line, struct pp_cell_point at)
{
    return line->normal.a * at.b - line->normal.b * at.a;
}

/* The point where the edge from p to q crosses the line; false: it does not. */
static bool edge_meets_line(struct pp_cell_point *at, const struct pp_cell_line *line,
                            struct pp_cell_point p, struct pp_cell_point q)
{
    double dp = beyond_line(line, p), dq = beyond_line(line, q);
    if ((dp > 0.0) == (dq > 0.0))
        return false;
    double t = dp / (dp - dq);
    *at = (struct pp_cell_point){p.a + t * (q.a - p.a), p.b + t * (q.b - p.b)};
    return true;
}

/* Length of the line in a convex piece; 0 if it does not divide the piece. */
static double chord(const struct pp_cell_line *line, const struct pp_cell_piece *piece)
{
    double low = INFINITY, high = -INFINITY, before = 0.0, after = 0.0;
    for (int i = 0; i < piece->count; i++) {
        struct pp_cell_point p = piece->corners[i], at;
        before = fmin(before, beyond_line(line, p));
        after = fmax(after, beyond_line(line, p));
        if (!edge_meets_line(&at, line, p, piece->corners[(i + 1) % piece->count]))
            continue;
        low = fmin(low, along_line(line, at));
        high = fmax(high, along_line(line, at));
    }
    return -before > LEAST_PIECE && after > LEAST_PIECE ? fmax(0.0, high - low) : 0.0;
}

/* A convex polygon being clipped, by turns in two buffers. */
enum { CLIPPED_MOST = 256 };
struct clipped_outline {
    struct pp_vec3 vertices[2][CLIPPED_MOST];
    int now, count;
};

/* Keeps the part where normal.v > offset. */
static void clip_outline(struct clipped_outline *left, struct pp_vec3 normal,
                         double offset)
{
    left->count = pp_clip_convex(left->vertices[!left->now], left->vertices[left->now],
                                 left->count, normal, offset);
    left->now = !left->now;
}

/* One of the convex parts of a surface, where it is near to the plane; empty if it has
 * too many corners. */
static void near_part(struct clipped_outline *near, const struct pp_cell_cutter *cutter,
                      int index)
{
    const struct pp_surface *surface = cutter->surface;
    const struct pp_polygon *outline = &surface->outline;
    near->now = 0;
    near->count = surface->triangles ? 3 : outline->count;
    if (near->count + 2 + PP_CELL_CORNERS_MOST > CLIPPED_MOST)
        near->count = 0;
    for (int i = 0; i < near->count; i++) {
        int k = surface->triangles ? surface->triangles[index][i] : i;
        near->vertices[0][i] = pp_vec_sub(outline->vertices[k], cutter->centre);
    }
    double up = cutter->side ? -1.0 : 1.0;
    struct pp_vec3 normal = pp_vec_scale(cutter->plane->normal, up);
    double offset = up * cutter->plane->offset_m;
    clip_outline(near, normal, offset + LEAST_RISE);
    clip_outline(near, pp_vec_scale(normal, -1.0), -offset - cutter->near_m);
}

static int part_count(const struct pp_surface *surface)
{
    return surface->triangles ? surface->triangle_count : 1;
}

static struct pp_cell_point in_plane(const struct pp_light_part *plane,
                                     struct pp_vec3 v)
{
    return (struct pp_cell_point){pp_vec_dot(plane->a, v), pp_vec_dot(plane->b, v)};
}

/* Length along the line of the cutter's part above a piece. */
static double covered(const struct pp_cell_cutter *cutter,
                      const struct pp_cell_piece *piece)
{
    const struct pp_light_part *plane = cutter->plane;
    double low = INFINITY, high = -INFINITY;
    for (int part = 0; part < part_count(cutter->surface); part++) {
        struct clipped_outline left;
        near_part(&left, cutter, part);
        for (int i = 0; i < piece->count && left.count > 0; i++) {
            struct pp_cell_point p = piece->corners[i],
                                 q = piece->corners[(i + 1) % piece->count];
            struct pp_cell_point inwards = {p.b - q.b, q.a - p.a};
            clip_outline(&left,
                         pp_vec_add(pp_vec_scale(plane->a, inwards.a),
                                    pp_vec_scale(plane->b, inwards.b)),
                         inwards.a * p.a + inwards.b * p.b);
        }
        for (int i = 0; i < left.count; i++) {
            struct pp_cell_point at = in_plane(plane, left.vertices[left.now][i]);
            low = fmin(low, along_line(&cutter->line, at));
            high = fmax(high, along_line(&cutter->line, at));
        }
    }
    return fmax(0.0, high - low);
}

/* The part of a piece on the lower or upper side of the line. */
static void keep_side(struct pp_cell_piece *kept, const struct pp_cell_piece *piece,
                      const struct pp_cell_line *line, int upper)
{
    kept->count = 0;
    for (int i = 0; i < piece->count; i++) {
        struct pp_cell_point p = piece->corners[i], at;
        if ((beyond_line(line, p) > 0.0) == upper)
            kept->corners[kept->count++] = p;
        if (edge_meets_line(&at, line, p, piece->corners[(i + 1) % piece->count]))
            kept->corners[kept->count++] = at;
    }
}

/* Replaces a piece by two; the second becomes the last piece. */
static void divide(struct pp_cell_cuts *cuts, int piece,
                   const struct pp_cell_line *line)
{
    struct pp_cell_piece whole = cuts->pieces[piece];
    int last = cuts->piece_count++, cut = cuts->cut_count++;
    keep_side(&cuts->pieces[piece], &whole, line, 0);
    keep_side(&cuts->pieces[last], &whole, line, 1);
    for (int i = 0; i < cut; i++)
        for (int side = 0; side < 2; side++)
            if (cuts->cuts[i].sides[side] == -1 - piece)
                cuts->cuts[i].sides[side] = cut;
    cuts->cuts[cut] = (struct pp_cell_cut){*line, {-1 - piece, -1 - last}};
}

bool pp_cell_cuts_cutter_init(struct pp_cell_cutter *cutter,
                              const struct pp_light_scene *scene, int part, int side,
                              const struct pp_surface *surface, double near_m)
{
    const struct pp_light_part *plane = &scene->parts[part];
    *cutter = (struct pp_cell_cutter){.surface = surface,
                                      .plane = plane,
                                      .centre = scene->centre,
                                      .side = side,
                                      .near_m = near_m,
                                      .low = {INFINITY, INFINITY},
                                      .high = {-INFINITY, -INFINITY}};
    struct pp_vec3 normal = surface->outline.normal;
    struct pp_cell_point across = in_plane(plane, normal);
    double sine = hypot(across.a, across.b);
    if (sine < NEARLY_PARALLEL)
        return false;
    struct pp_vec3 on = pp_vec_sub(surface->outline.vertices[0], scene->centre);
    struct pp_vec3 foot = pp_vec_scale(plane->normal, plane->offset_m);
    cutter->line = (struct pp_cell_line){
        .normal = {across.a / sine, across.b / sine},
        .offset_m = pp_vec_dot(normal, pp_vec_sub(on, foot)) / sine};
    bool is_near = false;
    for (int k = 0; k < part_count(surface); k++) {
        struct clipped_outline near;
        near_part(&near, cutter, k);
        for (int i = 0; i < near.count; i++) {
            struct pp_cell_point at = in_plane(plane, near.vertices[near.now][i]);
            cutter->low.a = fmin(cutter->low.a, at.a);
            cutter->low.b = fmin(cutter->low.b, at.b);
            cutter->high.a = fmax(cutter->high.a, at.a);
            cutter->high.b = fmax(cutter->high.b, at.b);
            is_near = true;
        }
    }
    return is_near;
}

void pp_cell_cuts_by(struct pp_cell_cuts *cuts, const struct pp_cell_cutter *cutter)
{
    int count = cuts->piece_count;
    for (int i = 0; i < count && cuts->piece_count < PP_CELL_PIECES_MOST; i++) {
        double across = chord(&cutter->line, &cuts->pieces[i]);
        if (across > 0.0 && covered(cutter, &cuts->pieces[i]) >= LEAST_SHARE * across)
            divide(cuts, i, &cutter->line);
    }
}
