/* rad_genbox.c - builds the box from polygons, cylinders and spheres.
 *
 * Option -b bevels edges, -r rounds them. Rounded edges are cylinders, and rounded
 * corners spheres. With -n N for N above 2, both are flat segments instead: N per
 * quarter turn, rounded up to a power of two. A box that faces inwards has 32 if -n is
 * missing or 1. A bevel is a rounding with one segment.
 */
#include "formats/radiance/read/rad_genbox.h"

#include <string.h>

#include "formats/radiance/read/rad_shapes.h"
#include "model/base/text.h"

enum { SEGMENTS_MOST = 256, SEGMENTS_INWARDS = 32 };

struct genbox_box {
    struct pp_rad_reader *reader;
    const struct pp_rad_pipe *pipe; /* pipeline that contains the command */
    const struct pp_rad_context *context;
    struct pp_rad_meaning material;
    double size[3];
    double inset; /* bevel width or rounding radius; 0: sharp edges */
    bool inwards;
    int segments; /* per quarter turn; 0: round */
};

/* ---- arguments ---- */

static bool read_size(const char *word, double *size)
{
    return pp_text_parse_number(word, size) && *size > 0.0 && *size <= 1e9;
}

static enum pp_status read_options(struct genbox_box *box, char *const *words,
                                   int count, struct pp_error *err)
{
    bool round = false;
    double number = 1.0;
    for (int i = 6; i < count; i++) {
        const char *word = words[i];
        bool valued = strcmp(word, "-b") == 0 || strcmp(word, "-r") == 0;
        if (strcmp(word, "-i") == 0) {
            box->inwards = true;
        } else if (strcmp(word, "-n") == 0) {
            if (++i == count || !pp_text_parse_number(words[i], &number)
                || !(number >= 1.0 && number <= SEGMENTS_MOST) || number != (int)number)
                return pp_rad_pipe_fail(
                    box->pipe, err,
                    "expected a whole number from 1 to 256 after genbox's ", word);
        } else if (valued) {
            if (++i == count || !read_size(words[i], &box->inset))
                return pp_rad_pipe_fail(box->pipe, err,
                                        "expected a size after genbox's ", word);
            round = round || word[1] == 'r';
        } else {
            return pp_rad_pipe_fail(
                box->pipe, err,
                "expected only the options -i, -b, -r and -n of genbox, not ", word);
        }
    }
    if (number == 1.0 && box->inwards)
        number = SEGMENTS_INWARDS;
    for (box->segments = 1; round && box->segments < (int)number;)
        box->segments *= 2;
    if (round && box->segments <= 2)
        box->segments = 0;
    for (int i = 0; i < 3; i++)
        if (2.0 * box->inset > box->size[i])
            return pp_rad_pipe_fail(
                box->pipe, err,
                "the bevelled or rounded edges of the genbox overlap; expected at "
                "most half of ",
                words[3 + i]);
    return PP_OK;
}

static enum pp_status read_box(struct genbox_box *box, char *const *words, int count,
                               struct pp_error *err)
{
    if (count < 6)
        return pp_rad_pipe_fail(box->pipe, err,
                                "expected genbox MATERIAL NAME and three sizes", "");
    if (!pp_rad_names_find(&box->reader->names, words[1], strlen(words[1]),
                           &box->material))
        return pp_rad_pipe_fail(box->pipe, err, "there is no material ", words[1]);
    for (int i = 0; i < 3; i++)
        if (!read_size(words[3 + i], &box->size[i]))
            return pp_rad_pipe_fail(
                box->pipe, err, "expected sizes of the genbox above 0, up to 1e9, not ",
                words[3 + i]);
    return read_options(box, words, count, err);
}

/* ---- parts of the box ---- */

/* Corner of the inner box, which is smaller by `inset` on all sides. Bit i of `corner`
 * selects the end of axis i. */
static struct pp_vec3 inner_corner(const struct genbox_box *box, int corner)
{
    double at[3];
    for (int i = 0; i < 3; i++)
        at[i] = corner >> i & 1 ? box->size[i] - box->inset : box->inset;
    return pp_vec(at[0], at[1], at[2]);
}

/* Unit vector from the corner outwards along an axis. */
static struct pp_vec3 outward(int corner, int axis)
{
    double sign = corner >> axis & 1 ? 1.0 : -1.0;
    return pp_vec(axis == 0 ? sign : 0.0, axis == 1 ? sign : 0.0,
                  axis == 2 ? sign : 0.0);
}

/* Adds a polygon whose front faces `out`, or the opposite direction in a box that faces
 * inwards; may reverse the corners. */
static enum pp_status add_flat(const struct genbox_box *box, struct pp_vec3 *corners,
                               int count, struct pp_vec3 out, struct pp_error *err)
{
    struct pp_vec3 normal = pp_vec_cross(pp_vec_sub(corners[1], corners[0]),
                                         pp_vec_sub(corners[2], corners[1]));
    if ((pp_vec_dot(normal, out) < 0.0) != box->inwards)
        for (int i = 0; i < count / 2; i++) {
            struct pp_vec3 other = corners[i];
            corners[i] = corners[count - 1 - i];
            corners[count - 1 - i] = other;
        }
    return pp_rad_shapes_add_polygon(box->reader, box->pipe->words, box->pipe->line,
                                     box->material, corners, count, box->context, err);
}

/* Adds the six sides. */
static enum pp_status add_sides(const struct genbox_box *box, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int side = 0; side < 6 && status == PP_OK; side++) {
        int axis = side / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        int first = side % 2 << axis;
        const int round[4] = {first, first | u, first | u | v, first | v};
        struct pp_vec3 corners[4], out = outward(first, axis);
        for (int i = 0; i < 4; i++)
            corners[i] = pp_vec_along(inner_corner(box, round[i]), box->inset, out);
        status = add_flat(box, corners, 4, out, err);
    }
    return status;
}

/* Direction after `step` of `segments` equal steps of a quarter turn from a to b. */
static struct pp_vec3 turned(struct pp_vec3 a, struct pp_vec3 b, int step, int segments)
{
    if (step == 0)
        return a;
    if (step == segments)
        return b;
    double angle = PP_PI / 2.0 * step / segments;
    return pp_vec_along(pp_vec_scale(a, cos(angle)), sin(angle), b);
}

/* Adds the edge that starts at a corner and runs along an axis. */
static enum pp_status add_genbox_edge(const struct genbox_box *box, int corner,
                                      int axis, struct pp_error *err)
{
    struct pp_vec3 ends[2] = {inner_corner(box, corner),
                              inner_corner(box, corner | 1 << axis)};
    if (pp_vec_length(pp_vec_sub(ends[0], ends[1])) == 0.0)
        return PP_OK;
    if (box->segments == 0) {
        struct pp_shape rod = {
            .kind = PP_SHAPE_CONE,
            .is.cone = {{ends[0], ends[1]}, {box->inset, box->inset}}};
        return pp_rad_shapes_add(box->reader, box->pipe->words, box->pipe->line,
                                 box->material, rod, box->context, err);
    }
    struct pp_vec3 a = outward(corner, (axis + 1) % 3);
    struct pp_vec3 b = outward(corner, (axis + 2) % 3);
    enum pp_status status = PP_OK;
    for (int i = 0; i < box->segments && status == PP_OK; i++) {
        struct pp_vec3 from = turned(a, b, i, box->segments);
        struct pp_vec3 to = turned(a, b, i + 1, box->segments);
        struct pp_vec3 corners[4] = {pp_vec_along(ends[0], box->inset, from),
                                     pp_vec_along(ends[1], box->inset, from),
                                     pp_vec_along(ends[1], box->inset, to),
                                     pp_vec_along(ends[0], box->inset, to)};
        status = add_flat(box, corners, 4, pp_vec_add(from, to), err);
    }
    return status;
}

/* Adds the spherical triangle between three directions from `middle` as flat triangles.
 * The triangle is divided into four at the midpoints of its sides, recursively, until
 * `segments` is 1. */
static enum pp_status add_genbox_triangle(const struct genbox_box *box,
                                          struct pp_vec3 middle,
                                          const struct pp_vec3 d[3], int segments,
                                          struct pp_error *err)
{
    if (segments == 1) {
        struct pp_vec3 corners[3];
        for (int i = 0; i < 3; i++)
            corners[i] = pp_vec_along(middle, box->inset, d[i]);
        return add_flat(box, corners, 3, pp_vec_add(pp_vec_add(d[0], d[1]), d[2]), err);
    }
    struct pp_vec3 half[3]; /* midpoint of the side before d[i] */
    for (int i = 0; i < 3; i++)
        half[i] = pp_vec_unit(pp_vec_add(d[(i + 2) % 3], d[i]));
    enum pp_status status = add_genbox_triangle(box, middle, half, segments / 2, err);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        const struct pp_vec3 at[3] = {d[i], half[(i + 1) % 3], half[i]};
        status = add_genbox_triangle(box, middle, at, segments / 2, err);
    }
    return status;
}

static enum pp_status add_genbox_corner(const struct genbox_box *box, int corner,
                                        struct pp_error *err)
{
    struct pp_vec3 middle = inner_corner(box, corner);
    if (box->segments > 0) {
        const struct pp_vec3 d[3] = {outward(corner, 0), outward(corner, 1),
                                     outward(corner, 2)};
        return add_genbox_triangle(box, middle, d, box->segments, err);
    }
    struct pp_shape ball = {.kind = PP_SHAPE_SPHERE, .is.sphere = {middle, box->inset}};
    return pp_rad_shapes_add(box->reader, box->pipe->words, box->pipe->line,
                             box->material, ball, box->context, err);
}

enum pp_status pp_rad_genbox(struct pp_rad_reader *reader,
                             const struct pp_rad_pipe *pipe,
                             const struct pp_rad_command *command,
                             const struct pp_rad_context *context, struct pp_error *err)
{
    struct genbox_box box = {.reader = reader, .pipe = pipe, .context = context};
    enum pp_status status = read_box(&box, command->words, command->count, err);
    if (status == PP_OK)
        status = add_sides(&box, err);
    for (int corner = 0; corner < 8 && box.inset > 0.0; corner++) {
        for (int axis = 0; axis < 3 && status == PP_OK; axis++)
            if (!(corner >> axis & 1))
                status = add_genbox_edge(&box, corner, axis, err);
        if (status == PP_OK)
            status = add_genbox_corner(&box, corner, err);
    }
    return status;
}
