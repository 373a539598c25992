/* rad_transform.c - see rad_transform.h. */
#include "formats/radiance/read/rad_transform.h"

#include <string.h>

#include "model/base/text.h"

struct pp_rad_transform pp_rad_transform_identity(void)
{
    return (struct pp_rad_transform){
        .rows = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, .scale = 1.0};
}

static struct pp_vec3 apply(const struct pp_rad_transform *transform, struct pp_vec3 v)
{
    return pp_vec(pp_vec_dot(transform->rows[0], v), pp_vec_dot(transform->rows[1], v),
                  pp_vec_dot(transform->rows[2], v));
}

struct pp_vec3 pp_rad_transform_point(const struct pp_rad_transform *transform,
                                      struct pp_vec3 point)
{
    return pp_vec_add(apply(transform, point), transform->move);
}

struct pp_vec3 pp_rad_transform_direction(const struct pp_rad_transform *transform,
                                          struct pp_vec3 direction)
{
    return pp_vec_scale(apply(transform, direction), 1.0 / transform->scale);
}

struct pp_rad_transform pp_rad_transform_compose(const struct pp_rad_transform *outer,
                                                 const struct pp_rad_transform *inner)
{
    struct pp_rad_transform both = {.move = pp_rad_transform_point(outer, inner->move),
                                    .scale = outer->scale * inner->scale,
                                    .mirrored = outer->mirrored != inner->mirrored};
    for (int i = 0; i < 3; i++) {
        struct pp_vec3 row = outer->rows[i];
        both.rows[i] = pp_vec_along(
            pp_vec_along(pp_vec_scale(inner->rows[0], row.x), row.y, inner->rows[1]),
            row.z, inner->rows[2]);
    }
    return both;
}

/* Rotation about an axis; exact for multiples of 90 degrees. */
static struct pp_rad_transform turning(int axis, double degrees)
{
    double quarters = degrees / 90.0, c = cos(degrees * PP_RAD),
           s = sin(degrees * PP_RAD);
    if (quarters == rint(quarters)) {
        int quarter = (int)fmod(fmod(quarters, 4.0) + 4.0, 4.0);
        c = quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0;
        s = quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0;
    }
    struct pp_rad_transform t = pp_rad_transform_identity();
    switch (axis) {
    case 'x':
        t.rows[1] = pp_vec(0.0, c, -s);
        t.rows[2] = pp_vec(0.0, s, c);
        break;
    case 'y':
        t.rows[0] = pp_vec(c, 0.0, s);
        t.rows[2] = pp_vec(-s, 0.0, c);
        break;
    default:
        t.rows[0] = pp_vec(c, -s, 0.0);
        t.rows[1] = pp_vec(s, c, 0.0);
        break;
    }
    return t;
}

int pp_rad_transform_read_option(struct pp_rad_transform *transform, char *const *words,
                                 int count)
{
    static const struct {
        const char *name;
        int numbers;
    } options[] = {{"-t", 3}, {"-rx", 1}, {"-ry", 1}, {"-rz", 1},
                   {"-s", 1}, {"-mx", 0}, {"-my", 0}, {"-mz", 0}};
    int which = 0, known = sizeof options / sizeof *options;
    while (which < known && (count == 0 || strcmp(words[0], options[which].name) != 0))
        which++;
    if (which == known)
        return 0;
    double numbers[3] = {0.0};
    for (int i = 0; i < options[which].numbers; i++)
        if (1 + i >= count || !pp_text_parse_number(words[1 + i], &numbers[i])
            || fabs(numbers[i]) > 1e9)
            return -1;
    struct pp_rad_transform step = pp_rad_transform_identity();
    const char *name = options[which].name;
    switch (name[1]) {
    case 't':
        step.move = pp_vec(numbers[0], numbers[1], numbers[2]);
        break;
    case 'r':
        step = turning(name[2], numbers[0]);
        break;
    case 's':
        if (!(numbers[0] >= 1e-9))
            return -1;
        step.scale = numbers[0];
        for (int i = 0; i < 3; i++)
            step.rows[i] = pp_vec_scale(step.rows[i], numbers[0]);
        break;
    default:
        step.mirrored = true;
        step.rows[name[2] - 'x'] = pp_vec_scale(step.rows[name[2] - 'x'], -1.0);
        break;
    }
    *transform = pp_rad_transform_compose(&step, transform);
    return 1 + options[which].numbers;
}
