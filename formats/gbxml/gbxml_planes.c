/* gbxml_planes.c - triangulation by ear clipping, best-shaped ear first. */
#include "formats/gbxml/gbxml_planes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/polygon.h"
#include "model/geometry/region.h"

/* Corners of a face in a room file may be 1 mm off its plane; 2 % less allows for
 * rounding in the file. */
static const double uneven_m = 0.98e-3;

/* Finds the greatest distance of a corner from the face's plane (m). xy: the corners in
 * that plane. */
static enum pp_status find_unevenness(double *uneven,
                                      const struct pp_gbxml_shell *shell,
                                      const struct pp_gbxml_face *face, double (*xy)[2],
                                      struct pp_error *err)
{
    struct pp_vec3 *corners = malloc((size_t)face->count * sizeof *corners);
    struct pp_polygon polygon = {.count = face->count, .vertices = corners};
    if (!corners)
        return pp_fail_memory(err);
    for (int i = 0; i < face->count; i++)
        corners[i] = shell->corners[face->corners[i]];
    pp_polygon_measure(&polygon);
    *uneven = polygon.area_m2 > 0.0 ? pp_polygon_unevenness(&polygon) : 0.0;
    struct pp_vec3 along, up;
    pp_polygon_plane_axes(polygon.normal, &along, &up);
    pp_polygon_flatten(corners, face->count, corners[0], along, up, xy);
    free(corners);
    return PP_OK;
}

/* Shape quality of the triangle of corner i and its neighbours in `left`: twice its
 * area over the square of its longest side; 0 or less if it is not an ear. */
static double ear_quality(const double (*xy)[2], const int *left, int count, int i)
{
    const int at[3] = {left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
    const double *a = xy[at[0]], *b = xy[at[1]], *c = xy[at[2]];
    double turn = pp_region_turn(a, b, c);
    double longest =
        fmax(hypot(c[0] - a[0], c[1] - a[1]),
             fmax(hypot(b[0] - a[0], b[1] - a[1]), hypot(c[0] - b[0], c[1] - b[1])));
    if (!(longest > 0.0))
        return 0.0;
    for (int k = 0; k < count && turn > 0.0; k++) {
        const double *p = xy[left[k]];
        if (left[k] == at[0] || left[k] == at[1] || left[k] == at[2])
            continue;
        if (pp_region_turn(a, b, p) >= 0.0 && pp_region_turn(b, c, p) >= 0.0
            && pp_region_turn(c, a, p) >= 0.0)
            return 0.0;
    }
    return turn / (longest * longest);
}

/* Adds the triangles of a face; *whole is true if the whole face was triangulated. */
static enum pp_status add_triangles(struct pp_gbxml_shell *shell, bool *whole,
                                    const struct pp_gbxml_face *face,
                                    const double (*xy)[2], struct pp_error *err)
{
    int count = face->count;
    int *left = malloc((size_t)count * sizeof *left);
    enum pp_status status = left ? PP_OK : pp_fail_memory(err);
    for (int i = 0; left && i < count; i++)
        left[i] = i;
    *whole = true;
    while (status == PP_OK && *whole && count >= 3) {
        int best = 0;
        double most = 0.0;
        for (int i = 0; i < count; i++) {
            double quality = ear_quality(xy, left, count, i);
            if (quality > most)
                most = quality, best = i;
        }
        *whole = most > 1e-6;
        struct pp_gbxml_face made = {.count = 3, .from = face->from};
        if (*whole)
            made.corners = malloc(3 * sizeof *made.corners);
        if (*whole && !made.corners)
            status = pp_fail_memory(err);
        if (status == PP_OK && *whole)
            status = pp_array_append(&shell->faces, shell->face_count,
                                     sizeof *shell->faces, err);
        if (status != PP_OK || !*whole) {
            free(made.corners);
            break;
        }
        for (int k = 0; k < 3; k++)
            made.corners[k] = face->corners[left[(best + count - 1 + k) % count]];
        shell->faces[shell->face_count++] = made;
        memmove(left + best, left + best + 1,
                (size_t)(count - best - 1) * sizeof *left);
        count--;
        if (count < 3)
            break;
    }
    free(left);
    return status;
}

/* Triangulates one face; a face that cannot be triangulated stays. */
static enum pp_status divide_face(struct pp_gbxml_shell *shell, int index, bool *done,
                                  const double (*xy)[2], struct pp_error *err)
{
    const int before = shell->face_count;
    struct pp_gbxml_face face = shell->faces[index];
    enum pp_status status = add_triangles(shell, done, &face, xy, err);
    if (status == PP_OK && *done) {
        shell->faces[index] = shell->faces[--shell->face_count];
        free(face.corners);
        return PP_OK;
    }
    while (shell->face_count > before)
        free(shell->faces[--shell->face_count].corners);
    return status;
}

enum pp_status pp_gbxml_planes_divide(struct pp_gbxml_shell *shell, int *divided,
                                      struct pp_error *err)
{
    const int count = shell->face_count;
    enum pp_status status = PP_OK;
    *divided = 0;
    for (int i = 0; i < count && status == PP_OK; i++) {
        double uneven = 0.0,
               (*xy)[2] = malloc((size_t)shell->faces[i].count * sizeof *xy);
        bool done = false;
        status = xy ? find_unevenness(&uneven, shell, &shell->faces[i], xy, err)
                    : pp_fail_memory(err);
        if (status == PP_OK && uneven > uneven_m && shell->faces[i].count > 3)
            status = divide_face(shell, i, &done, (const double(*)[2])xy, err);
        *divided += done;
        free(xy);
    }
    return status;
}
