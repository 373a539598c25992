/* strokes.h - the straight strokes of a drawing, in millimetres on paper, read from its
 * SVG file. */
#ifndef PP_TESTS_LIB_STROKES_H
#define PP_TESTS_LIB_STROKES_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/lib/near.h"

/* A straight stroke from one point of a path to the next, or back to its start. */
struct stroke {
    double x0, y0, x1, y1;
};

struct strokes {
    struct stroke *list;
    int count;
};

/* Reads "x y" and advances; false if there is none. sscanf would determine the length
 * of the whole file each time. */
static inline bool read_pair(const char **at, double *x, double *y)
{
    char *middle, *end;
    *x = strtod(*at, &middle);
    *y = strtod(middle, &end);
    if (middle == *at || end == middle)
        return false;
    *at = end;
    return true;
}

/* Adds the strokes of the path with these data; scale and shift of its element are
 * applied. */
static inline void add_strokes(struct strokes *strokes, const char *data,
                               const double m[6], double mm_per_unit)
{
    double from[2] = {0.0, 0.0}, first[2] = {0.0, 0.0}, x = 0.0, y = 0.0;
    while (*data && *data != '"') {
        char command = *data++;
        if (command != 'M' && command != 'L' && command != 'Z')
            continue;
        if (command != 'Z' && !read_pair(&data, &x, &y))
            continue;
        double to[2] = {(m[0] * x + m[4]) * mm_per_unit,
                        (m[3] * y + m[5]) * mm_per_unit};
        if (command == 'Z')
            memcpy(to, first, sizeof to);
        if (command == 'M')
            memcpy(first, to, sizeof first);
        else {
            if ((strokes->count & (strokes->count - 1)) == 0) { /* at 0, 1, 2, 4, ... */
                size_t room = strokes->count ? 2 * (size_t)strokes->count : 1;
                strokes->list = realloc(strokes->list, room * sizeof *strokes->list);
                assert_non_null(strokes->list);
            }
            strokes->list[strokes->count++] =
                (struct stroke){from[0], from[1], to[0], to[1]};
        }
        from[0] = to[0];
        from[1] = to[1];
    }
}

/* The caller frees the list. */
static inline struct strokes strokes_of(const char *svg)
{
    struct strokes strokes = {0};
    double width_mm, view[4];
    const char *root = strstr(svg, "<svg");
    assert_int_equal(sscanf(strstr(root, "width=\""), "width=\"%lfmm", &width_mm), 1);
    assert_int_equal(sscanf(strstr(root, "viewBox=\""), "viewBox=\"%lf %lf %lf %lf",
                            &view[0], &view[1], &view[2], &view[3]),
                     4);
    for (const char *path = svg; (path = strchr(path, '<')); path++) {
        if (strncmp(path, "<path", 5) != 0)
            continue;
        size_t length = (size_t)(strchr(path, '>') - path);
        const char *data = memmem(path, length, " d=\"", 4);
        const char *matrix = memmem(path, length, "matrix(", 7);
        double m[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
        if (matrix)
            sscanf(matrix, "matrix(%lf,%lf,%lf,%lf,%lf,%lf)", m, m + 1, m + 2, m + 3,
                   m + 4, m + 5);
        if (data)
            add_strokes(&strokes, data + 4, m, width_mm / view[2]);
    }
    assert_true(strokes.count > 0);
    return strokes;
}

#endif
